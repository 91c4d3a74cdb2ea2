#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siconos and FrictionBeam on the same racks, in the same run.

    prm/benchmark/against_siconos.py [--output FOLDER] [--quick] [--limit SECONDS] [--program FILE]

Needs Debian's python3-siconos (and its numpy), a tool of this benchmark only. Three solvers of Siconos
get the condensed problem u = W r + q, mu ready-made; forming it is not charged. Each is tried on the
problem in SI units and in units in which the mean diagonal of W and the largest entry of q are 1,
with tolerances of 1e-8, 1e-10 and 1e-12 on its own measure, in a process of its own (some abort); the
quickest of these tries that reaches a scaled error of 1e-8 counts; it runs in one thread unless
OPENBLAS_NUM_THREADS says otherwise. FrictionBeam, as it is, is charged cost.setup_seconds +
cost.solve_seconds, everything but the mesh.

Three errors of each answer r, by one and the same check:
    scaled      || r - P_K(r - (u + mu |u_T| n)) || / || q ||, u = W r + q: the one of the literature
    own scale   || r - P_K(r - rho_i (u + mu |u_T| n)) || / || r ||, rho_i the stiffness of the line at
                the contact, u from the line itself and not by W, which loses digits
    apart       || r - r_FrictionBeam || / || r ||

