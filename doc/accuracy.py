#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write doc/accuracy.md from the charts in doc/charts (made by doc/charts.sh): what Accuracy demanded, what
it reached, and what it cost beside the cheapest configuration picked by hand; and what Model = auto chooses.

  doc/accuracy.py [PROGRAM]      default: build/bin/frictionbeam
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
LABEL = "left to the program, Accuracy"


def milliseconds(seconds):
    return f"{1e3 * seconds:.3g} ms"


PROGRAM = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, "..", "build", "bin", "frictionbeam")
# Slabs of doc/continuum.md: height, nu, plane, N_2, N_4, N_6, u_0_mean
SLABS = [(1, 0, "stress", 6, 0.9190357, 0.07116740, 0.02499831),
         (1, 0.3, "stress", 6, 3.234536, 2.582587, 0.01449771),
         (1, 0.3, "strain", 6.085039, 4.392078, 3.673541, 0.009939663),
         (0.5, 0.3, "stress", 6, 1.634713, 1.484014, 0.03725001),
         (0.5, 0.3, "strain", 6, 2.220252, 2.119531, 0.02992786),
         (0.25, 0.3, "stress", 6, 0.8173845, 0.7499720, 0.08462500),
         (0.25, 0.3, "strain", 6, 1.110167, 1.071388, 0.07268393)]


def models():
    """Table of what Model = auto chooses, its estimate and the true errors of line and continuum."""
    text = ("| height | nu | plane | Accuracy | solved as | estimate for the line | true error |\n"
            "| --- | --- | --- | --- | --- | --- | --- |\n")
    for height, nu, plane, *values in SLABS:
        for accuracy in ("0.45", "0.2", "0.1"):
            settings = ["Model = auto", "Accuracy = " + accuracy, f"Slab/Height = {height}",
                        f"Slab/Poisson = {nu}", f"Slab/Plane = {plane}", "Output/VTU = false",
                        "Output/Report = false"]
            with tempfile.TemporaryDirectory() as folder:
                words = [PROGRAM, os.path.join(HERE, "..", "prm", "verification", "slab_continuum.prm"),
                         "--output-directory", folder]
                for setting in settings:
                    words += ["--set", setting]
                subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
                with open(os.path.join(folder, "summary.json")) as file:
                    summary = json.load(file)
            found = {q["name"]: q["value"] for q in summary["quantities"]}
            names = ("N_2", "N_4", "N_6", "u_0_mean")
            error = max(abs(found[name] - value) / max(abs(value), 0.01 * 6 if name[0] == "N" else 0)
                        for name, value in zip(names, values))
            account = summary["accuracy"]
            text += (f"| {height} | {nu} | {plane if nu else 'either'} | {accuracy} | {account['model']} | "
                     f"{account['line_error']:.2g} | {error:.2g}{' **missed**' if error > float(accuracy) else ''} |\n")
    return text


lines = ["| case | demanded | true error | time | cheapest picked by hand | its time | ratio |",
         "| --- | --- | --- | --- | --- | --- | --- |"]
worst, missed, within, n = 0.0, 0, 0, 0
for name in ("slab", "slab_line", "long_bar", "oscillator", "rack", "hovgaard"):
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

with open(os.path.join(HERE, "accuracy.md"), "w") as page:
    page.write(f"""# Accuracy

`set Accuracy = 1e-3` lets the program choose the increments of static steps, the time step, the length of
cells where something is spread over them, the supports and elements of generated scenes, bends as exact
arcs, and of a continuum first mesh, degree and refinement: as coarse as its estimates allow. It solves
coarse levels first, reads the order of convergence of each quantity from its differences, goes straight to
the level that the estimates ask for, and checks that one by its difference to the one before. A continuum is
refined adaptively until the errors are estimated to be small enough ([continuum.md](continuum.md)), on
elements of degree 2, of degree 3 where less than 1e-3 is demanded: of what was tried on the long bar and on
six slabs (degrees 2 and 3 from two cells over the height, 3 and 4 from one) that is the cheapest whose true
error stayed below the demanded one in all of them.
`summary.json` and the report say what was chosen, the estimated error, what was left out and what every run
cost.

**`Model = auto`** takes the line if it suffices. The slab, the only scene that is a line and a continuum, is
solved as a line with the Poisson squeeze, once with and once without the shear lag, the last correction that
a line can have. What the lag changes is taken for the error of the line with it: what is left beyond it is
less than two thirds of that in every case of the table below. If it is above 70 % of
`Accuracy`, the continuum is solved instead; if not, the rest is left for the number of elements. Which was
chosen, the estimate, and quantities that only the other model has (slip_length, u_0) are in the answer. A
scene that has no line (long bar, body) is solved as a continuum, one that has no continuum as a line, and
what beams leave out of a pipe is not estimated.

{models()}
The true errors, and the cost of all runs together beside that of the cheapest single configuration on the
charts (doc/charts): {n - missed} of {n} within what was demanded; {within} of {n} at no more than three times
the cost, the worst at {worst:.2g} times. Made by `doc/accuracy.py` from the figures of the charts.

""" + "\n".join(lines) + """

Beside what the charts count, the program answers for all quantities of the scene (the ends of the zones of
slab and long bar are known last), and it does not know beforehand which mesh will happen to do: the cheapest
picked by hand was picked after its error was known.

What it does not do: choose the number of cells in a mesh of the user's own. An estimate from differences can
be deceived by chance agreement; a difference is therefore taken for no less than an eighth of the one before,
level by level (of a continuum, a sixteenth, mesh by mesh). Only what a refinement touches can change: an
adaptive run from a mesh too coarse (one cell over the height, degree 3) missed N_6 of the slab with nu = 0 by
1.2e-3 with an estimate below 1e-4; from two cells over the height, as chosen, by 7e-5.
""")
