# SPDX-License-Identifier: LGPL-2.1-or-later
"""doc/stability.md and its picture, from the results of the groups."""
import json
import math
import os
import statistics
import subprocess
import textwrap

METHODS = ("exact", "newton", "elastic")
MOST_NAMES = {"exact": 300, "newton": 12, "elastic": 12}  # of cases in one line of failures

HEAD = """# Stability and speed

Which method solves which line, in how many iterations and seconds. This page is written by
`prm/benchmark/stability.py`, which runs the cases; `--only` runs one group of them anew.

The methods are those of `Solver/Method`. `exact` takes contacts as they are, rigid where the
parameter file has no stiffness; `newton` and `elastic` need one and take 1e9 N there. `exact` has
solved a case if every step converged with certificates (equilibrium, relative to the largest force;
contact laws, each contact on its own scale) of at most 1e-8; the others if every step converged to
their own tolerance, an equilibrium residual of 1e-10 or of rounding. Iterations and seconds are those
of solved cases, seconds those of setup and solution, without the mesh. A method that denies an
equilibrium where there is one is wrong; every line here has one, being anchored, and so has the slab
unless it is pushed harder than friction can hold.
"""

TEXTS = {
    "slab": ("The slab, cycled", """`prm/benchmark/slab_cycle.prm`: pushed, pulled and pushed again in
36 increments each, for friction elements from 1e0 N to 1e15 N and rigid ones. Solved means, besides,
that the displacement of the pushed end is the exact one to 1e-8 of its largest value, at every
increment. With F = 30 N there is no equilibrium, and the answer wanted is to say so."""),
    "rack": ("Racks", """`prm/benchmark/rack_family.prm`: two families, n = 20 to 4000, without guides and
with one at every third support; each cell of the table stands for f = 0.1, 0.3, 0.6, 1, 2."""),
    "chatter": ("Chatter", """`prm/benchmark/chatter_*.prm`: short lines whose contacts open and close, each
as it stands and with other friction coefficients: a load that travels from rest to rest, gaps that
close together, nearly zero normal force, and inclined supports with friction far above the limit of
uniqueness."""),
    "random": ("Random lines", """`prm/benchmark/random_line.prm`: every seed is another line. `newton` and
`elastic` are run on the first ones only."""),
}


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def prose(text):
    return textwrap.fill(" ".join(text.split()), 102, break_on_hyphens=False) + "\n"


def figure(value):
    """Three digits, plain where that is short."""
    if value is None:
        return ""
    return f"{value:.3g}" if value == 0 or 1e-4 <= abs(value) < 1e5 else f"{value:.1e}"


def median_and_largest(records, name):
    values = [record[name] for record in records if name in record]
    return f"{figure(statistics.median(values))}, {figure(max(values))}" if values else ""


def summary_table(records):
    rows = []
    for method in METHODS:
        mine = [record for record in records if record["method"] == method]
        if not mine:
            continue
        solved = [record for record in mine if record["outcome"] == "solved"]
        n_not_run = sum(record["outcome"] == "not run" for record in mine)
        certificates = [record["certificate"] for record in solved]
        rows.append([f"`{method}`", f"{len(solved)} of {len(mine)}", str(n_not_run or ""),
                     str(sum(record["outcome"] == "no equilibrium" for record in mine) or ""),
                     figure(max(certificates, default=None)),
                     median_and_largest(solved, "iterations"),
                     median_and_largest(solved, "seconds")])
    return table(["method", "solved", "not run", "denies an equilibrium", "largest certificate",
                  "iterations: median, most", "seconds: median, most"], rows)


def distinct(values):
    return list(dict.fromkeys(values))


def matrix(records):
    """Cases solved, a row and a column for each label that the cases carry."""
    if not any(record["row"] for record in records):
        return ""
    rows = []
    columns = distinct(record["column"] for record in records)
    for row in distinct(record["row"] for record in records):
        cells = []
        for column in columns:
            here = [r for r in records if (r["row"], r["column"]) == (row, column)]
            n_solved = [sum(r["outcome"] == "solved" for r in here if r["method"] == method)
                        for method in METHODS]
            cells.append(" / ".join(map(str, n_solved)) if here else "")
        rows.append([row] + cells)
    n_cell = max(sum((r["row"], r["column"], r["method"]) == (rows[0][0], columns[0], "exact")
                     for r in records), 1)
    return (f"\nSolved by `exact` / `newton` / `elastic`, of {n_cell} in each cell:\n\n" +
            table([""] + columns, rows))


