#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves the slab of prm/verification/slab_continuum.prm in three dimensions (8 m x 1 m x 1 m) in GetFEM
(Debian's python3-getfem, MUMPS) and in FrictionBeam, and measures what either takes for an error.

  against_getfem_3d.py BUILD_FOLDER [--markdown FILE] [--runs N]
  against_getfem_3d.py --one SETTING       one run of GetFEM

GetFEM solves the same weak problem with a multiplier of the friction traction (two components, projected
on the disc of radius f p) and its own semismooth Newton method. The measure is that of against_getfem.py:
mesh, assembly and solution, one thread; processor time, since the machine may be shared. Each setting runs in
a process of its own. The error is the largest, relative, of N_4, N_6 (forces across sections) and u_0_mean.

A SETTING of GetFEM: DEGREE:SIZE, cubes. FrictionBeam's: as in the file but for what the table names.
"""
import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

from against_getfem import BOUND, CASES, E, F, LENGTH, P, error, faces, gf, lame, solve

# FrictionBeam, elements of degree 4, h = 0.25, 111,843 unknowns: to 1e-4, by the change from h = 0.5.
REFERENCE = {"N_4": 3.37831, "N_6": 2.706754, "u_0_mean": 0.01465218}
GETFEM = ("1:0.25", "2:0.5", "2:0.25")
OURS = ((1, 1, 3), (2, 1, 1), (2, 1, 2), (2, 1, 3))  # degree, cells of the first mesh along 1 m, refinements


def getfem_slab_3d(degree, size):
    """Quantities, unknowns and processor time of GetFEM."""
    start = time.process_time()
    n = int(round(1 / size))
    x = np.linspace(0, LENGTH, int(round(LENGTH / size)) + 1)
    side = np.linspace(0, 1, n + 1)
    mesh = gf.Mesh("cartesian", x, side, side)
    tol = 1e-9
    TOP, BOTTOM, LEFT = 1, 2, 3
    faces(mesh, TOP, lambda p: p[1] > 1 - tol)
    faces(mesh, BOTTOM, lambda p: p[1] < tol)
    faces(mesh, LEFT, lambda p: p[0] < tol)
    for i, end in enumerate((4, 6)):
        faces(mesh, 10 + i, lambda p: p[1] > 1 - tol and p[0] < end + tol)
    mfu, mft, mfm = gf.MeshFem(mesh, 3), gf.MeshFem(mesh, 2), gf.MeshFem(mesh, 1)
    for mf in (mfu, mft, mfm):
        mf.set_classical_fem(degree)
    mim = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,%d)" % (2 * degree)))
    model = gf.Model("real")
    model.add_fem_variable("u", mfu)
    model.add_filtered_fem_variable("t", mft, TOP)
    model.add_filtered_fem_variable("m", mfm, BOTTOM)
    lam, mu = lame(0.3, "strain", E)
    for name, value in (("lam", lam), ("mu", mu), ("r", E), ("g", BOUND)):
        model.add_initialized_data(name, [value])
    model.add_isotropic_linearized_elasticity_brick(mim, "u", "lam", "mu")
    model.add_linear_term(mim, "-m*Test_u(2)-u(2)*Test_m", BOTTOM)
    model.add_source_term(mim, "%.17g*Test_u(2)" % -P, TOP)
    model.add_source_term(mim, "%.17g*Test_u(1)" % F, LEFT)
    model.add_nonlinear_term(
        mim, "-t(1)*Test_u(1)-t(2)*Test_u(3)+(t-Ball_projection(t-r*[u(1);u(3)],g)).Test_t/r", TOP)
    solve(model)
    seconds = time.process_time() - start
    values = {"N_%d" % end: F + gf.asm_generic(mim, 0, "t(1)", 10 + i, model)
              for i, end in enumerate((4, 6))}
    values["u_0_mean"] = gf.asm_generic(mim, 0, "u(1)", LEFT, model)
    return values, model.nbdof(), seconds


class Getfem:
    def __init__(self, setting):
        self.setting = setting
        self.name = "degree %s, h = %s" % tuple(setting.split(":"))

    def run(self):
        done = subprocess.run([sys.executable, os.path.abspath(__file__), "--one", self.setting],
                              stdout=subprocess.PIPE, check=True, text=True)
        read = {key: float(value) for key, value in
                (line.split(" = ") for line in done.stdout.splitlines() if " = " in line)}
        self.unknowns, self.memory = read["unknowns"], read["memory"]
        self.values = {name: read[name] for name in REFERENCE}
        self.error = error(self.values, REFERENCE)
        return read["seconds"]


class FrictionBeam:
    """The slab with some settings: uniform refinements to the last, the meshes before included."""

    def __init__(self, program, degree, cells, refinements):
        self.name = "degree %d, h = %g, %d meshes" % (degree, 0.5**refinements / cells, refinements + 1)
        self.command = [program, os.path.join(CASES, "slab_continuum.prm"), "--quiet"]
        for option in ("Continuum/Dimension = 3", "Continuum/Degree = %d" % degree,
                       "Continuum/Cells = %d" % cells, "Continuum/Refinement = uniform",
                       "Continuum/Max refinements = %d" % refinements, "Continuum/Max unknowns = 10000000",
                       "Continuum/Tolerance = 1e-12", "Output/VTU = false", "Output/Report = false"):
            self.command += ["--set", option]

    def run(self):
        """Processor time of the whole program, its start and the files that it writes included."""
        with tempfile.TemporaryDirectory() as folder:
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            done = subprocess.run(self.command + ["--output-directory", folder])
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            if done.returncode not in (0, 2):  # 2: the tolerance is out of reach
                raise subprocess.CalledProcessError(done.returncode, self.command)
            summary = json.load(open(os.path.join(folder, "summary.json")))
        self.values = {q["name"]: q["value"] for q in summary["quantities"]}
        self.unknowns = summary["cost"]["unknowns"]
        self.memory = summary["cost"]["peak_memory_mb"]
        self.method = summary["method"]
        self.error = error(self.values, REFERENCE)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(settings, runs):
    """Those that have an answer, with their errors and median times."""
    good = []
    for setting in settings:
        try:
            setting.seconds = statistics.median(setting.run() for _ in range(runs))
        except (RuntimeError, subprocess.CalledProcessError) as problem:
            print("%s: %s" % (setting.name, problem), flush=True)
            continue
        good.append(setting)
        print("%s: %d unknowns, error %.2e, %.3f s, %.0f MB" % (
            setting.name, setting.unknowns, setting.error, setting.seconds, setting.memory), flush=True)
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?")
    parser.add_argument("--one", metavar="SETTING")
    parser.add_argument("--markdown")
    parser.add_argument("--runs", type=int, default=3)
    arguments = parser.parse_args()
    if arguments.one:
        degree, size = arguments.one.split(":")
        values, unknowns, seconds = getfem_slab_3d(int(degree), float(size))
        print("seconds =", seconds)
        print("unknowns =", unknowns)
        print("memory =", resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
        for name, value in values.items():
            print(name, "=", value)
        return
    if arguments.build is None:
        parser.error("BUILD_FOLDER is missing")
    program = os.path.join(arguments.build, "bin", "frictionbeam")
    theirs = measure([Getfem(s) for s in GETFEM], arguments.runs)
    ours = measure([FrictionBeam(program, *s) for s in OURS], arguments.runs)
    lines = ["| program | setting | unknowns | largest error | seconds | MB |",
             "| --- | --- | --- | --- | --- | --- |"]
    for program, settings in (("GetFEM", theirs), ("FrictionBeam", ours)):
        lines += ["| %s | %s | %d | %.1e | %.2f | %.0f |" % (
            program, s.name, s.unknowns, s.error, s.seconds, s.memory) for s in settings]
    lines.append("")
    for their in theirs:
        as_good = [s for s in ours if s.error <= their.error]
        if as_good:
            our = min(as_good, key=lambda s: s.seconds)
            lines.append("Error %.1e: GetFEM (%s) %.2f s, FrictionBeam (%s) %.2f s with %.1e: ratio %.1f." % (
                their.error, their.name, their.seconds, our.name, our.seconds, our.error,
                their.seconds / our.seconds))
    print("\n".join(lines))
    if arguments.markdown:
        with open(arguments.markdown, "w") as out:
            out.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
