#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX's pipe section and FrictionBeam's fibres on the cantilever at 0.95 of its collapse, bent in several directions.

    prm/benchmark/against_calculix.py [--markdown FILE] [--program FILE] [--quick]
    prm/benchmark/against_calculix.py --one CELLS:DIRECTION      one run of CalculiX, for `frictionbeam chart`

Needs Debian's calculix-ccx, a tool of this benchmark only. CalculiX has B32R cells of equal length, SECTION=PIPE, which
it expands into one solid cell each (C3D20R) with eight integration points round the circumference, perfectly plastic,
in 20 increments. FrictionBeam has the case of tests/cases/inelastic/cantilever.prm, the force turned. The section's own axis 1 is y
in either; a direction is the force's angle from it [degrees].

Deflections are those of the end along the force, over that at first yield: exactly 1.29116432, 1.20957757 if all is
elastic, without shear. `elastic`: what CalculiX gives for an elastic metal, so that its two errors can be told apart.
`sideways`: across the force, a share of the deflection; a round tube has none.

Time of CalculiX is its own "Total CalculiX Time", of FrictionBeam mesh, set-up and solution; one thread each, medians of
three runs in turn.
"""
import argparse
import json
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CASE = os.path.join(ROOT, "tests", "cases", "inelastic", "cantilever.prm")
MODULUS, POISSON, YIELD, LENGTH, OUTER, WALL = 2e11, 0.3, 2e8, 2.0, 0.10025, 0.0005
FORCE = 1900.001
SCALE = 75.0  # over ky L^2 / 3
EXACT, EXACT_ELASTIC = 1.29116432, 1.20957757
INCREMENTS = 20
ENVIRONMENT = {**os.environ, "OMP_NUM_THREADS": "1"}


def deck(cells, direction, plastic, length):
    """CalculiX's input; the force has the same moment at the root whatever the length."""
    n_nodes = 2 * cells + 1
    force = FORCE * LENGTH / length
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i + 1}, {length * i / (n_nodes - 1):.15g}, 0, 0" for i in range(n_nodes)]
    lines += ["*ELEMENT, TYPE=B32R, ELSET=TUBE"]
    lines += [f"{i + 1}, {2 * i + 1}, {2 * i + 2}, {2 * i + 3}" for i in range(cells)]
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{MODULUS}, {POISSON}"]
    lines += ["*PLASTIC", f"{YIELD}, 0."] if plastic else []
    lines += ["*BEAM SECTION, ELSET=TUBE, MATERIAL=STEEL, SECTION=PIPE", f"{OUTER}, {WALL}", "0, 1, 0"]
    lines += ["*BOUNDARY", "1, 1, 6", "*NSET, NSET=TIP", f"{n_nodes}"]
    step = 1.0 / INCREMENTS
    lines += ["*STEP, INC=1000", "*STATIC", f"{step}, 1., 1e-6, {step}"]
    lines += ["*CLOAD", f"{n_nodes}, 2, {force * math.cos(direction):.15g}",
              f"{n_nodes}, 3, {force * math.sin(direction):.15g}"]
    lines += ["*NODE PRINT, NSET=TIP, FREQUENCY=1000", "U", "*END STEP"]
    return "\n".join(lines) + "\n"