def failures(records, method):
    """What went wrong and in which cases, a line for each reason."""
    reasons = {}
    for record in records:
        if record["method"] != method or record["outcome"] in ("solved", "not run"):
            continue
        step, _, reason = record["where"].rpartition(": ")
        if record["outcome"] == "no equilibrium":
            reason = "says that there is no equilibrium"
        name = record["case"] + (f" ({step})" if step.startswith("step ") else "")
        if "error" in record:
            name += f" ({figure(record['error'])})"
        reasons.setdefault(reason, []).append(name)
    lines = []
    for reason, names in sorted(reasons.items(), key=lambda item: -len(item[1])):
        most = MOST_NAMES[method]
        more = f"; and {len(names) - most} more" if len(names) > most else ""
        lines.append(f"- {reason} ({len(names)}): " + "; ".join(names[:most]) + more)
    return lines


def provenance(result):
    limits = result["limits"]
    return prose(f"{result['date']}, {result['machine']}, {result['program']}, commit "
                 f"{result['commit']}; {result['jobs']} at a time, {result['minutes']:.0f} minutes; "
                 f"runs ended after {limits['exact']:g} s (`exact`), {limits['others']:g} s (the "
                 "others)." + again(result))


def again(result):
    """Which runs are newer than the rest, in a sentence."""
    if "again" not in result:
        return ""
    return (f" {result['again']['runs']} runs of `exact`, which had no answer before, are those of "
            f"commit {result['again']['commit']}.")


def group_section(name, result):
    title, text = TEXTS[name]
    records = result["records"]
    parts = [f"## {title}\n", prose(text), provenance(result), summary_table(records),
             matrix(records)]
    for method in METHODS:
        lines = failures(records, method)
        if lines:
            parts.append(f"`{method}` has no answer, or a wrong one:\n")
            parts.append("\n".join(lines) + "\n")
    return "\n".join(part for part in parts if part)


def exponent(points):
    """Slope of the least-squares line through log n, log seconds."""
    x = [math.log(n) for n, _ in points]
    y = [math.log(seconds) for _, seconds in points]
    x_mean, y_mean = statistics.mean(x), statistics.mean(y)
    return (sum((a - x_mean) * (b - y_mean) for a, b in zip(x, y)) /
            sum((a - x_mean)**2 for a in x))


def speed_section(result):
    bounds = {("plant", 400): 0.1, ("plant", 4000): 1., ("planar", 400): 0.3}
    rows, notes, points = [], [], {}
    for r in result["records"]:
        bound = bounds.get((r["kind"], r["n"]))
        good = r["outcome"] == "solved"
        rows.append([r["kind"], str(r["friction"]), str(r["n"]), figure(r.get("seconds")),
                     figure(bound), str(r.get("iterations", "")), figure(r.get("certificate")),
                     "" if good else r["where"]])
        if good:
            points.setdefault((r["kind"], r["friction"]), []).append((r["n"], r["seconds"]))
    for (kind, friction), series in points.items():
        if len(series) > 1:
            local = max(exponent(pair) for pair in zip(series, series[1:]))
            notes.append(f"- {kind}, f = {friction}: seconds grow with the length to the power "
                         f"{exponent(series):.2f} from n = {series[0][0]} to {series[-1][0]}, "
                         f"{local:.2f} at most from one length to the next; 1.1 is wanted")
    return "\n".join(["## Speed\n", "Racks in one step, setup and solution without the mesh, median "
                      "of 3 to 5 runs, one at a time.\n", provenance(result),
                      table(["rack", "f", "n", "seconds", "wanted", "iterations", "certificate",
                             ""], rows), "\n".join(notes) + "\n"])


