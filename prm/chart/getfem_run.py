#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of GetFEM for `frictionbeam chart`: prints the quantities, 'seconds' (mesh, assembly, solution)
and 'unknowns'. The models are those of prm/benchmark/against_getfem.py.

  getfem_run.py slab|bar DEGREE:COARSE                 uniform mesh
  getfem_run.py slab|bar DEGREE:COARSE:FINE:GROWTH     graded towards the ends of the slip zone

COARSE and FINE are sizes of cells [m], for the bar in parts of a quarter of its side.
"""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "benchmark"))
import against_getfem as getfem

case = "slab" if sys.argv[1] == "slab" else "long bar"
numbers = sys.argv[2].split(":")
unit = 1.0 if case == "slab" else getfem.SIDE / 4
degree, coarse = int(numbers[0]), float(numbers[1]) * unit
if len(numbers) == 4:
    run = getfem.Getfem(case, degree, coarse, float(numbers[2]) * unit, float(numbers[3]))
else:
    run = getfem.Getfem(case, degree, coarse)
print("seconds =", run.run())
print("unknowns =", run.unknowns)
for name in run.reference:
    print(name, "=", run.values[name])
