#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make the tables of doc/accuracy.md anew, between the comments that name them: what Model = auto chooses; what
Accuracy demanded, what it reached, and what it cost beside the cheapest configuration picked by hand, from the
charts in doc/charts (made by doc/charts.sh); other cases.

  doc/accuracy.py [PROGRAM]      default: build/bin/frictionbeam
"""
import csv
import json
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
LABEL = "left to the program, Accuracy"


def milliseconds(seconds):
    return f"{1e3 * seconds:.3g} ms"


PROGRAM = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, "..", "build", "bin", "frictionbeam")
# Slabs of doc/continuum.md: height, nu, plane, slip_length, N_2, N_4, N_6, u_0_mean
SLABS = [(1, 0, "stress", 3.29584, 6, 0.9190357, 0.07116740, 0.02499831),
         (1, 0.3, "stress", 2.29611, 6, 3.234536, 2.582587, 0.01449771),
         (1, 0.3, "strain", 1.85267, 6.085039, 4.392078, 3.673541, 0.009939663),
         (0.5, 0.3, "stress", 3.14730, 6, 1.634713, 1.484014, 0.03725001),
         (0.5, 0.3, "strain", 2.93301, 6, 2.220252, 2.119531, 0.02992786),
         (0.25, 0.3, "stress", 3.57365, 6, 0.8173845, 0.7499720, 0.08462500),
         (0.25, 0.3, "strain", 3.46651, 6, 1.110167, 1.071388, 0.07268393)]


def run(case, accuracy, *settings):
    """What summary.json says of a case of prm/verification that is run with an Accuracy."""
    with tempfile.TemporaryDirectory() as folder:
        words = [PROGRAM, os.path.join(HERE, "..", "prm", "verification", case + ".prm"),
                 "--output-directory", folder]
        for setting in ("Accuracy = " + accuracy, "Output/VTU = false", "Output/Report = false", *settings):
            words += ["--set", setting]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "summary.json")) as file:
            return json.load(file)


def models():
    """Table of what Model = auto chooses, its estimate and the true errors of line and continuum."""
    text = ("| height | nu | plane | Accuracy | solved as | estimate for the line | true error |\n"
            "| --- | --- | --- | --- | --- | --- | --- |\n")
    for height, nu, plane, *values in SLABS:
        for accuracy in ("0.45", "0.2", "0.1"):
            summary = run("slab_continuum", accuracy, "Model = auto", f"Slab/Height = {height}",
                          f"Slab/Poisson = {nu}", f"Slab/Plane = {plane}")
            found = {q["name"]: q["value"] for q in summary["quantities"]}
            names = ("slip_length", "N_2", "N_4", "N_6", "u_0_mean")
            error = max(abs(found[name] - value) / max(abs(value), 0.01 * 6 if name[0] == "N" else 0)
                        for name, value in zip(names, values))
            account = summary["accuracy"]
            text += (f"| {height} | {nu} | {plane if nu else 'either'} | {accuracy} | {account['model']} | "
                     f"{account['line_error']:.2g} | {error:.2g}{' **missed**' if error > float(accuracy) else ''} |\n")
    return text


# Cases of prm/verification whose references are exact or converged, and how far they are taken
OTHERS = {"belt": 3, "oscillator_rigid": 2, "two_masses": 3, "lift_off": 3, "roll_up": 3, "elastica": 3,
          "elastica_stop": 3, "follower": 3, "impacting_bar": 1, "pipe_whip": 2}


def other_cases():
    """Table of demanded, estimated and true errors of these cases, and how many exceed what was demanded."""
    text = ("| case | demanded | estimate | true error | runs | time |\n| --- | --- | --- | --- | --- | --- |\n")
    exceeded = 0
    for case, n_levels in OTHERS.items():
        for accuracy in ("1e-2", "1e-3", "1e-4")[:n_levels]:
            summary = run(case, accuracy)
            error = max(q["error"] for q in summary["quantities"] if q["error"] is not None)
            account = summary["accuracy"]
            missed = error > float(accuracy)
            exceeded += missed
            text += (f"| {case} | {accuracy} | {account['estimate']:.2g} | {error:.2g}"
                     f"{' **missed**' if missed else ''} | {len(account['runs'])} | "
                     f"{milliseconds(sum(run['seconds'] for run in account['runs']))} |\n")
    return text, exceeded


ZONES = {"slab": ("slip_length",), "long_bar_zones": ("open_length", "slip_end")}


def ratio_without_zones(name, rows, accuracy_row):
    """Cost over that of the cheapest pick if the ends of the zones did not count."""
    def error(row):
        return max(abs(float(row[q[:-10]]) / float(row[q]) - 1) for q in row
                   if q.endswith("_reference") and q[:-10] not in ZONES[name] and row[q])
    times = [float(r["seconds_median"]) for r in rows if r["curve"] != LABEL and not r["problem"]
             and not r["curve"].startswith("GetFEM") and error(r) <= float(accuracy_row["setting"])]
    return float(accuracy_row["seconds_median"]) / min(times)


lines = ["| case | demanded | true error | time | cheapest picked by hand | its time | ratio |",
         "| --- | --- | --- | --- | --- | --- | --- |"]
worst, missed, within, n = 0.0, 0, 0, 0
without = {name: [] for name in ZONES}
for name in ("slab", "slab_line", "long_bar_zones", "oscillator", "rack", "hovgaard"):
    path = os.path.join(HERE, "charts", name + ".csv")
    if not os.path.exists(path):
        continue
    with open(path) as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        if row["curve"] != LABEL:
            continue
        n += 1
        demanded = float(row["setting"])
        if row["problem"]:
            missed += 1
            lines.append(f"| {name} | {demanded:g} | {row['problem']} | | | | |")
            continue
        error, time = float(row["error"]), float(row["seconds_median"])
        missed += error > demanded
        if name in ZONES:
            without[name].append(f"{ratio_without_zones(name, rows, row):.2g}")
        others = [r for r in rows if r["curve"] != LABEL and not r["problem"]
                  and not r["curve"].startswith("GetFEM") and float(r["error"]) <= demanded]
        if others:
            best = min(others, key=lambda r: float(r["seconds_median"]))
            ratio = time / float(best["seconds_median"])
            worst = max(worst, ratio)
            within += ratio <= 3
            tail = f"{best['curve']} {best['setting']} | {milliseconds(float(best['seconds_median']))} | {ratio:.2g}"
        else:
            tail = "none on the chart | | "
        lines.append(f"| {name} | {demanded:g} | {error:.2g}{' **missed**' if error > demanded else ''} | "
                     f"{milliseconds(time)} | {tail} |")

other_lines, exceeded = other_cases()
tables = {
    "models": models(),
    "charts": f"""{n - missed} of {n} within what was demanded; {within} of {n} at no more than three times the cost, the worst at
{worst:.2g} times.

""" + "\n".join(lines) + f"""

If the ends of the zones did not count, the cost would be {", ".join(without["slab"])} times that of the picks on the slab,
{", ".join(without["long_bar_zones"])} times on the long bar, at 1e-2, 1e-3, 1e-4.
""",
    "others": other_lines + f"""
{sum(OTHERS.values()) - exceeded} of {sum(OTHERS.values())} within what was demanded.
"""}
path = os.path.join(HERE, "accuracy.md")
with open(path) as page:
    text = page.read()
for name, table in tables.items():
    text, n_found = re.subn(f"(<!-- {name} -->\n).*?(<!-- end -->)", lambda m: m[1] + table + m[2], text, flags=re.S)
    assert n_found == 1, f"doc/accuracy.md has no place for {name}"
with open(path, "w") as page:
    page.write(text)
