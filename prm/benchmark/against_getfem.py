#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves the continuum slab and the long bar in GetFEM (Debian's python3-getfem) and in FrictionBeam,
compares the results, and measures how long either needs to come within 0.1 % of the references.

  against_getfem.py BUILD_FOLDER [--markdown FILE] [--quick]
  against_getfem.py --one CASE SETTING       one run of GetFEM, for `frictionbeam chart` and for main()

GetFEM solves the same weak problem with a multiplier of the friction (and contact) traction and its own
semismooth Newton method, on quadrilaterals of several degrees, on uniform meshes and on meshes graded
towards the end of the slip zone and the corners, whose place it is told.

One measure for both: mesh, assembly and solution, of all meshes of a refinement, in a process of its own
for each run, without start of the process, libraries, files read and written. (FrictionBeam's time has the
evaluation of the quantities in it, GetFEM's has not.) One thread each. Medians of runs in turn.

One reading for both of the length of the slip zone: zone_end() below, from the slips at the nodes of the
surface alone. (GetFEM's zones of the long bar, which only the charts show, are read in the same way.) All settings are tried first; the fastest within the goal are then measured again.

A SETTING of GetFEM: DEGREE:COARSE, a uniform mesh, or DEGREE:COARSE:FINE:GROWTH, graded; COARSE and FINE
are sizes of cells [m], for the bar in parts of a quarter of its side. DEGREE:COARSE+FINE+FINE ..: first
uniform, then graded towards the end that the mesh before has found.
"""
import argparse
import csv
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


def zone_end(x, slip, least=1e-3):
    """Where the slip zone ends that begins at x[0]. The zone: the nodes from there on whose slip is more
    than a thousandth of the largest. Slip goes to zero as distance^(3/2): a parabola through its power 2/3
    at four nodes of the zone, the last one left out, meets zero there (as FrictionBeam takes its own
    slip_length, doc/continuum.md, where the zone is that of the nodes that slip)."""
    slip = np.abs(slip)
    inside = slip > least * slip.max()
    n = len(x) if inside.all() else int(np.argmin(inside))
    if n < 5:
        return x[max(n - 1, 0)]
    chosen = slice(n - 5, n - 1)
    curve = np.polyfit(x[chosen] - x[n - 1], slip[chosen] ** (2 / 3), 2)
    roots = [r.real for r in np.roots(curve) if abs(r.imag) < 1e-12]
    return x[n - 1] + min(roots, key=abs) if roots else x[n - 1]


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
    values = {"slip_length": zone_end(x[::2], u[top[::2]])}
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
    # At points that need not be nodes; one between cells comes once for each.
    places = gf.Slice("points", mesh, np.array([list(BAR_POINTS.values()), [0.0] * len(BAR_POINTS)]))
    at_points = gf.compute_interpolate_on(mfu, u, places)
    values = {name: at_points[0, np.argmin(np.abs(places.pts()[0] - place))]
              for name, place in BAR_POINTS.items()}
    bottom, x = surface_dofs(mfu, BOTTOM)
    values["open_length"] = zone_end(x[::2], u[bottom[1::2]])
    values["slip_end"] = zone_end(x[::2], u[bottom[::2]])
    return values, model.nbdof(), seconds


def error(values, reference):
    return max(abs(values[name] / value - 1) for name, value in reference.items())


class Getfem:
    """A setting of GetFEM for one of the cases, of the form DEGREE:COARSE[:FINE:GROWTH]."""

    def __init__(self, case, setting):
        self.case, self.setting = case, setting
        self.reference = SLAB if case == "slab" else BAR
        unit = 1.0 if case == "slab" else SIDE / 4
        first, *self.fines = setting.split("+")
        numbers = first.split(":")
        self.degree, self.coarse = int(numbers[0]), float(numbers[1]) * unit
        self.fines = [float(fine) * unit for fine in self.fines]
        self.fine = float(numbers[2]) * unit if len(numbers) == 4 else None
        self.growth = float(numbers[3]) if len(numbers) == 4 else 2.0
        self.name = "degree %d, " % self.degree + (
            "uniform, h = %s" % numbers[1] if self.fine is None else
            "graded, h = %s to %s by %s" % tuple(numbers[1:]))
        if self.fines:
            self.name += ", then graded to %s where the zone was found to end" % ", ".join(
                setting.split("+")[1:])

    def uniform(self):
        return [np.linspace(0, s, int(round(s / self.coarse)) + 1)
                for s in ((LENGTH, 1.0) if self.case == "slab" else (SIDE, SIDE))]

    def graded(self, coarse, fine, end):
        if self.case == "slab":
            stops = [(0.0, True), (2.0, False), (end, True), (4.0, False), (6.0, False), (LENGTH, False)]
            return [graded(stops, coarse, fine, self.growth),
                    1.0 - graded([(0, True), (1.0, False)], coarse, fine, self.growth)[::-1]]
        stops = [(p, p == 0) for p in BAR_POINTS.values()] + [(3.3e-3, True), (end, True), (SIDE, False)]
        return [graded(stops, coarse, fine, self.growth),
                graded([(0, True), (SIDE, False)], coarse, fine, self.growth)]

    def solve(self, X, Y):
        if self.case == "slab":
            return getfem_slab(X, Y, self.degree, 0.3, "stress")
        return getfem_long_bar(X, Y, self.degree, 3)

    def run(self):
        mesh = self.uniform() if self.fine is None else self.graded(
            self.coarse, self.fine, 2.3 if self.case == "slab" else 0.030)
        self.values, self.unknowns, seconds = self.solve(*mesh)
        for fine in self.fines:
            mesh = self.graded(0.5 if self.case == "slab" else SIDE / 8, fine, self.values["slip_length"])
            self.values, self.unknowns, more = self.solve(*mesh)
            seconds += more
        self.error = error(self.values, self.reference)
        return seconds

    def run_alone(self):
        """Seconds of a run in a process of its own."""
        done = subprocess.run([sys.executable, os.path.abspath(__file__), "--one", self.case, self.setting],
                              stdout=subprocess.PIPE, check=True, text=True)
        return float(dict(line.split(" = ") for line in done.stdout.splitlines())["seconds"])


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
            with open(os.path.join(folder, "contact.csv")) as file:
                nodes = list(csv.DictReader(file))
        self.values = {q["name"]: q["value"] for q in summary["quantities"]}
        if "slip_length" in self.reference:
            self.values["slip_length"] = zone_end(np.array([float(n["x"]) for n in nodes]),
                                                  np.array([float(n["slip1"]) for n in nodes]))
        self.unknowns = summary["cost"]["unknowns"]
        self.error = error(self.values, self.reference)
        return sum(summary["cost"][part + "_seconds"] for part in ("mesh", "setup", "solve"))

    run_alone = run


def settings_of_getfem(case, quick):
    result = []
    for degree in (2,) if quick else (1, 2, 3, 4):
        for coarse in (1.0, 0.5, 1 / 3, 0.25, 0.2, 0.125, 0.0625):
            if (degree == 1 and coarse > 0.3) or (degree > 2 and coarse < 0.12 * degree / 2) or (
                    degree == 2 and coarse < 0.1):
                continue  # too coarse or too slow
            result.append("%d:%.6g" % (degree, coarse))
        for coarse, fine, growth in ((1, 0.1, 2), (0.5, 0.1, 2), (0.5, 0.04, 2), (0.5, 0.02, 2),
                                     (0.5, 0.01, 2), (0.25, 0.04, 1.6)):
            result.append("%d:%g:%g:%g" % (degree, coarse, fine, growth))
    if case == "slab":
        result += ["2:0.5+0.1", "2:0.5+0.04", "2:0.25+0.04", "3:1+0.1", "3:0.5+0.04"]
    return [Getfem(case, setting) for setting in result]


def settings_of_ours(case, program, quick):
    file, reference = ("slab_continuum.prm", SLAB) if case == "slab" else ("long_bar.prm", BAR)
    result = [Ours(program, file, reference, "Continuum/Tolerance = " + tolerance)
              for tolerance in ("1e-2", "3e-3", "1e-3")]
    cells = (1, 2, 3, 4, 5, 8) if case == "slab" else (4, 8, 12, 16, 24)
    for degree in (3,) if quick else (1, 2, 3, 4, 5):
        result += [Ours(program, file, reference, "Continuum/Refinement = none",
                        "Continuum/Degree = %d" % degree, "Continuum/Cells = %d" % n) for n in cells]
    return result


def table(rows):
    lines = ["| program | setting | unknowns | largest error | seconds |",
             "| --- | --- | --- | --- | --- |"]
    for program, setting, seconds in rows:
        lines.append("| %s | %s | %d | %.1e | %.3f |" % (program, setting.name, setting.unknowns,
                                                          setting.error, seconds))
    return "\n".join(lines)


def try_all(program, settings):
    """Those that have an answer, with their errors and the time of a first run."""
    good = []
    for setting in settings:
        try:
            setting.seconds = setting.run()
        except (RuntimeError, subprocess.CalledProcessError) as problem:
            print("%s, %s: %s" % (program, setting.name, problem), flush=True)
            continue
        good.append(setting)
        print("%s, %s: %d unknowns, error %.2e, %.4f s" % (
            program, setting.name, setting.unknowns, setting.error, setting.seconds), flush=True)
    return good


def fastest_within_goal(settings, n):
    good = [s for s in settings if s.error <= GOAL]
    return sorted(good, key=lambda s: s.seconds)[:n] or [min(settings, key=lambda s: s.error)]


def compare(case, program, runs, quick):
    """Text about one case, and the ratio of times."""
    theirs = try_all("GetFEM", settings_of_getfem(case, quick))
    ours = try_all("FrictionBeam", settings_of_ours(case, program, quick))
    chosen = [("GetFEM", s) for s in fastest_within_goal(theirs, 4)]
    chosen += [("FrictionBeam", s) for s in fastest_within_goal(ours, 3)]
    adaptive = [s for s in ours if "Tolerance" in s.name and s.error <= GOAL]
    if adaptive:
        chosen.append(("FrictionBeam", min(adaptive, key=lambda s: s.seconds)))
    chosen = list(dict.fromkeys(chosen))
    times = {s: [] for _, s in chosen}
    for _ in range(runs):
        for _, s in chosen:
            times[s].append(s.run_alone())
    median = {s: statistics.median(times[s]) for s in times}
    best = {name: min((s for n, s in chosen if n == name), key=lambda s: median[s])
            for name in ("GetFEM", "FrictionBeam")}
    ratio = median[best["GetFEM"]] / median[best["FrictionBeam"]]
    text = table([(name, s, median[s]) for name, s in chosen])
    text += "\n\n| quantity | FrictionBeam | GetFEM | difference |\n| --- | --- | --- | --- |\n"
    finest = min(theirs, key=lambda s: s.error)
    for name, value in best["GetFEM"].reference.items():
        text += "| %s | %.7g | %.7g | %.1e |\n" % (name, value, finest.values[name],
                                                  finest.values[name] / value - 1)
    text += "\nGetFEM's figures: %s. FrictionBeam (%s) takes %.4f s where GetFEM (%s) takes %.4f s: " \
            "ratio %.1f.\n" % (finest.name, best["FrictionBeam"].name, median[best["FrictionBeam"]],
                               best["GetFEM"].name, median[best["GetFEM"]], ratio)
    return text, ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?")
    parser.add_argument("--one", nargs=2, metavar=("CASE", "SETTING"))
    parser.add_argument("--markdown")
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--quick", action="store_true", help="degree 2 and 3 only")
    arguments = parser.parse_args()
    if arguments.one:
        run = Getfem(*arguments.one)
        print("seconds =", run.run())
        print("unknowns =", run.unknowns)
        for name, value in run.values.items():
            print(name, "=", value)
        return
    if arguments.build is None:
        parser.error("BUILD_FOLDER is missing")
    program = os.path.join(arguments.build, "bin", "frictionbeam")
    text = ""
    for case in ("slab", "long bar"):
        part, _ = compare(case, program, arguments.runs, arguments.quick)
        text += "### %s\n\n%s\n" % (case.capitalize(), part)
        print(part, flush=True)
    if arguments.markdown:
        with open(arguments.markdown, "w") as out:
            out.write(text)


if __name__ == "__main__":
    main()
