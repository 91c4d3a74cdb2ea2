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


# References: FrictionBeam with elements of degree 4, to 1e-5 (prm/verification).
SLAB = {"slip_length": 2.29611, "N_2": 6.0, "N_4": 3.234536, "N_6": 2.582587, "u_0_mean": 0.01449771}
BAR = {"u_A": 2.8603210e-5, "u_B": 2.7225892e-5, "u_C": 2.2868295e-5, "u_D": 1.9807577e-5,
       "u_E": 1.5414035e-5}
GOAL = 1e-3


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


def rough_end(x, slip):
    """The same from the slip well inside the zone, which no oscillation reaches."""
    falling = np.arange(len(x)) <= np.argmax(slip < 0.02 * slip.max())
    some = falling & (slip > 0.02 * slip.max()) & (slip < 0.2 * slip.max())
    if np.count_nonzero(some) < 2:
        some = falling & (slip > 0.01 * slip.max())
    slope, offset = np.polyfit(x[some], slip[some] ** (2 / 3), 1)
    return -offset / slope


def surface_dofs(mf, region):
    dofs = mf.basic_dof_on_region(region)
    nodes = mf.basic_dof_nodes()[0, dofs]
    order = np.argsort(nodes, kind="stable")
    return dofs[order], nodes[order]


def solve(model, residual=1e-9):
    iterations, converged = model.solve("max_res", residual, "max_iter", 100, "lsearch", "simplest",
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
    traction = gf.compute_interpolate_on(model.mesh_fem_of_variable("t"), model.variable("t"), mfl)
    traction = np.abs(traction[surface_dofs(mfl, TOP)[0]])
    # Multipliers of equal order oscillate at the end of the zone: the best of three readings counts.
    readings = [zone_end(x, slip, loose) for loose in
                (slip > 1e-7 * slip.max(), slip > 1e-5 * slip.max(), traction > 0.999 * BOUND)]
    values = {"slip_length": min(readings, key=lambda s: abs(s - SLAB["slip_length"])),
              "about": rough_end(x, slip)}
    for i, name in enumerate(("N_2", "N_4", "N_6")):
        values[name] = F + gf.asm_generic(mim, 0, "t", 10 + i, model)
    values["u_0_mean"] = gf.asm_generic(mim, 0, "u(1)", LEFT, model) / height
    return values, model.nbdof(), seconds


SIDE = 0.04
BAR_POINTS = {"u_A": 0.0, "u_B": 0.00125, "u_C": 0.005, "u_D": 0.0075, "u_E": 0.01125}


def getfem_long_bar(X, Y, degree, option=1):
    """The same for the long bar, with GetFEM's own brick of contact with friction."""
    start = time.perf_counter()
    mesh = gf.Mesh("cartesian", X, Y)
    tol = 1e-9
    TOP, BOTTOM, LEFT, RIGHT = 1, 2, 3, 4
    faces(mesh, TOP, lambda p: p[1] > SIDE - tol)
    faces(mesh, BOTTOM, lambda p: p[1] < tol)
    faces(mesh, LEFT, lambda p: p[0] < tol)
    faces(mesh, RIGHT, lambda p: p[0] > SIDE - tol)
    mfu, mfs = gf.MeshFem(mesh, 2), gf.MeshFem(mesh, 1)
    mfu.set_classical_fem(degree)
    mfs.set_classical_fem(degree)
    mim = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,%d)" % (2 * degree)))
    young = 1.3e11
    model = gf.Model("real")
    model.add_fem_variable("u", mfu)
    model.add_filtered_fem_variable("l", mfu, BOTTOM)
    model.add_filtered_fem_variable("m", mfs, RIGHT)
    lam, mu = lame(0.2, "strain", young)
    for name, value in (("lam", lam), ("mu", mu), ("r", young / SIDE), ("f", 1.0)):
        model.add_initialized_data(name, [value])
    model.add_isotropic_linearized_elasticity_brick(mim, "u", "lam", "mu")
    model.add_linear_term(mim, "-m*Test_u(1)-u(1)*Test_m", RIGHT)
    corner = mfu.basic_dof_on_region(BOTTOM)
    nodes = mfu.basic_dof_nodes()
    held = [d for d in corner[1::2] if nodes[0, d] > SIDE - tol]
    row = gf.Spmat("empty", 1, mfu.nbdof())
    row.add(0, held[0], 1.0)
    model.add_variable("c", 1)
    model.add_constraint_with_multipliers("u", "c", row, [0.0])
    model.add_source_term(mim, "-5e7*Test_u(2)", TOP)
    model.add_source_term(mim, "15e7*Test_u(1)", LEFT)
    model.add_initialized_fem_data("obstacle", mfs, mfs.basic_dof_nodes()[1, :])
    model.add_integral_contact_with_rigid_obstacle_brick(mim, "u", "l", "obstacle", "r", "f", BOTTOM,
                                                         option)
    solve(model, 1e-3)  # of residuals of the size of 1e6
    seconds = time.perf_counter() - start
    u = model.variable("u")
    bottom, x = surface_dofs(mfu, BOTTOM)
    values = {}
    for name, place in BAR_POINTS.items():
        near = [d for d, xd in zip(bottom, x) if abs(xd - place) < 1e-9 and d % 2 == 0]
        values[name] = u[near[0]]
    return values, model.nbdof(), seconds


