#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a hot pipe that grows thicker, and the edges of the patches that it stands on, do to what its rests carry: a pipe,
anchored at one end, on two rests without friction, as a solid wall and as a line (doc/solid.md, "Growth and edges").

    prm/benchmark/growth_on_rests.py                    # the table
    prm/benchmark/growth_on_rests.py --ratio 10 --width 1 --apart 20 --around 24

Columns: r/t, width and distance between rests in outer diameters; force of the first rest cold and what heat makes of it, of
the solid; of a line whose rests are points as elastic as the wall, and of one that stands on both edges of each patch, half
as elastic each: error cold, of it hot with growth as Ground motion, and of what growth changes."""
import argparse
import itertools
import pathlib
import re
import subprocess
import tempfile

D, E, ALPHA, RISE, OVERHANG = 0.2, 2e11, 1.2e-5, 200., 5 * 0.2
PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "build/bin/frictionbeam"


def scene(ratio, width, apart, places, rigidity, growth, solid, stands_on="point"):
    t = D / (2 * ratio + 1)
    points = {"A": 0., **places, "B": 2 * apart * D + OVERHANG}
    text = f"""set Model = {"solid" if solid else "line"}
subsection Material steel
  set Young's modulus = {E}
  set Poisson's ratio = 0.3
  set Density = 7850
  set Expansion = {ALPHA}
end
subsection Section pipe
  set Outer diameter = {D}
  set Wall = {t:.6g}
  set Contents = 1000
end
subsection Pipe p
  set Route = {"; ".join(f"{name} {s:.8g} 0 0" for name, s in points.items())}
end
subsection Support anchor
  set Kind = anchor
  set At = A
end
subsection Load weight
  set Kind = weight
end
subsection Load hot
  set Kind = temperature
  set Temperature = {20 + RISE}
end
subsection Step cold
  set Loads = weight
end
subsection Step hot
  set Loads = weight, hot
end
subsection Output
  set VTU = false
end
"""
    for name in places:
        text += f"""subsection Support on_{name}
  set Kind = rest
  set At = {name}
  set Friction coefficient = 0
  set Width = {width * D}
  set Stands on = {stands_on}
{f"  set Axial rigidity = {rigidity:.6g}" if rigidity else ""}
"""
        if growth:
            text += f"""  set Ground motion = 0; 0; table 0 0, 1 0, 2 {ALPHA * RISE * D / 2}
  set Ground motion time = run
"""
        text += "end\n"
    if solid:
        text += f"""subsection Solid
  set Degree = 3
  set Cells around = {solid}
  set Anchors = breathing
  set First cell = {min(width, 1) * D / 4:.6g}
  set Longest cell = {D}
end
"""
    text += "subsection Quantities\n"
    for step, name in itertools.product(("cold", "hot"), places):
        text += f"  set {step}_{name} = fn at on_{name}, step {step}\n"
    return text + "end\n"


def forces(text):
    """Of the first rest, cold and hot [N]."""
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case.prm"
        case.write_text(text)
        run = subprocess.run([PROGRAM, case, "--output-directory", folder], capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError(run.stdout + run.stderr)
    sums = {"cold": 0., "hot": 0.}
    for step, value in re.findall(r"^(cold|hot)_P\w* = (\S+)", run.stdout, re.M):
        sums[step] += float(value)
    return sums["cold"], sums["hot"]


def row(ratio, width, apart, around):
    t, r = D / (2 * ratio + 1), ratio * D / (2 * ratio + 1)
    wall = E * t / 6.8 / (r / t / 10) ** 1.65 * width ** 0.3  # doc/solid.md, "Walls at supports" [N/m]
    middle = {"P": apart * D, "Q": 2 * apart * D}
    solid = forces(scene(ratio, width, apart, middle, None, False, around))
    point, edge = (tuple(forces(scene(ratio, width, apart, middle, wall, growth, None, stands_on))
                         for growth in (False, True)) for stands_on in ("point", "edges"))
    grows = solid[1] - solid[0]

    def shown(line):
        cold, hot = line[1]
        return f"{cold / solid[0] - 1:+.1%} | {hot / solid[1] - 1:+.1%} | {(hot - cold) / grows - 1:+.1%}"
    return f"| {ratio} | {width} | {apart} | {solid[0]:.0f} N, {grows:+.0f} | {shown(point)} | {shown(edge)} |"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ratio", type=float, nargs="+", default=[10, 17, 30], help="r/t of the mean radius")
    parser.add_argument("--width", type=float, nargs="+", default=[0.5, 1, 2], help="of the rests [D]")
    parser.add_argument("--apart", type=float, nargs="+", default=[10, 20], help="rests, and the first from the anchor [D]")
    parser.add_argument("--around", type=int, default=12, help="cells around of the solid, of degree 3")
    asked = parser.parse_args()
    print("| r/t | width | apart | solid, growth | points: cold | hot | growth | edges: cold | hot | growth |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for case in itertools.product(asked.ratio, asked.width, asked.apart):
        print(row(*case, asked.around), flush=True)
