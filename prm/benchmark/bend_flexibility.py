#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flexibility of a bend as a solid wall, beside the beam's rule 1.65/h.

    prm/benchmark/bend_flexibility.py build/bin/frictionbeam [--h 0.1 0.5] [--tangents 1 5]

A bend of 90 degrees, R = 0.3 m, mean radius r = 0.1 m, wall t = h r^2/R, between two straight legs of L
diameters, one end of which is held (its radius is free to breathe); a moment M at the other. The turn of that
end is M (2 L + k R pi/2)/(E I), from which k is taken: in the plane of the bend. The same moment across the
plane bends and twists the bend; its turn is M (L/(E I) + L/(G J) + R pi/4 (k/(E I) + 1/(G J))), so that this
k is that of an element which is as flexible. Prints the table of doc/solid.md; von Karman's first
approximation is k = (12 h^2 + 10)/(12 h^2 + 1).
"""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

R, RADIUS, E, NU, MOMENT = 0.3, 0.1, 2e11, 0.3, 1e3

CASE = """
set Model = solid
subsection Material steel
  set Young's modulus = {E}
  set Poisson's ratio = {NU}
end
subsection Section pipe
  set Outer diameter = {diameter!r}
  set Wall = {wall!r}
end
subsection Pipe bend
  set Route = A 0 0 0; {corner!r} 0 0 bend {R}; B {corner!r} {corner!r} 0
end
subsection Support anchor
  set Kind = anchor
  set At = A
end
subsection Load in_plane
  set Kind = force
  set Forces = B 0 0 0 0 0 {MOMENT}
end
subsection Load across
  set Kind = force
  set Forces = B 0 0 0 {MOMENT} 0 0
end
subsection Step in_plane
  set Loads = in_plane
end
subsection Step across
  set Loads = across
end
subsection Quantities
  set turn_in = rz at B, step in_plane
  set turn_across = rx at B, step across
end
subsection Solid
  set Anchors = breathing
  set Degree = 2
  set Cells around = {around}
  set First cell = {first!r}
  set Cells per bend = {along}
end
subsection Output
  set Report = false
  set VTU = false
end
"""


def flexibilities(program, h, tangent, around, along):
    """k in the plane and across it, of a bend with tangents of so many diameters."""
    wall = h * RADIUS**2 / R
    outer, inner = RADIUS + wall / 2, RADIUS - wall / 2
    length = tangent * 2 * outer
    case = CASE.format(diameter=2 * outer, wall=wall, corner=length + R, around=around, along=along,
                       first=RADIUS / 2,
                       **{name: globals()[name] for name in ("E", "NU", "R", "MOMENT")})
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "bend.prm"
        file.write_text(case)
        subprocess.run([program, file, "--quiet", "--output-directory", f"{folder}/out"], check=True)
        summary = json.loads((pathlib.Path(folder) / "out/summary.json").read_text())
    turn = {one["name"]: abs(one["value"]) for one in summary["quantities"]}
    bending = E * math.pi / 4 * (outer**4 - inner**4)
    twisting = bending / (1 + NU)
    k_in = (turn["turn_in"] * bending / MOMENT - 2 * length) / (R * math.pi / 2)
    # The moment along x twists the leg of the anchor and bends that of the load.
    legs = length / bending + length / twisting
    k_across = ((turn["turn_across"] / MOMENT - legs) / (R * math.pi / 4) - 1 / twisting) * bending
    return k_in, k_across


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--h", type=float, nargs="+", default=[0.05, 0.1, 0.2, 0.5, 1.0])
    parser.add_argument("--tangents", type=float, nargs="+", default=[0.5, 1, 2, 5])
    parser.add_argument("--around", type=int, default=32)
    parser.add_argument("--along", type=int, default=6)
    options = parser.parse_args()
    heads = [f"{tangent:g} D" for tangent in options.tangents]
    print("| h | 1.65/h | von Karman | " + " | ".join(heads) + f" | across, {heads[-1]} |")
    print("| --- " * (4 + len(heads)) + "|")
    for h in options.h:
        both = [flexibilities(options.program, h, tangent, options.around, options.along)
                for tangent in options.tangents]
        karman = (12 * h * h + 10) / (12 * h * h + 1)
        cells = [f"{h:g}", f"{1.65 / h:.2f}", f"{karman:.2f}"] + [f"{one[0]:.2f}" for one in both]
        print("| " + " | ".join(cells + [f"{both[-1][1]:.2f}"]) + " |", flush=True)


if __name__ == "__main__":
    main()
