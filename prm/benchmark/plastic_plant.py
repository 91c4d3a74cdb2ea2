#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What yielding costs: prm/example/plant.prm with fibre sections against the same line elastic, in the same run.

    prm/benchmark/plastic_plant.py [--runs N] [--program FILE] [--yield-stress PASCAL]

Bends are as stiff as straight pipes here (Bend flexibility = none), since fibre_pipe knows no others. Variants:

    elastic     the friction line as it is
    unyielding  63 fibres on two radii, a yield stress that is nowhere reached
    yielding    the same with --yield-stress
    global      the same with global_plastic, 'Bend flexibility' as in the example, against the elastic line of these bends

A kinematic modulus of 1e10 Pa spreads yielding over many cells; without one two hinges carry all.

Each is run N times (7) in turn, a process of its own; medians of cost.wall_seconds and of cost.setup_seconds +
cost.solve_seconds of summary.json, and their ratios to the elastic run. The share of cells that have yielded by the last step is counted in sections.csv, five sections a cell.
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
SECTIONS_OF_CELL = 5  # Mesh/Section points


def law(name, stress):
    return [f"Section {section}/{entry}" for section in ("header", "branch")
            for entry in (f"Law = {name}", f"Yield stress = {stress}", "Kinematic modulus = 1e10")]


def variants(stress):
    """@return settings of each, and the one beside which it is put"""
    return {
        "elastic": (STIFF_BENDS, "elastic"),
        "unyielding": (STIFF_BENDS + law("fibre_pipe", "1e9"), "elastic"),
        "yielding": (STIFF_BENDS + law("fibre_pipe", stress), "elastic"),
        "elastic, flexible bends": ([], "elastic, flexible bends"),
        "global": (law("global_plastic", stress), "elastic, flexible bends"),
    }


def yielded(path):
    """Share of the cells, at the end of the last step; None if no section has a law of its own."""
    if not os.path.exists(path):
        return None
    with open(path) as file:
        rows = list(csv.DictReader(file))
    strains = [float(row["plastic_strain"]) for row in rows if row["step"] == rows[-1]["step"]]
    cells = [strains[i:i + SECTIONS_OF_CELL] for i in range(0, len(strains), SECTIONS_OF_CELL)]
    return sum(max(cell) > 0 for cell in cells) / len(cells)


def run(program, settings):
    """@return seconds, summary, and the share of cells that have yielded"""
    with tempfile.TemporaryDirectory() as folder:
        words = [program, CASE, "--output-directory", folder]
        for setting in ["Output/VTU = false", "Output/Report = false"] + settings:
            words += ["--set", setting]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
        share = yielded(os.path.join(folder, "sections.csv"))
    cost = summary["cost"]
    return (cost["wall_seconds"], cost["setup_seconds"] + cost["solve_seconds"]), summary, share


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "frictionbeam"))
    parser.add_argument("--yield-stress", default="0.695e8")
    arguments = parser.parse_args()
    cases = variants(arguments.yield_stress)
    seconds = {name: [] for name in cases}
    summaries, shares = {}, {}
    for _ in range(arguments.runs):
        for name, (settings, _) in cases.items():
            time, summaries[name], shares[name] = run(arguments.program, settings)
            seconds[name].append(time)
    print("| variant | whole run | over elastic | set-up and solution | over elastic | iterations | factorizations | "
          "cells that yield |\n| --- | --- | --- | --- | --- | --- | --- | --- |")
    for name, (_, beside) in cases.items():
        own, others = ([statistics.median(times) for times in zip(*seconds[which])] for which in (name, beside))
        cost = summaries[name]["cost"]
        print(f"| {name} | {1000 * own[0]:.0f} ms | {own[0] / others[0]:.2f} | {1000 * own[1]:.0f} ms | "
              f"{own[1] / others[1]:.2f} | {cost['iterations']} | "
              f"{cost['factorizations']} | {'-' if shares[name] is None else f'{100 * shares[name]:.1f} %'} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