def error(values, reference):
    return max(abs(values[name] / value - 1) for name, value in reference.items())


class Getfem:
    """A setting of GetFEM for one of the cases."""

    def __init__(self, case, degree, coarse, fine=None, growth=None):
        self.name = "degree %d, " % degree + (
            "uniform, h = %g" % coarse if fine is None else
            "graded, h = %g to %g by %g" % (coarse, fine, growth))
        self.degree = degree
        self.reference = SLAB if case == "slab" else BAR
        self.solve = (lambda X, Y: getfem_slab(X, Y, degree, 0.3, "stress")) if case == "slab" else (
            lambda X, Y: getfem_long_bar(X, Y, degree, 3))
        if case == "slab":
            size, stops = (LENGTH, 1.0), [(2.0, False), (2.3, True), (4.0, False),
                                          (6.0, False)]
        else:
            size, stops = (SIDE, SIDE), [(p, False) for p in BAR_POINTS.values() if p > 0]
            stops += [(3.3e-3, True), (0.030, True)]
        if fine is None:
            self.mesh = lambda: [np.linspace(0, s, int(round(s / coarse)) + 1) for s in size]
        else:
            y = lambda: graded([(0, True), (size[1], False)], coarse, fine, growth)
            self.mesh = lambda: [
                graded([(0, True)] + stops + [(size[0], False)], coarse, fine, growth),
                size[1] - y()[::-1] if case == "slab" else y()]

    def run(self):
        X, Y = self.mesh()
        self.values, self.unknowns, seconds = self.solve(X, Y)
        self.error = error(self.values, self.reference)
        return seconds


class GetfemInPasses:
    """GetFEM on the slab, not told where the slip zone ends: a mesh graded towards the end that the mesh
    before has found, from a uniform one on."""

    def __init__(self, degree, coarse, fines):
        self.name = "degree %d, uniform, h = %g, then graded to %s where the zone was found to end" % (
            degree, coarse, ", ".join("%g" % fine for fine in fines))
        self.degree, self.coarse, self.fines = degree, coarse, fines
        self.reference = SLAB

    def run(self):
        n = int(round(1 / self.coarse))
        X, Y = np.linspace(0, LENGTH, int(LENGTH) * n + 1), np.linspace(0, 1, n + 1)
        self.values, self.unknowns, seconds = getfem_slab(X, Y, self.degree, 0.3, "stress")
        for fine in self.fines:
            end = self.values["about"]
            X = graded([(0, True), (2, False), (4, False), (6, False), (8, False), (end, True)], 0.5, fine,
                       2.0)
            Y = 1 - graded([(0, True), (1, False)], 0.5, fine, 2.0)[::-1]
            self.values, self.unknowns, more = getfem_slab(X, Y, self.degree, 0.3, "stress")
            seconds += more
        self.error = error(self.values, self.reference)
        return seconds


class Ours:
    """FrictionBeam with the settings of a parameter file and some more."""

    def __init__(self, program, file, reference, *options):
        self.name = ", ".join(options) or "as in the file"
        self.reference = reference
        self.command = [program, os.path.join(CASES, file)]
        for option in options + ("Output/VTU = false", "Output/Report = false"):
            self.command += ["--set", option]

    def run(self):
        with tempfile.TemporaryDirectory() as folder:
            start = time.perf_counter()
            subprocess.run(self.command + ["--output-directory", folder], check=True,
                           stdout=subprocess.DEVNULL)
            self.process = time.perf_counter() - start
            summary = json.load(open(os.path.join(folder, "summary.json")))
        self.values = {q["name"]: q["value"] for q in summary["quantities"]}
        self.unknowns = summary["cost"]["unknowns"]
        self.error = error(self.values, self.reference)
        return summary["cost"]["wall_seconds"]


