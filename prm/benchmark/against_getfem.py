#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves the continuum slab and the long bar in GetFEM (Debian's python3-getfem) and in FrictionBeam,
compares the results, and measures how long either needs to come within 0.1 % of the references.

  against_getfem.py BUILD_FOLDER [--markdown FILE] [--quick]

GetFEM solves the same weak problem with a multiplier of the friction (and contact) traction and its own
semismooth Newton method, on quadrilaterals of several degrees, on uniform meshes and on meshes graded
towards the end of the slip zone and the corners, whose place it is told. Its time is that of mesh,
assembly and solution, without starting Python and loading its library. FrictionBeam's time is that of the
whole program, from start to end, mesh by gmsh and all meshes of its refinement included, without report
and VTU. Both use one thread. Times are medians of several runs, taken in turn.
"""
import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
import numpy as np

sys.path.append("/usr/lib/python3/dist-packages")
import getfem as gf

gf.util_trace_level(0)
HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(HERE, "..", "verification")
E, P, F, BOUND, LENGTH = 1000.0, 10.0, 12.0, 3.0, 8.0


def graded(points, coarse, fine, growth=1.6):
    """Coordinates between the first and the last point, graded towards those with a mark."""
    marks = [p for p, marked in points if marked]
    stops = sorted({p for p, _ in points})
    x = [stops[0]]
    for a, b in zip(stops[:-1], stops[1:]):
        steps, here = [], a
        while here < b - 1e-12:
            distance = min([abs(here - m) for m in marks] + [1e9])
            ahead = min([m - here for m in marks if m > here + 1e-12] + [1e9])
            h = min(coarse, fine + (growth - 1) * distance)
            while h > fine and h > fine + (growth - 1) * max(ahead - h, 0.0):
                h /= growth
            steps.append(h)
            here += h
        scale = (b - a) / sum(steps)
        for h in steps:
            x.append(x[-1] + scale * h)
        x[-1] = b
    return np.array(x)


def lame(nu, plane, young):
    mu = young / (2 * (1 + nu))
    lam = young * nu / (1 - nu**2) if plane == "stress" else young * nu / ((1 + nu) * (1 - 2 * nu))
    return lam, mu


def faces(mesh, number, inside):
    """Region of the outer faces whose points are all inside."""
    outer = mesh.outer_faces()
    points, chosen = mesh.pts(), []
    for cell, face in outer.T:
        ids = mesh.pid_in_faces(np.array([[cell], [face]]))
        if all(inside(points[:, i]) for i in ids):
            chosen.append((cell, face))
    mesh.set_region(number, np.array(chosen).T)


def zone_end(x, size, loose):
    """Where the zone ends in which 'loose' holds, as FrictionBeam takes it (doc/continuum.md)."""
    n = 0
    while n < len(x) and loose[n]:
        n += 1
    if n < 2 or n == len(x):
        return x[min(n, len(x) - 1)]
    here, before = abs(size[n - 1]) ** (2 / 3), abs(size[n - 2]) ** (2 / 3)
    fall = (before - here) / (x[n - 1] - x[n - 2])
    return min(x[n], x[n - 1] + here / fall) if fall > 0 else 0.5 * (x[n - 1] + x[n])


def surface_dofs(mf, region):
    dofs = mf.basic_dof_on_region(region)
    nodes = mf.basic_dof_nodes()[0, dofs]
    order = np.argsort(nodes, kind="stable")
    return dofs[order], nodes[order]


def solve(model):
    iterations, converged = model.solve("max_res", 1e-9, "max_iter", 100, "lsearch", "simplest",
                                        "lsolver", "mumps")
    if not converged:
        raise RuntimeError("GetFEM's Newton method does not converge")


def getfem_slab(X, Y, degree, nu, plane):
    """Quantities, unknowns and time of GetFEM on the tensor mesh of X and Y."""
    start = time.perf_counter()
    mesh = gf.Mesh("cartesian", X, Y)
    height = Y[-1]
    tol = 1e-9
    TOP, BOTTOM, LEFT = 1, 2, 3
    faces(mesh, TOP, lambda p: p[1] > height - tol)
    faces(mesh, BOTTOM, lambda p: p[1] < tol)
    faces(mesh, LEFT, lambda p: p[0] < tol)
    for i, x in enumerate((2, 4, 6)):
        faces(mesh, 10 + i, lambda p: p[1] > height - tol and p[0] < x + tol)
    mfu, mfl = gf.MeshFem(mesh, 2), gf.MeshFem(mesh, 1)
    mfu.set_classical_fem(degree)
    mfl.set_classical_fem(degree)
    mim = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,%d)" % (2 * degree)))
    model = gf.Model("real")
    model.add_fem_variable("u", mfu)
    model.add_filtered_fem_variable("t", mfl, TOP)
    model.add_filtered_fem_variable("m", mfl, BOTTOM)
    lam, mu = lame(nu, plane, E)
    for name, value in (("lam", lam), ("mu", mu), ("r", E / height), ("g", BOUND)):
        model.add_initialized_data(name, [value])
    model.add_isotropic_linearized_elasticity_brick(mim, "u", "lam", "mu")
    model.add_linear_term(mim, "-m*Test_u(2)-u(2)*Test_m", BOTTOM)
    model.add_source_term(mim, "%.17g*Test_u(2)" % -P, TOP)
    model.add_source_term(mim, "%.17g*Test_u(1)" % (F / height), LEFT)
    model.add_nonlinear_term(
        mim, "-t*Test_u(1)+(t-min(max(t-r*u(1),-g),g))/r*Test_t", TOP)
    solve(model)
    seconds = time.perf_counter() - start

    u = model.variable("u")
    top, x = surface_dofs(mfu, TOP)
    x, slip = x[::2], np.abs(u[top[::2]])
    loose = slip > 1e-7 * slip.max()
    values = {"slip_length": zone_end(x, slip, loose)}
    for i, name in enumerate(("N_2", "N_4", "N_6")):
        values[name] = F + gf.asm_generic(mim, 0, "t", 10 + i, model)
    values["u_0_mean"] = gf.asm_generic(mim, 0, "u(1)", LEFT, model) / height
    return values, model.nbdof(), seconds
