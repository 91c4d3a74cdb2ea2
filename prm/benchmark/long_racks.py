#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time and memory of plant racks by their number of supports, with either mesher, in one run.

    prm/benchmark/long_racks.py [--program build/bin/frictionbeam] [--against OTHER] [--runs 7] [N ...]

Runs of one N follow each other in alternating order; medians are printed. --against: another program, whose times are
set beside (its mesher is gmsh where it knows no other). The program's own account is taken, and the wall and processor
time of the whole process, the loader included.
"""
import argparse
import json
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent


def run(program, n, mesher, folder):
    options = ["--set", f"Rack/Spans = {n}", "--set", "Mesh/Most cells = 10000000", "--output-directory", folder, "--quiet"]
    if mesher:
        options += ["--set", f"Mesh/Mesher = {mesher}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.perf_counter()
    subprocess.run([program, HERE / "rack_family.prm", *options], check=True)
    wall = time.perf_counter() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cost = json.loads((pathlib.Path(folder) / "summary.json").read_text())["cost"]
    return {"mesh": cost["mesh_seconds"], "set-up": cost["setup_seconds"], "solution": cost["solve_seconds"],
            "process": wall, "processor": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
            "MB": cost["peak_memory_mb"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", default=str(HERE.parents[1] / "build/bin/frictionbeam"))
    parser.add_argument("--against")
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("sizes", metavar="N", type=int, nargs="*", default=[100, 400, 4000])
    options = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    variants = [("auto", options.program, "auto"), ("gmsh", options.program, "gmsh")]
    if options.against:
        variants.append(("against", options.against, ""))
    columns = ["mesh", "set-up", "solution", "process", "processor", "MB"]
    print(f"{'n':>6} {'mesher':>8} " + " ".join(f"{c:>10}" for c in columns) + "   seconds, medians")
    for n in options.sizes:
        found = {name: [] for name, _, _ in variants}
        with tempfile.TemporaryDirectory() as folder:
            for i in range(options.runs):
                for name, program, mesher in variants if i % 2 == 0 else reversed(variants):
                    found[name].append(run(program, n, mesher, folder))
        for name, results in found.items():
            print(f"{n:>6} {name:>8} " + " ".join(
                f"{statistics.median(r[c] for r in results):>10.4g}" for c in columns), flush=True)


main()