Results go to FOLDER/siconos.json; stability.py makes the page from it.
"""
import argparse
import csv
import json
import multiprocessing
import os
import statistics
import subprocess
import sys
import tempfile
import time

# One thread for either program; with more, Siconos is slower on problems of this size. Read by numpy.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

import rack_delassus

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
CASES = [("plant", n, f) for n in (20, 100, 400) for f in (0.3, 1.0)]
CASES += [("planar", n, f) for n in (100, 400) for f in (0.3, 2.0)]
SOLVERS = {"Alart-Curnier Newton": "SICONOS_FRICTION_3D_NSN_AC",
           "Fischer-Burmeister Newton": "SICONOS_FRICTION_3D_NSN_FB",
           "NSGS": "SICONOS_FRICTION_3D_NSGS"}
DRIVERS = {"SICONOS_FRICTION_3D_NSN_AC": "fc3d_nonsmooth_Newton_AlartCurnier",
           "SICONOS_FRICTION_3D_NSN_FB": "fc3d_nonsmooth_Newton_FischerBurmeister",
           "SICONOS_FRICTION_3D_NSGS": "fc3d_nsgs"}
WANTED = 1e-8  # scaled error
TOLERANCES = (1e-8, 1e-10, 1e-12)  # tried in turn, on Siconos' own measure


def on_cone(r, mu):
    """Projection of each row on the cone |r_T| <= mu r_N."""
    normal, size = r[:, 0], np.hypot(r[:, 1], r[:, 2])
    onto = np.maximum((normal + mu * size) / (1 + mu**2), 0.0)
    slips = size > mu * normal
    result = r.copy()
    result[slips, 0] = onto[slips]
    shrink = (mu * onto)[slips] / size[slips]
    result[slips, 1:] = r[slips, 1:] * shrink[:, None]
    return result


def natural_map(r, u, mu, rho=1.0):
    """r - P_K(r - rho (u + mu |u_T| n)), a row a contact."""
    r, u = r.reshape(-1, 3), u.reshape(-1, 3).copy()
    u[:, 0] += mu * np.hypot(u[:, 1], u[:, 2])
    return r - on_cone(r - rho * u, mu)


def errors(rack, W, q, mu, r):
    scaled = np.linalg.norm(natural_map(r, W @ r + q, mu)) / np.linalg.norm(q)
    rho = rack.stiffness().reshape(-1, 3)
    own = np.linalg.norm(natural_map(r, rack.motion(r), mu, rho)) / np.linalg.norm(r)
    return float(scaled), float(own)


def solve_in_child(pipe, name, tolerance, W, q, mu):
    """One solver of Siconos; only the solver itself is timed."""
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)
        os.dup2(nothing.fileno(), 2)
    import siconos.numerics as numerics

    problem = numerics.FrictionContactProblem(3, W, q, mu)
    options = numerics.SolverOptions(getattr(numerics, name))
    options.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = 1000000 if name.endswith("NSGS") else 20000
    options.dparam[numerics.SICONOS_DPARAM_TOL] = tolerance
    r, u = np.zeros(len(q)), np.zeros(len(q))
    begin = time.perf_counter()
    getattr(numerics, DRIVERS[name])(problem, r, u, options)
    seconds = time.perf_counter() - begin
    pipe.send((r, seconds, int(options.iparam[numerics.SICONOS_IPARAM_ITER_DONE])))


def run_solver(name, tolerance, W, q, mu, limit):
    """@return (r, seconds, iterations) or why there is none."""
    receiver, sender = multiprocessing.Pipe(False)
    child = multiprocessing.Process(target=solve_in_child, args=(sender, name, tolerance, W, q, mu))
    child.start()
    sender.close()
    try:
        answer = receiver.recv() if receiver.poll(limit) else f"no answer in {limit:g} s"
    except EOFError:
        answer = "aborts"
    child.kill()
    child.join()
    return answer


def attempt(name, tolerance, rack, W, q, mu, length, force, limit):
    """A record of one try, in units of length and force; errors are taken in SI units."""
    record = {"tolerance": tolerance}
    for _ in range(3):  # the shortest of three, if it is short
        answer = run_solver(name, tolerance, W * (force / length), q / length, mu, limit)
        if isinstance(answer, str):
            return {"outcome": answer}
        r, seconds, iterations = answer
        if not np.all(np.isfinite(r)):
            return {"outcome": "not a number"}
        record["seconds"] = min(seconds, record.get("seconds", seconds))
        if seconds > 1.0:
            break
    record["r"] = r * force
    record["iterations"] = iterations
    record["scaled"], record["own"] = errors(rack, W, q, mu, record["r"])
    record["outcome"] = "solved" if record["scaled"] <= WANTED else "wrong"
    return record


def best_of_siconos(name, rack, W, q, mu, limit):
    """The quickest try that solves the problem, or the one that comes nearest."""
    tries = []
    largest = np.abs(q).max()
    for units, length, force in (("SI", 1.0, 1.0), ("scaled", largest, largest / np.diag(W).mean())):
        for tolerance in TOLERANCES:
            record = attempt(name, tolerance, rack, W, q, mu, length, force, limit)
            tries.append(dict(record, units=units))
            if record["outcome"] != "wrong":
                break
    return min(tries, key=lambda record: (0, record["seconds"]) if record["outcome"] == "solved"
               else (1, record.get("scaled", 1e300)))


def run_ours(program, kind, n, friction, n_runs, limit):
    with tempfile.TemporaryDirectory() as folder:
        seconds = []
        for _ in range(n_runs):
            command = [program, os.path.join(HERE, "rack_family.prm"), "--output-directory", folder]
            for entry in (f"Kind = {kind}", f"Spans = {n}", f"Friction = {friction}"):
                command += ["--set", "Rack/" + entry]
            try:
                subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               timeout=limit, check=True)
            except subprocess.TimeoutExpired:
                return None, {"outcome": f"no answer in {limit:g} s"}
            except subprocess.CalledProcessError as error:
                return None, {"outcome": f"exit status {error.returncode}"}
            with open(os.path.join(folder, "summary.json")) as file:
                summary = json.load(file)
            seconds.append(summary["cost"]["setup_seconds"] + summary["cost"]["solve_seconds"])
        with open(os.path.join(folder, "supports.csv")) as file:
            r = [float(row[name]) for row in csv.DictReader(file) for name in ("fn", "ft1", "ft2")]
    return np.array(r), {"outcome": "solved", "seconds": statistics.median(seconds),
                         "iterations": summary["cost"]["iterations"],
                         "certificate": summary["certificate"]["contact"]}


def run_case(case, arguments):
    kind, n, friction = case
    rack = rack_delassus.Rack(kind, n)
    begin = time.perf_counter()
    W, q = rack.condensed()
    record = {"kind": kind, "n": n, "friction": friction, "contacts": rack.n_contacts,
              "W_seconds": time.perf_counter() - begin}
    mu = np.full(rack.n_contacts, friction)
    r, ours = run_ours(arguments.program, kind, n, friction, 5, arguments.limit)
    if r is not None:
        ours["scaled"], ours["own"] = errors(rack, W, q, mu, r)
    solvers = {}
    for title, name in SOLVERS.items():
        answer = best_of_siconos(name, rack, W, q, mu, arguments.limit)
        theirs = answer.pop("r", None)
        if theirs is not None and r is not None:
            answer["apart"] = float(np.linalg.norm(theirs - r) / np.linalg.norm(r))
            answer["ratio"] = answer["seconds"] / ours["seconds"]
        solvers[title] = answer
    return dict(record, ours=ours, siconos=solvers)


def show(record):
    print("{kind} n = {n} f = {friction}: {contacts} contacts".format(**record))
    for title, answer in [("FrictionBeam", record["ours"])] + list(record["siconos"].items()):
        figures = [f"{key} {answer[key]:.3g}" for key in
                   ("seconds", "iterations", "scaled", "own", "apart", "ratio") if key in answer]
        print(f"  {title:26}{answer['outcome']}", *figures, answer.get("units", ""), sep="  ")
    sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--output", default=os.path.join(ROOT, "output", "stability"))
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "frictionbeam"))
    parser.add_argument("--limit", type=float, default=60.0, help="seconds a run")
    parser.add_argument("--quick", action="store_true", help="n up to 100")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    records = []
    for case in CASES:
        if arguments.quick and case[1] > 100:
            continue
        records.append(run_case(case, arguments))
        show(records[-1])
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "python3-siconos"],
                             stdout=subprocess.PIPE, text=True).stdout
    with open(os.path.join(arguments.output, "siconos.json"), "w") as file:
        json.dump({"date": time.strftime("%Y-%m-%d"), "version": version,
                   "threads": os.environ["OPENBLAS_NUM_THREADS"], "limit": arguments.limit,
                   "records": records}, file, indent=1)


if __name__ == "__main__":
    main()