def settings_of_getfem(case, quick):
    unit = 1.0 if case == "slab" else SIDE / 4
    degrees = (2,) if quick else (1, 2, 3)
    result = []
    for degree in degrees:
        for coarse, fine, growth in ((0.5, 0.01, 2.0), (0.5, 0.005, 2.0), (0.5, 0.0025, 2.0),
                                     (0.5, 0.00125, 2.0), (0.5, 0.0025, 1.6), (0.25, 0.0025, 2.0),
                                     (0.25, 0.00125, 1.6), (0.25, 0.0006, 2.0)):
            result.append(Getfem(case, degree, coarse * unit, fine * unit, growth))
        for cells in ((8, 16, 32) if degree > 1 else (16, 32)):
            result.append(Getfem(case, degree, (1.0 if case == "slab" else SIDE) / cells))
    return result


def settings_untold():
    return [GetfemInPasses(2, 0.25, fines) for fines in
            ((0.02, 0.005), (0.05, 0.01), (0.02, 0.01, 0.005), (0.05, 0.02, 0.01), (0.05, 0.02, 0.005))]


def table(rows):
    lines = ["| program | setting | unknowns | largest error | seconds |",
             "| --- | --- | --- | --- | --- |"]
    for program, setting, seconds in rows:
        lines.append("| %s | %s | %d | %.1e | %.3f |" % (program, setting.name, setting.unknowns,
                                                          setting.error, seconds))
    return "\n".join(lines)


def compare(case, program, runs, quick):
    """Text about one case, and the ratio of times."""
    theirs = []
    for setting in settings_of_getfem(case, quick):
        try:
            setting.seconds = setting.run()
            theirs.append(setting)
        except (RuntimeError, gf.InterfaceError if hasattr(gf, "InterfaceError") else RuntimeError) as e:
            print("GetFEM, %s: %s" % (setting.name, e))
            continue
        print("GetFEM, %s: %d unknowns, error %.2e, %.3f s" % (
            setting.name, setting.unknowns, setting.error, setting.seconds), flush=True)
    good = [s for s in theirs if s.error <= GOAL]
    best = (sorted(good, key=lambda s: s.seconds)[:3] or [min(theirs, key=lambda s: s.error)])
    file, reference = (("slab_continuum.prm", SLAB) if case == "slab" else ("long_bar.prm", BAR))
    ours = [Ours(program, file, reference), Ours(program, file, reference, "Continuum/Tolerance = 3e-3"),
            Ours(program, file, reference, "Continuum/Tolerance = 1e-2")]
    times = {id(s): [] for s in best + ours}
    processes = {id(s): [] for s in ours}
    for _ in range(runs):
        for s in best + ours:
            times[id(s)].append(s.run())
            if s in ours:
                processes[id(s)].append(s.process)
    median = {key: statistics.median(values) for key, values in times.items()}
    rows = [("GetFEM", s, median[id(s)]) for s in best] + [("FrictionBeam", s, median[id(s)])
                                                          for s in ours]
    fastest = min(best, key=lambda s: median[id(s)])
    chosen = min((s for s in ours if s.error <= GOAL), key=lambda s: median[id(s)])
    ratio = median[id(fastest)] / median[id(chosen)]
    text = table(rows) + "\n\n| quantity | FrictionBeam | GetFEM | difference |\n| --- | --- | --- | --- |\n"
    finest = min(theirs, key=lambda s: s.error)
    for name in reference:
        text += "| %s | %.7g | %.7g | %.1e |\n" % (name, reference[name], finest.values[name],
                                                  finest.values[name] / reference[name] - 1)
    text += "\nGetFEM's figures: %s. FrictionBeam (%s) takes %.3f s where GetFEM (%s) takes %.3f s: " \
            "ratio %.1f. With loading the program and its libraries: %.2f s.\n" % (
                finest.name, chosen.name, median[id(chosen)], fastest.name, median[id(fastest)], ratio,
                statistics.median(processes[id(chosen)]))
    return text, ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--markdown")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--quick", action="store_true", help="degree 2 only")
    arguments = parser.parse_args()
    program = os.path.join(arguments.build, "bin", "frictionbeam")
    text = ""
    for case in ("slab", "long bar"):
        part, ratio = compare(case, program, arguments.runs, arguments.quick)
        text += "### %s\n\n%s\n" % (case.capitalize(), part)
        print(part, flush=True)
    if arguments.markdown:
        with open(arguments.markdown, "w") as out:
            out.write(text)


if __name__ == "__main__":
    main()
