#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw doc/picture/block.svg: the block of tests/embed/block_on_floor.cc and the floor beneath it.

  block_on_floor points.txt && doc/block.py points.txt

A line of the file is: share of the push; place; displacement; on the floor also the contact's status
and force.
"""
import os
import sys

OUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "picture", "block.svg")
SCALE = 1500.0  # pixels a metre
MOTION = 15.0  # displacements are drawn so many times as large
FORCE = 0.004  # metres a newton
WIDTH, HEIGHT = 770, 720
COLOUR = {1: ("#2166ac", "sticks"), 2: ("#e08214", "slips"), 3: ("#bbbbbb", "open")}


def read(path):
    increments = {}
    with open(path) as file:
        for line in file:
            numbers = [float(word) for word in line.split()]
            increments.setdefault(numbers[0], []).append(numbers[1:])
    return increments


def project(x, y, z):
    """Parallel projection, seen from the front, the right and above [pixels]."""
    return SCALE * (0.86 * x + 0.42 * y), -SCALE * (-0.16 * x + 0.36 * y + 0.86 * z)


def face(points, fixed, value):
    """Quadrilaterals of a structured face, each as four places of displaced vertices."""
    grid = {tuple(round(p[d], 6) for d in range(3)): p for p in points if abs(p[fixed] - value) < 1e-9}
    a, b = [d for d in range(3) if d != fixed]
    rows, columns = sorted({k[a] for k in grid}), sorted({k[b] for k in grid})
    for r0, r1 in zip(rows, rows[1:]):
        for c0, c1 in zip(columns, columns[1:]):
            corners = []
            for r, c in ((r0, c0), (r1, c0), (r1, c1), (r0, c1)):
                key = [value] * 3
                key[a], key[b] = r, c
                p = grid[tuple(round(k, 6) for k in key)]
                corners.append([p[d] + MOTION * p[3 + d] for d in range(3)])
            yield corners


def panel(share, points, left):
    size = [max(p[d] for p in points) for d in range(3)]
    x0, y0 = left + 52, 275
    parts = []

    def place(x, y, z):
        px, py = project(x, y, z)
        return x0 + px, y0 + py

    def polygon(corners, fill, stroke="#777777"):
        text = " ".join("%.1f,%.1f" % place(*corner) for corner in corners)
        parts.append('<polygon points="%s" fill="%s" stroke="%s" stroke-width="0.6"/>' % (text, fill, stroke))

    # The floor, drawn beneath the block, with what each contact does.
    drop = 0.21
    polygon([(-0.03, -0.03, -drop), (size[0] + 0.05, -0.03, -drop), (size[0] + 0.05, size[1] + 0.03, -drop),
             (-0.03, size[1] + 0.03, -drop)], "#f4f4f0", "#cccccc")
    for p in points:
        if len(p) < 8:
            continue
        status, fx, fy = int(p[6]), p[7], p[8]
        x, y = place(p[0], p[1], -drop)
        tip = place(p[0] + FORCE * fx, p[1] + FORCE * fy, -drop)
        colour = COLOUR[status][0]
        if status != 3:
            parts.append('<line x1="%.1f" y1="%.1f" x2="%.1f" y2="%.1f" stroke="%s" stroke-width="1.3"/>'
                         % (x, y, *tip, colour))
        parts.append('<circle cx="%.1f" cy="%.1f" r="2.3" fill="%s"/>' % (x, y, colour))
    for corners in face(points, 2, size[2]):
        polygon(corners, "#eef3f7")
    for corners in face(points, 1, 0.0):
        polygon(corners, "#d3dfe8")
    for corners in face(points, 0, size[0]):
        polygon(corners, "#bccddb")
    parts.append('<text x="%d" y="28" font-size="22" text-anchor="middle">pushed by %g %% of what friction holds</text>'
                 % (left + WIDTH // 2, 100 * share))
    return parts


def main():
    increments = read(sys.argv[1])
    total = WIDTH * len(increments)
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" font-family="sans-serif">' % (total, HEIGHT),
             '<rect width="%d" height="%d" fill="white"/>' % (total, HEIGHT)]
    for k, (share, points) in enumerate(sorted(increments.items())):
        lines += panel(share, points, WIDTH * k)
    for k, (colour, name) in enumerate(COLOUR.values()):
        x = 60 + 150 * k
        lines.append('<circle cx="%d" cy="%d" r="5" fill="%s"/><text x="%d" y="%d" font-size="20">%s</text>'
                     % (x, HEIGHT - 12, colour, x + 14, HEIGHT - 6, name))
    lines.append('<text x="%d" y="%d" font-size="20">lines: friction of the floor on the block; displacements times %g</text></svg>'
                 % (560, HEIGHT - 7, MOTION))
    with open(OUT, "w") as file:
        file.write("\n".join(lines) + "\n")
    print(OUT)


if __name__ == "__main__":
    main()
