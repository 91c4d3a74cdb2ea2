#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flexibility of a bend as a solid wall, beside the beam's rule 1.65/h and the theory of thin shells.

    prm/benchmark/bend_flexibility.py build/bin/frictionbeam [--h 0.1 0.5] [--tangents 1 5] [--around 24] [--degree 3]
                                      [--radius 3] [--angle 90] [--stiffer 1.3 2]

A bend of an angle a, R = 3 r unless given, mean radius r = 0.1 m, wall t = h r^2/R, between two straight legs of L
diameters, one end of which is held (its radius is free to breathe); a moment M at the other. The turn of that
end is M (2 L + k R a)/(E I), from which k is taken: in the plane of the bend. The same moment about the held leg
bends and twists the bend; the turn about it is M (L (1 + cos^2 a)/(G J) + L sin^2 a/(E I) + R (b k/(E I) + (a - b)/(G J)))
with b = a/2 - sin(2 a)/4, so that this k is that of an element which is as flexible. Without a leg (0), one end of the bend is kept round and the other
one is free to become oval. Prints the table of doc/solid.md, one row for each h; von Karman's first approximation is
k = (12 h^2 + 10)/(12 h^2 + 1), and `series` all terms of his series (long_thin_bend).
"""
import argparse
import json
import math
import pathlib
import subprocess
import tempfile

RADIUS, E, NU, MOMENT = 0.1, 2e11, 0.3, 1e3

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
  set Route = A 0 0 0; {corner!r} 0 0 bend {R}; B {end_x!r} {end_y!r} 0
end
subsection Support anchor
  set Kind = anchor
  set At = A
end
subsection Load inside
  set Kind = pressure
  set Pressure = {pressure!r}
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
  set Loads = inside, in_plane
end
subsection Step across
  set Loads = inside, across
end
subsection Step pressed
  set Loads = inside
end
subsection Quantities
  set turn_in = rz at B, step in_plane
  set turn_across = rx at B, step across
  set turn_pressed = rz at B, step pressed
end
subsection Solid
  set Anchors = breathing
  set Degree = {degree}
  set Most unknowns = 2000000
  set Cells around = {around}
  set First cell = {first!r}
  set Cells per bend = {along}
end
subsection Output
  set Report = false
  set VTU = false
end
"""


def flexibilities(program, h, tangent, around, along, degree, R, angle, pressure=0.0):
    """k in the plane and across it, of a bend with tangents of so many diameters, under pressure [Pa]."""
    wall = h * RADIUS**2 / R
    outer, inner = RADIUS + wall / 2, RADIUS - wall / 2
    length = tangent * 2 * outer
    corner = length + R * math.tan(angle / 2)
    case = CASE.format(diameter=2 * outer, wall=wall, corner=corner, around=around, along=along,
                       end_x=corner * (1 + math.cos(angle)), end_y=corner * math.sin(angle),
                       degree=degree, R=R, pressure=pressure,
                       first=RADIUS / 2,
                       **{name: globals()[name] for name in ("E", "NU", "MOMENT")})
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "bend.prm"
        file.write_text(case)
        subprocess.run([program, file, "--quiet", "--output-directory", f"{folder}/out"], check=True)
        summary = json.loads((pathlib.Path(folder) / "out/summary.json").read_text())
    turn = {one["name"]: one["value"] for one in summary["quantities"]}
    turn["turn_in"] = abs(turn["turn_in"] - turn["turn_pressed"])
    bending = E * math.pi / 4 * (outer**4 - inner**4)
    twisting = bending / (1 + NU)
    k_in = (turn["turn_in"] * bending / MOMENT - 2 * length) / (R * angle)
    # The moment along x twists the leg of the anchor, and bends and twists that of the load.
    legs = length * ((1 + math.cos(angle) ** 2) / twisting + math.sin(angle) ** 2 / bending)
    bent = angle / 2 - math.sin(2 * angle) / 4
    k_across = ((abs(turn["turn_across"]) / MOMENT - legs) / R - (angle - bent) / twisting) * bending / bent
    return k_in, k_across


