#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write doc/accuracy.md from the charts in doc/charts (made by doc/charts.sh): what Accuracy demanded, what
it reached, and what it cost beside the cheapest configuration picked by hand."""
import csv
import os

HERE = os.path.dirname(os.path.abspath(__file__))
LABEL = "left to the program, Accuracy"


def milliseconds(seconds):
    return f"{1e3 * seconds:.3g} ms"


lines = ["| case | demanded | true error | time | cheapest picked by hand | its time | ratio |",
         "| --- | --- | --- | --- | --- | --- | --- |"]
worst, missed, n = 0.0, 0, 0
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
            tail = f"{best['curve']} {best['setting']} | {milliseconds(float(best['seconds_median']))} | {ratio:.2g}"
        else:
            tail = "none on the chart | | "
        lines.append(f"| {name} | {demanded:g} | {error:.2g}{' **missed**' if error > demanded else ''} | "
                     f"{milliseconds(time)} | {tail} |")

with open(os.path.join(HERE, "accuracy.md"), "w") as page:
    page.write(f"""# Accuracy

`set Accuracy = 1e-3` lets the program choose the increments of static steps, the time step, the length of
cells where something is spread over them, the supports and elements of generated scenes, bends as exact
arcs, and the refinement of a continuum: as coarse as its estimates allow. It solves coarse levels first,
reads the order of convergence from their differences, goes straight to the level that the estimate asks
for, and checks that one by its difference to the one before. `summary.json` and the report say what was
chosen, the estimated error, what was left out and what every run cost.

The true errors, and the cost of all runs together beside that of the cheapest single configuration on the
charts (doc/charts): {n - missed} of {n} within what was demanded, at {worst:.2g} times the cost at most. Made
by `doc/accuracy.py` from the figures of the charts.

""" + "\n".join(lines) + """

What it does not do: choose between line and continuum (`Model = auto`), the degree of a continuum's
elements (3, the cheapest on the charts), or the number of cells in a mesh of the user's own. An estimate
from differences can be deceived by chance agreement; a difference is therefore taken for no less than a
quarter of the one before, level by level.
""")
