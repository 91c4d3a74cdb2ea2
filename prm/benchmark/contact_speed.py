#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""FrictionBeam and the solvers of Siconos on the contact problems of contact_problems.py.

    prm/benchmark/contact_speed.py [--output FOLDER] [--limit SECONDS] [--only NAME ...] [--write-page]

Needs Debian's python3-siconos, python3-h5py and python3-scipy, tools of this benchmark only. Every solver
gets W, q, mu ready-made and is charged the seconds of computing of its call alone (of the thread, not of the
clock on the wall: the machine may do other work), on one thread, in a process of its own, first call and
all. FrictionBeam is "frictionbeam contact FILE" with its tolerance of 1e-8, which holds every contact to
that on its own scale; the median of five runs counts. Siconos is given W dense and sparse in turn, and
1e-8, 1e-9, 1e-10 on its own measure until the measure of the literature,
|| r - P_K(r - (u + mu |u_T| n)) || / || q ||, is below 1e-8: it is the quickest of all these tries that counts,
by hindsight, which no user has. SECONDS of computing are for one try.

Results go to FOLDER/contact_speed.json, and with --write-page into the table of doc/fclib.md.
"""
import argparse
import json
import math
import multiprocessing
import os
import re
import resource
import statistics
import subprocess
import time

os.environ["OPENBLAS_NUM_THREADS"] = os.environ["OMP_NUM_THREADS"] = "1"  # read by numpy

import h5py
import numpy as np
import scipy.sparse as sparse

import contact_problems

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PAGE = os.path.join(ROOT, "doc", "fclib.md")
WANTED = 1e-8
SOLVERS = {"NSGS": "fc3d_nsgs", "ADMM": "fc3d_admm", "PROX": "fc3d_proximal",
           "PFP": "fc3d_Panagiotopoulos_FixedPoint", "NSN_AC": "fc3d_nonsmooth_Newton_AlartCurnier",
           "NSN_FB": "fc3d_nonsmooth_Newton_FischerBurmeister"}


def read(path):
    with h5py.File(path) as file:
        group = file["fclib_local"]
        W, n = group["W"], int(group["W/m"][0])
        matrix = sparse.csc_matrix((W["x"][:], W["i"][:], W["p"][:]), shape=(n, n))
        return int(group["spacedim"][0]), matrix, group["vectors/q"][:], group["vectors/mu"][:]


def scaled_error(dimension, W, q, mu, r):
    """The measure of the literature."""
    if not np.all(np.isfinite(r)):
        return np.inf
    u = (W @ r + q).reshape(-1, dimension)
    u[:, 0] += mu * np.linalg.norm(u[:, 1:], axis=1)
    forces = r.reshape(-1, dimension)
    trial = forces - u
    shear = np.linalg.norm(trial[:, 1:], axis=1)
    onto = np.maximum((trial[:, 0] + mu * shear) / (1 + mu**2), 0.0)
    nearest, out = trial.copy(), shear > mu * trial[:, 0]
    nearest[out, 0] = onto[out]
    nearest[out, 1:] *= (mu * onto / np.where(shear > 0, shear, 1.0))[out, None]
    return float(np.linalg.norm(forces - nearest) / np.linalg.norm(q))


def solve_in_child(pipe, limit, name, tolerance, dimension, W, q, mu):
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)
        os.dup2(nothing.fileno(), 2)
    import siconos.numerics as numerics

    problem = numerics.FrictionContactProblem(dimension, W, q, mu)
    options = numerics.SolverOptions(getattr(numerics, f"SICONOS_FRICTION_{dimension}D_{name}"))
    options.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = 10000000
    options.dparam[numerics.SICONOS_DPARAM_TOL] = tolerance
    driver = getattr(numerics, SOLVERS[name] if dimension == 3 else "fc2d_driver")
    r, u = np.zeros(len(q)), np.zeros(len(q))
    begin = time.thread_time()  # with a limit the clock of the process goes by ticks
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(begin + limit), resource.RLIM_INFINITY))
    driver(problem, r, u, options)
    pipe.send((r, time.thread_time() - begin))


def run_solver(limit, *task):
    """@return (r, seconds), or nothing where it aborts or takes too long."""
    receiver, sender = multiprocessing.Pipe(False)
    child = multiprocessing.Process(target=solve_in_child, args=(sender, limit, *task))
    child.start()
    sender.close()
    try:
        answer = receiver.recv()
    except EOFError:
        answer = None
    child.kill()
    child.join()
    return answer


def siconos(dimension, W, q, mu, limit):
    """Seconds of each solver and storage that solves the problem."""
    seconds = {}
    for name in SOLVERS if dimension == 3 else ["NSGS", "CPG", "LEMKE"]:
        for storage, matrix in (("dense", W.toarray()), ("sparse", W)):
            for tolerance in (1e-8, 1e-9, 1e-10):
                answer = run_solver(limit, name, tolerance, dimension, matrix, q, mu)
                if answer is None:
                    break
                if scaled_error(dimension, W, q, mu, answer[0]) <= WANTED:
                    seconds[f"{name} {storage}"] = answer[1]
                    break
    return seconds


def ours(program, path, limit):
    found = []
    for _ in range(5):  # its own limit goes by the clock on the wall
        run = subprocess.run([program, "contact", f"--time-limit={20 * limit}", path],
                             stdout=subprocess.PIPE, text=True)
        found.append(float(re.search(r", (\S+) s of computing", run.stdout).group(1)))
        if run.returncode != 0 or found[0] > limit:
            return None, found[0]
        if found[0] > 2:
            break
    with h5py.File(path) as file:
        return statistics.median(found), file["solution/r"][:]


def row_of(record):
    best = min(record["siconos"], key=record["siconos"].get, default=None)
    theirs = f"{record['siconos'][best]:.2g} ({best})" if best else f"none in {record['limit']:g}"
    own = f"{record['ours']:.2g}" if record["ours"] else "not solved"
    ratio = f"{record['ours'] / record['siconos'][best]:.2g}" if best and record["ours"] else ""
    return f"| {record['name']} | {record['contacts']} | {own} | {theirs} | {ratio} |"


def write_page(records):
    with open(PAGE) as file:
        text = file.read()
    table = ["| problem | contacts | ours [s] | best of Siconos [s] | ratio |", "| --- " * 5 + "|"]
    table += [row_of(record) for record in records]
    text = re.sub(r"(<!-- speed -->\n).*?(<!-- end -->)",
                  lambda match: match.group(1) + "\n".join(table) + "\n" + match.group(2), text,
                  flags=re.S)
    with open(PAGE, "w") as file:
        file.write(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--output", default=os.path.join(ROOT, "output", "contact_speed"))
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "frictionbeam"))
    parser.add_argument("--limit", type=float, default=20.0, help="seconds a try")
    parser.add_argument("--only", nargs="*", help="names of problems")
    parser.add_argument("--write-page", action="store_true")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    records = []
    for name in arguments.only or contact_problems.PROBLEMS:
        path = os.path.join(arguments.output, name + ".hdf5")
        contact_problems.write_problem(name, arguments.output)
        dimension, W, q, mu = read(path)
        seconds, r = ours(arguments.program, path, arguments.limit)
        record = {"name": name, "contacts": len(mu), "limit": arguments.limit, "ours": seconds,
                  "siconos": siconos(dimension, W, q, mu, arguments.limit)}
        if seconds:
            record["error"] = scaled_error(dimension, W, q, mu, r)
        records.append(record)
        print(row_of(record), flush=True)
    with open(os.path.join(arguments.output, "contact_speed.json"), "w") as file:
        json.dump(records, file, indent=1)
    if arguments.write_page:
        write_page(records)


if __name__ == "__main__":
    main()