def long_thin_bend(h, terms=10, points=400, pressure=0.0):
    """k of a long bend (no ends) of a thin wall and R >> r, by von Karman's energy with all terms.

    Around the section, with the angle p from the neutral axis, the wall moves by v = sum b_n sin 2n p along the
    circumference and w = -dv/dp out of it, which does not stretch it. Per strain of plain bending, k = pi/J with
    the least J = integral (sin p + w sin p + v cos p)^2 + lambda^2/12 (w'' + w)^2 dp, lambda = h/sqrt(1 - nu^2).
    Its first term is the first approximation with lambda for h, its limit for small h is 1.65/h.

    Pressure: the area of a section that moves by w without stretch changes by -integral (w'^2 - w^2)/2 dp, of a mode n
    by -(n^2 - 1) pi w_n^2/2, which takes p times that; of J it is psi integral (w'^2 - w^2) dp with psi = (p/E) R^2/(r t).
    It is zero at n = 1, a section that moves as a whole, and with J's bending at psi = -3 lambda^2/12, n = 2: a long
    tube's buckling by p = -E t^3/(4 (1 - nu^2) r^3). @param pressure psi
    """
    bending = h**2 / (1 - NU**2) / 12
    assert pressure > -3 * bending, "the section buckles"
    matrix = [[0.0] * terms for _ in range(terms)]
    right = [0.0] * terms
    for q in range(points):
        p, weight = 2 * math.pi * q / points, 2 * math.pi / points
        strain, curvature, out, turn = [], [], [], []
        for m in range(2, 2 * terms + 1, 2):
            v, w = math.sin(m * p), -m * math.cos(m * p)
            strain.append(w * math.sin(p) + v * math.cos(p))
            curvature.append(w * (1 - m * m))
            out.append(w)
            turn.append(m * m * math.sin(m * p))
        for i in range(terms):
            right[i] -= weight * math.sin(p) * strain[i]
            for j in range(terms):
                matrix[i][j] += weight * (strain[i] * strain[j] + bending * curvature[i] * curvature[j]
                                          + pressure * (turn[i] * turn[j] - out[i] * out[j]))
    saved = 0.0  # of J: right^T matrix^-1 right, by elimination
    for i in range(terms):
        saved += right[i] ** 2 / matrix[i][i]
        for j in range(i + 1, terms):
            factor = matrix[j][i] / matrix[i][i]
            right[j] -= factor * right[i]
            for k in range(i, terms):
                matrix[j][k] -= factor * matrix[i][k]
    return math.pi / (math.pi - saved)


def pressed(program, h, tangent, around, along, degree, R, angle, stiffer):
    """Rows of bends that pressure makes stiffer by so much by Rodabaugh and George's rule (ASME B31.3, appendix D)."""
    r_t, R_r = R / RADIUS / h, R / RADIUS
    without = flexibilities(program, h, tangent, around, along, degree, R, angle)
    for rule in stiffer:
        pressure = E * (rule - 1) / (6 * r_t ** (7 / 3) * R_r ** (1 / 3))
        k = flexibilities(program, h, tangent, around, along, degree, R, angle, pressure)
        series = long_thin_bend(h) / long_thin_bend(h, pressure=pressure / E * R_r**2 * r_t)
        print(f"| {h:g} | {R_r:g} | {r_t:.3g} | {pressure / E:.2e} | {rule:g} | {series:.3f} | {without[0] / k[0]:.3f} "
              f"| {without[1] / k[1]:.3f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--h", type=float, nargs="+", default=[0.05, 0.1, 0.2, 0.5, 1.0])
    parser.add_argument("--tangents", type=float, nargs="+", default=[0, 0.5, 1, 2, 5])
    parser.add_argument("--around", type=int, default=24)
    parser.add_argument("--along", type=int, default=6)
    parser.add_argument("--degree", type=int, default=3)
    parser.add_argument("--radius", type=float, default=3.0, help="R/r")
    parser.add_argument("--angle", type=float, default=90.0, help="degrees")
    parser.add_argument("--stiffer", type=float, nargs="+", help="rows of bends under pressure that are so much stiffer by the code's rule")
    options = parser.parse_args()
    if options.stiffer:
        print("| h | R/r | r/t | p/E | rule | series | in the plane | across |\n" + "| --- " * 8 + "|")
        for h in options.h:
            pressed(options.program, h, options.tangents[-1], options.around, options.along, options.degree,
                    options.radius * RADIUS, math.radians(options.angle), options.stiffer)
        return
    heads = [f"{tangent:g} D" for tangent in options.tangents]
    print("| h | 1.65/h | von Karman | series | " + " | ".join(heads) + f" | across, {heads[-1]} |")
    print("| --- " * (5 + len(heads)) + "|")
    for h in options.h:
        both = [flexibilities(options.program, h, tangent, options.around, options.along,
                              options.degree, options.radius * RADIUS, math.radians(options.angle))
                for tangent in options.tangents]
        karman = (12 * h * h + 10) / (12 * h * h + 1)
        cells = [f"{h:g}", f"{1.65 / h:.2f}", f"{karman:.2f}", f"{long_thin_bend(h):.2f}"] + [f"{one[0]:.2f}" for one in both]
        print("| " + " | ".join(cells + [f"{both[-1][1]:.2f}"]) + " |", flush=True)


if __name__ == "__main__":
    main()
