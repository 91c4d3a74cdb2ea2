#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves the slab of prm/verification/slab_continuum.prm in three dimensions in GetFEM (Debian's
python3-getfem, its own Newton method on multipliers of the friction, MUMPS) and in FrictionBeam, one
process each, one after the other, and compares processor times at the same error.

  against_getfem_3d.py BUILD_FOLDER [--quick]

References: the finest run of FrictionBeam. Error: the largest relative one of N_4, N_6 and u_0_mean.
GetFEM's time: from the mesh to the solution. FrictionBeam's: that of the whole process (its libraries, the
quantities and the files as well). Processor times, since a busy machine stretches the others; one thread.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
CASE = os.path.join(HERE, "..", "verification", "slab_continuum.prm")
E, NU, P, F, BOUND = 1000.0, 0.3, 10.0, 12.0, 3.0
LENGTH, HEIGHT, WIDTH = 8.0, 1.0, 1.0
NAMES = ("N_4", "N_6", "u_0_mean")


def getfem_slab(degree, n):
    """Quantities, unknowns and processor time, with n cells across the height."""
    import getfem as gf
    gf.util_trace_level(0)
    start = time.process_time()
    lines = [np.linspace(0, size, max(1, round(size * n)) + 1) for size in (LENGTH, HEIGHT, WIDTH)]
    mesh = gf.Mesh("cartesian", *lines)
    points = mesh.pts()

    def faces(number, inside):
        outer, chosen = mesh.outer_faces(), []
        for cell, face in outer.T:
            ids = mesh.pid_in_faces(np.array([[cell], [face]]))
            if all(inside(points[:, i]) for i in ids):
                chosen.append((cell, face))
        mesh.set_region(number, np.array(chosen).T)

    tol, TOP, BOTTOM, LEFT = 1e-9, 1, 2, 3
    faces(TOP, lambda p: p[1] > HEIGHT - tol)
    faces(BOTTOM, lambda p: p[1] < tol)
    faces(LEFT, lambda p: p[0] < tol)
    for i, x in enumerate((4, 6)):
        faces(10 + i, lambda p: p[1] > HEIGHT - tol and p[0] < x + tol)
    mfu, mft, mfl = gf.MeshFem(mesh, 3), gf.MeshFem(mesh, 2), gf.MeshFem(mesh, 1)
    for space in (mfu, mft, mfl):
        space.set_classical_fem(degree)
    mim = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,%d)" % (2 * degree)))
    model = gf.Model("real")
    model.add_fem_variable("u", mfu)
    model.add_filtered_fem_variable("t", mft, TOP)
    model.add_filtered_fem_variable("m", mfl, BOTTOM)
    lam, mu = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
    for name, value in (("lam", lam), ("mu", mu), ("r", E / HEIGHT), ("g", BOUND)):
        model.add_initialized_data(name, [value])
    model.add_isotropic_linearized_elasticity_brick(mim, "u", "lam", "mu")
    model.add_linear_term(mim, "-m*Test_u(2)-u(2)*Test_m", BOTTOM)
    model.add_source_term(mim, "%.17g*Test_u(2)" % -P, TOP)
    model.add_source_term(mim, "%.17g*Test_u(1)" % (F / HEIGHT / WIDTH), LEFT)
    trial = "([t(1)-r*u(1);t(2)-r*u(3)])"
    held = "(%s*min(1,g/max(1e-12,Norm(%s))))" % (trial, trial)
    model.add_nonlinear_term(mim, "-t(1)*Test_u(1)-t(2)*Test_u(3)+(t-%s).Test_t/r" % held, TOP)
    iterations, converged = model.solve("max_res", 1e-9, "max_iter", 100, "lsearch", "simplest",
                                        "lsolver", "mumps")
    if not converged:
        raise RuntimeError("GetFEM's Newton method does not converge")
    seconds = time.process_time() - start
    values = {"N_4": F + gf.asm_generic(mim, 0, "t(1)", 10, model),
              "N_6": F + gf.asm_generic(mim, 0, "t(1)", 11, model),
              "u_0_mean": gf.asm_generic(mim, 0, "u(1)", LEFT, model) / HEIGHT / WIDTH}
    return values, model.nbdof(), seconds


def ours(program, *options):
    """The same of FrictionBeam, and its method."""
    command = [program, CASE]
    for option in ("Continuum/Dimension = 3", "Output/VTU = false", "Output/Report = false") + options:
        command += ["--set", option]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(command + ["--output-directory", folder], check=True, stdout=subprocess.DEVNULL)
        summary = json.load(open(os.path.join(folder, "summary.json")))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return {q["name"]: q["value"] for q in summary["quantities"]}, summary["cost"]["unknowns"], seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?")
    parser.add_argument("--one", nargs=2, metavar=("DEGREE", "N"), help="GetFEM alone, in this process")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    if arguments.one:
        print(json.dumps(getfem_slab(int(arguments.one[0]), float(arguments.one[1]))))
        return
    if arguments.build is None:
        parser.error("BUILD_FOLDER is missing")
    program = os.path.join(arguments.build, "bin", "frictionbeam")

    def uniform(degree, n):
        return ours(program, "Continuum/Refinement = none", "Continuum/Degree = %d" % degree,
                    "Continuum/Cells = %d" % n)

    finest = (3, 4) if arguments.quick else (3, 6)
    reference = uniform(*finest)
    print("reference: degree %d, %d cells across, %d unknowns: %s" % (*finest, reference[1], reference[0]))

    def show(program, setting, values, unknowns, seconds):
        error = max(abs(values[name] / reference[0][name] - 1) for name in NAMES)
        print("| %s | %s | %d | %.1e | %.2f |" % (program, setting, unknowns, error, seconds), flush=True)

    print("| program | setting | unknowns | largest error | processor seconds |\n"
          "| --- | --- | --- | --- | --- |")
    for degree, n in ((2, 1), (2, 2)) if arguments.quick else ((2, 1), (2, 2), (2, 3), (2, 4), (3, 2)):
        setting = "degree %d, %d cells across" % (degree, n)
        done = subprocess.run([sys.executable, os.path.abspath(__file__), "--one", str(degree), str(n)],
                              stdout=subprocess.PIPE, text=True)
        if done.returncode == 0:
            show("GetFEM", setting, *json.loads(done.stdout.splitlines()[-1]))
        else:
            print("GetFEM, %s: no answer" % setting)
        show("FrictionBeam", setting, *uniform(degree, n))
    for tolerance in ("0.5", "0.2"):
        show("FrictionBeam", "degree 2, adaptive, `Tolerance = %s`" % tolerance,
             *ours(program, "Continuum/Degree = 2", "Continuum/Cells = 1",
                   "Continuum/Tolerance = " + tolerance))


if __name__ == "__main__":
    main()