def siconos_section(result):
    rows, best_ratios = [], []
    for case in result["records"]:
        label = f"{case['kind']} {case['n']}, f = {case['friction']}"
        solved = {title: answer for title, answer in case["siconos"].items()
                  if answer["outcome"] == "solved"}
        best = min(solved, key=lambda title: solved[title]["seconds"], default=None)
        if case["ours"]["outcome"] == "solved":
            ratio = figure(solved[best]["ratio"]) if best else "none of theirs solves it"
        else:
            ratio = "ours does not solve it"
        best_ratios.append(f"- {label}: {ratio}" + (f" ({best})" if best else ""))
        for title, answer in [("FrictionBeam", case["ours"])] + list(case["siconos"].items()):
            rows.append([label, title, answer["outcome"]] +
                        [figure(answer.get(name)) for name in
                         ("seconds", "iterations", "scaled", "own", "apart")])
    return "\n".join([
        "## Beside Siconos\n", prose(f"""`prm/benchmark/against_siconos.py`, {result['date']}: three solvers of
Siconos {result['version']} on the same racks in the same run (BLAS threads: {result['threads']}). They get
the condensed problem u = W r + q ready-made and are not charged for it (W comes from a beam model
that the script has of its own); FrictionBeam is charged for all but the mesh. Of several tries with
Siconos (SI and scaled units, three tolerances) the quickest counts that reaches a scaled error of
1e-8; runs are ended after {result['limit']:g} s. "Scaled" is the natural map over the norm of q, "own
scale" takes forces over the line's stiffness at each contact (u from r through the whole line, which
magnifies the last digits of r on long lines), "apart" is the distance from FrictionBeam's forces.
The script's text has the formulas."""),
        table(["rack", "solver", "", "seconds", "iterations", "scaled", "own scale", "apart"], rows),
        "Seconds of the best of Siconos over those of FrictionBeam; 10 is wanted at n = 100 and 400:\n",
        "\n".join(best_ratios) + "\n"])


PLOT = """set terminal svg size 720,420 dynamic background "white" font "sans,13"
set output "{picture}"
set logscale x
set xlabel "seconds, setup and solution"
set ylabel "part of the cases solved"
set yrange [0:1.02]
set xrange [{first}:{last}]
set key at graph 0.98,0.5 right
set grid
set style data steps
"""


def profile(records):
    """Points (seconds, part of the cases solved in them) for each method."""
    n_cases = len({record["case"] for record in records})
    curves = {}
    for method in METHODS:
        seconds = sorted(record["seconds"] for record in records
                         if record["method"] == method and record["outcome"] == "solved")
        curves[method] = [(s, (i + 1) / n_cases) for i, s in enumerate(seconds)]
    return n_cases, curves


def draw(results, picture):
    """A performance profile over the cases that all methods were meant to run."""
    everything = [dict(record, case=group + record["case"]) for group in TEXTS if group in results
                  for record in results[group]["records"]]
    shared = set.intersection(*[{r["case"] for r in everything if r["method"] == method}
                                for method in METHODS])
    n_cases, curves = profile([r for r in everything if r["case"] in shared])
    times = [s for curve in curves.values() for s, _ in curve]
    if not times:
        return ""
    first, last = min(times) / 1.5, max(times) * 1.5
    text = PLOT.format(picture=picture, first=first, last=last)
    for method, curve in curves.items():
        ends = [(first, 0.)] + curve + [(last, curve[-1][1] if curve else 0.)]
        text += f"${method} << E\n" + "".join(f"{s} {part}\n" for s, part in ends) + "E\n"
    text += "plot " + ", ".join(f"${method} title '{method}' linewidth 2" for method in METHODS) + "\n"
    os.makedirs(os.path.dirname(picture), exist_ok=True)
    try:
        subprocess.run(["gnuplot"], input=text, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return ""
    return (f"![Part of the cases solved over time](picture/{os.path.basename(picture)})\n\n" +
            prose(f"The part of the {n_cases} cases that all three methods were given, all groups "
                  "below together, that each solved within a time; cases not run count as not solved."))


def write(folder, document):
    results = {}
    for name in list(TEXTS) + ["speed", "siconos"]:
        path = os.path.join(folder, name + ".json")
        if os.path.exists(path):
            with open(path) as file:
                results[name] = json.load(file)
    parts = [HEAD]
    if any(name in results for name in TEXTS):
        picture = os.path.join(os.path.dirname(document), "picture", "stability.svg")
        parts.append(draw(results, picture))
        parts += [group_section(name, results[name]) for name in TEXTS if name in results]
    if "speed" in results:
        parts.append(speed_section(results["speed"]))
    if "siconos" in results:
        parts.append(siconos_section(results["siconos"]))
    os.makedirs(os.path.dirname(document), exist_ok=True)
    with open(document, "w") as file:
        file.write("\n".join(part for part in parts if part))
