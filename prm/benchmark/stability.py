#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which method solves which line, in how many iterations and seconds: doc/stability.md, made anew.

    prm/benchmark/stability.py                  everything, hours; then the page
    prm/benchmark/stability.py --only rack      one group, or some: slab,chatter; then the page
    prm/benchmark/stability.py --page           the page from the results that are there
    prm/benchmark/stability.py --quick          a few cases of each group, results and page under
                                                output/stability_quick

Groups: slab, rack, chatter, random, speed (stability_cases.py) and siconos (against_siconos.py, which
needs python3-siconos; without it the page leaves that part out). Each group's results are kept as
FOLDER/<group>.json, so that groups can be run one by one, and written only when the group is done.

A run that takes longer than the limit is ended: that counts as a failure. Within a series of racks
that differ in length only, a method that failed on two lengths is not run on longer ones; --all runs
them nonetheless. Standard library only.
"""
import argparse
import dataclasses
import json
import os
import platform
import subprocess
import sys
import time

import stability_cases
import stability_page
import stability_runs

ROOT = os.path.dirname(os.path.dirname(stability_cases.HERE))


def command_line():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    names = list(stability_cases.GROUPS) + ["siconos"]
    parser.add_argument("--only", default=",".join(names), help="groups, separated by commas")
    parser.add_argument("--quick", action="store_true", help="a few cases of each group")
    parser.add_argument("--page", action="store_true", help="no runs, only the page")
    parser.add_argument("--again", action="store_true",
                        help="only cases that exact has not solved before; the rest is kept")
    parser.add_argument("--all", action="store_true", help="run hopeless long racks as well")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time, but one for speed")
    parser.add_argument("--limit", type=float, default=60., help="seconds a run")
    parser.add_argument("--exact-limit", type=float, default=600.,
                        help="seconds a run of the method exact, which must not fail")
    parser.add_argument("--seeds", type=int, default=2000, help="random lines for exact")
    parser.add_argument("--other-seeds", type=int, default=200, help="of these, for the others")
    parser.add_argument("--program", help="default: that of ./run, built if needed")
    parser.add_argument("--output", help="folder of the results")
    parser.add_argument("--document", help="the page, instead of doc/stability.md")
    arguments = parser.parse_args()
    arguments.only = arguments.only.split(",")
    unknown = set(arguments.only) - set(names)
    if unknown:
        parser.error(f"--only {','.join(unknown)}: allowed are {', '.join(names)}")
    name = "stability_quick" if arguments.quick else "stability"
    arguments.output = arguments.output or os.path.join(ROOT, "output", name)
    default = os.path.join(arguments.output if arguments.quick else ROOT, "doc", "stability.md")
    arguments.document = arguments.document or default
    return arguments


def program(arguments):
    if arguments.program:
        return os.path.abspath(arguments.program)
    subprocess.run([os.path.join(ROOT, "run"), "--version"], check=True, stdout=subprocess.DEVNULL)
    return os.path.join(ROOT, "build", "bin", "frictionbeam")


def output_of(*command):
    try:
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                              cwd=ROOT).stdout.strip()
    except OSError:
        return ""


def machine():
    with open("/proc/cpuinfo") as file:
        models = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return f"{models[0] if models else platform.machine()}, {os.cpu_count()} cores"


def run_group(name, arguments, binary):
    make = stability_cases.GROUPS[name]
    cases = (make(arguments.quick, arguments.seeds, arguments.other_seeds) if name == "random"
             else make(arguments.quick))
    begin = time.time()
    commit = output_of("git", "describe", "--always", "--dirty")
    file_name = os.path.join(arguments.output, name + ".json")
    if arguments.again:
        with open(file_name) as file:
            result = json.load(file)
        open_cases = {record["case"] for record in result["records"]
                      if record["method"] == "exact" and record["outcome"] != "solved"}
        chosen = [dataclasses.replace(case, methods=("exact",)) for case in cases if case.name in open_cases]
        anew = {record["case"]: record
                for record in stability_runs.run_all(name, chosen, binary, arguments)}
        result["records"] = [anew.get(record["case"], record) if record["method"] == "exact"
                             else record for record in result["records"]]
        result["again"] = {"commit": commit, "runs": len(anew)}
        with open(file_name, "w") as file:
            json.dump(result, file, indent=0)
        return
    records = stability_runs.run_all(name, cases, binary, arguments)
    result = {"date": time.strftime("%Y-%m-%d"), "machine": machine(),
              "program": output_of(binary, "--version"),
              "commit": commit,
              "limits": {"exact": arguments.exact_limit, "others": arguments.limit},
              "jobs": 1 if name == "speed" else arguments.jobs,
              "minutes": (time.time() - begin) / 60., "records": records}
    with open(file_name, "w") as file:
        json.dump(result, file, indent=0)


def run_siconos(arguments, binary):
    if subprocess.run(["/usr/bin/python3", "-c", "import siconos.numerics"],
                      stderr=subprocess.DEVNULL).returncode != 0:
        print("No Siconos here (python3-siconos): that part is left out.", file=sys.stderr)
        return
    script = os.path.join(stability_cases.HERE, "against_siconos.py")
    subprocess.run(["/usr/bin/python3", script, "--output", arguments.output, "--program", binary] +
                   (["--quick", "--limit", "10"] if arguments.quick else []), check=True)


def main():
    arguments = command_line()
    os.makedirs(arguments.output, exist_ok=True)
    if not arguments.page:
        binary = program(arguments)
        for name in stability_cases.GROUPS:
            if name in arguments.only:
                run_group(name, arguments, binary)
        if "siconos" in arguments.only:
            run_siconos(arguments, binary)
    stability_page.write(arguments.output, arguments.document)
    print("Written:", arguments.document)


if __name__ == "__main__":
    main()
