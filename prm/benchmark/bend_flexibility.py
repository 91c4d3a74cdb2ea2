#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flexibility of a 90 degree bend as a solid wall, over h = t R / r^2 and the length of its straight legs.

    prm/benchmark/bend_flexibility.py [--program build/bin/frictionbeam] [--around 24] [--degree 3] [--write-page]

A pipe of mean radius r = 0.1 m with a bend of R = 3 r between two equal legs, anchored at one end, is turned at the
other by a moment in its plane, then across it. Of the turn there, what the legs and the bend of a beam would give with
k for its flexibility is solved for k. Beside it 1.65/h (B31.3, RCC-M) and von Karman's first approximation
(12 h^2 + 10)/(12 h^2 + 1), which know no legs. --write-page replaces the table of doc/solid.md.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
E, NU, RADIUS, RATIO = 2e11, 0.3, 0.1, 3.
FLEXIBILITIES, LEGS = [0.05, 0.1, 0.2, 0.4, 1.], [0.5, 1., 2., 5.]

SCENE = """set Model = solid
subsection Material steel
  set Young's modulus = {E}
  set Poisson's ratio = {nu}
end
subsection Section pipe
  set Outer diameter = {diameter}
  set Wall = {wall}
end
subsection Pipe bend
  set Route = A 0 0 0; 0 {corner} 0 bend {R}; D {corner} {corner} 0
end
subsection Support anchor
  set Kind = anchor
  set At = A
end
subsection Load in_plane
  set Kind = force
  set Forces = D 0 0 0 0 0 {moment}
end
subsection Load across
  set Kind = force
  set Forces = D 0 0 0 {moment} 0 0
end
subsection Step in
  set Loads = in_plane
end
subsection Step across
  set Loads = across
end
subsection Quantities
  set turn_in = rz at D, step in
  set turn_across = rx at D, step across
end
subsection Solid
  set Cells around = {around}
  set Degree = {degree}
  set Cells per bend = {per_bend}
  set Most unknowns = 2000000
end
subsection Output
  set VTU = false
  set Report = false
end
"""


def figures(program, h, diameters, options, folder):
    """k in the plane and across it, and the seconds of the solution."""
    R, t = RATIO * RADIUS, h * RADIUS / RATIO
    D = 2 * RADIUS + t
    leg = diameters * D
    outer, inner = D / 2, D / 2 - t
    I = math.pi / 4 * (outer**4 - inner**4)
    moment = 1e-4 * E * I / RADIUS  # strains of 1e-4
    case = pathlib.Path(folder) / "bend.prm"
    case.write_text(SCENE.format(E=E, nu=NU, diameter=D, wall=t, corner=leg + R, R=R, moment=moment, around=options.around,
                                 degree=options.degree, per_bend=options.per_bend))
    subprocess.run([options.program, case, "--output-directory", folder, "--quiet"], check=True)
    summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    value = {q["name"]: q["value"] for q in summary["quantities"]}
    bend = moment * R / (E * I)  # per angle
    # In the plane all bend: 2 legs and k pi/2 of the bend.
    k_in = (value["turn_in"] - 2 * moment * leg / (E * I)) / (bend * math.pi / 2)
    # About x: the first leg (along y) bends, the last (along x) is twisted, GI_p = EI/(1 + nu); in the bend the moment's
    # parts are M cos a across the tangent, which bends with k, and M sin a along it, which twists; each turns D by its share.
    legs = moment * leg / (E * I) * (1 + (1 + NU))
    k_across = ((value["turn_across"] - legs) / (bend * math.pi / 4)) - (1 + NU)
    return k_in, k_across, summary["cost"]["solve_seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default=str(HERE.parents[1] / "build/bin/frictionbeam"))
    parser.add_argument("--around", type=int, default=24)
    parser.add_argument("--degree", type=int, default=3)
    parser.add_argument("--per-bend", type=int, default=8)
    parser.add_argument("--write-page", action="store_true")
    options = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    lines = ["| h | r/t | 1.65/h | von Karman | " + " | ".join(f"legs {d:g} D" for d in LEGS) + " | across, "
             f"legs {LEGS[-1]:g} D |", "| --- " * (5 + len(LEGS)) + "|"]
    print("\n".join(lines), flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for h in FLEXIBILITIES:
            found = [figures(options.program, h, d, options, folder) for d in LEGS]
            lines.append(f"| {h:g} | {RATIO / h:g} | {1.65 / h:.2f} | {(12 * h * h + 10) / (12 * h * h + 1):.2f} | "
                         + " | ".join(f"{k:.2f}" for k, _, _ in found) + f" | {found[-1][1]:.2f} |")
            print(lines[-1], flush=True)
    if options.write_page:
        page = HERE.parents[1] / "doc/solid.md"
        text = page.read_text()
        begin, end = "<!-- bend flexibility -->\n", "<!-- end -->"
        head, rest = text.split(begin)
        page.write_text(head + begin + "\n".join(lines) + "\n" + end + rest.split(end, 1)[1])


if __name__ == "__main__":
    main()