def calculix(cells, degrees, plastic=True, length=LENGTH):
    """@return deflection along and across the force over that at first yield, seconds, number of equations."""
    direction = math.radians(degrees)
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "tube.inp"), "w") as file:
            file.write(deck(cells, direction, plastic, length))
        run = subprocess.run(["ccx", "-i", "tube"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
        with open(os.path.join(folder, "tube.dat")) as file:
            rows = [line.split() for line in file]
    rows = [row for row in rows if len(row) == 4 and row[0] == str(2 * cells + 1)]
    total = re.search(r"Total CalculiX Time:\s*([0-9.]+)", run.stdout)
    equations = re.search(r"number of equations\s+([0-9]+)", run.stdout)
    if not rows or total is None or equations is None:
        raise RuntimeError("CalculiX has no answer: " + run.stdout[-300:])
    uy, uz = float(rows[-1][2]), float(rows[-1][3])
    scale = SCALE * (LENGTH / length) ** 2
    return (scale * (uy * math.cos(direction) + uz * math.sin(direction)),
            scale * (uz * math.cos(direction) - uy * math.sin(direction)), float(total.group(1)),
            int(equations.group(1)))


def frictionbeam(program, degrees, settings):
    """The same of FrictionBeam."""
    direction = math.radians(degrees)
    c, s = math.cos(direction), math.sin(direction)
    sets = [f"Load tip/Forces = B 0 {FORCE * c:.15g} {FORCE * s:.15g}", f"Quantities/v = uy at B; scale {SCALE}; unit -",
            f"Quantities/w = uz at B; scale {SCALE}; unit -", "Output/VTU = false", "Output/Report = false"] + settings
    with tempfile.TemporaryDirectory() as folder:
        words = [program, CASE, "--output-directory", folder]
        for setting in sets:
            words += ["--set", setting]
        subprocess.run(words, check=True, env=ENVIRONMENT, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
    value = {one["name"]: one["value"] for one in summary["quantities"]}
    cost = summary["cost"]
    seconds = cost["mesh_seconds"] + cost["setup_seconds"] + cost["solve_seconds"]
    return c * value["v"] + s * value["w"], c * value["w"] - s * value["v"], seconds


def row(name, cells, degrees, answers, elastic):
    along, across = answers[0][:2]
    seconds = statistics.median(answer[2] for answer in answers)
    return (f"| {name} | {cells} | {degrees:g} | {along:.5f} | {100 * (along / EXACT - 1):+.2g} % | "
            f"{100 * abs(across / along):.2g} % | {elastic} | {1000 * seconds:.2g} ms |")


def table(program, quick):
    directions = [0.0, 22.5] if quick else [0.0, 11.25, 22.5, 45.0, 67.5]
    lines = ["| program | cells | direction | deflection | error | sideways | elastic | time |",
             "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    cells = [16] if quick else [8, 32, 128]
    ours = [("FrictionBeam, 15 fibres", ["Section tube/Fibres = 15"]), ("FrictionBeam, 63 fibres", [])]
    runs = [(f"CalculiX, L = {length:g} m", n, degrees, lambda n=n, d=degrees, l=length: calculix(n, d, True, l),
             lambda n=n, d=degrees, l=length: calculix(n, d, False, l))
            for length in ([LENGTH] if quick else [LENGTH, 10 * LENGTH]) for n in (cells if length == LENGTH else cells[-1:])
            for degrees in directions]
    runs += [(name, "refined", degrees, lambda d=degrees, s=settings: frictionbeam(program, d, s), None)
             for name, settings in ours for degrees in directions]
    answers = [[] for _ in runs]
    for _ in range(1 if quick else 3):
        for run, found in zip(runs, answers):
            found.append(run[3]())
    for (name, n, degrees, _, elastic), found in zip(runs, answers):
        lines.append(row(name, n, degrees, found, f"{elastic()[0]:.5f}" if elastic else f"{EXACT_ELASTIC:.5f}"))
    return "\n".join(lines)


def version():
    return subprocess.run(["ccx", "-v"], capture_output=True, text=True).stdout.split()[-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--one", metavar="CELLS:DIRECTION")
    parser.add_argument("--markdown")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "frictionbeam"))
    parser.add_argument("--quick", action="store_true", help="few cells and directions")
    arguments = parser.parse_args()
    if arguments.one:
        cells, degrees = arguments.one.split(":")
        along, _, seconds, unknowns = calculix(int(cells), float(degrees))
        print(f"w = {along:.9g}\nseconds = {seconds}\nunknowns = {unknowns}")
        return 0
    text = table(arguments.program, arguments.quick)
    print(text)
    if arguments.markdown:
        with open(arguments.markdown, "w") as file:
            file.write(f"{INTRODUCTION.format(version=version())}\n{text}\n")
    return 0


INTRODUCTION = """### CalculiX's pipe section on the same cantilever

CalculiX {version} (Debian's), B32R cells of equal length with SECTION=PIPE, eight points round the circumference, perfectly plastic, 20
increments; FrictionBeam with hinges refined, one increment. *Direction*: of the force, from the section's own axis, degrees.
*Deflection*: of the end along the force, over that at first yield, exactly 1.29116; *elastic*: what it would be without yielding,
exactly 1.20958; *sideways*: across the force, of the deflection. A round tube has no directions: what changes with them is error.
By `prm/benchmark/against_calculix.py`; times are its own "Total CalculiX Time" and mesh, set-up and solution, one thread.

Eight points by themselves, in equilibrium along the pipe, give no answer with two of them in the plane of bending, since their limit
moment is 5.2 % too small, and 1.322 with the plane between two of them, whose limit moment is 2.6 % too large. CalculiX finds neither,
probably because the solid cells into which it expands the pipe hinder its sections from contracting at the anchor: ten times as long,
where that counts for less, its directions are further apart. We have not looked further."""

if __name__ == "__main__":
    sys.exit(main())
