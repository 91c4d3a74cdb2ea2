# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the stability suite: a process each, ended at its limit, judged by its summary.json."""
import concurrent.futures
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile

CERTIFICATE = 1e-8  # what the exact method must reach, each contact on its own scale
SLAB_ERROR = 1e-8   # of the slab's displacement, relative


def run(case, method, program, limit):
    """One run, as a record for the page."""
    record = {"case": case.name, "method": method, "row": case.row, "column": case.column,
              **case.tags}
    folder = tempfile.mkdtemp(prefix="stability_")
    command = [program, case.file, "--output-directory", folder]
    for setting in case.settings + [f"Solver/Method = {method}"]:
        command += ["--set", setting]
    environment = dict(os.environ, OMPI_MCA_ess_singleton_isolated="1")
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=limit, env=environment)
        return dict(record, **judge(case, method, done, folder))
    except subprocess.TimeoutExpired:
        return dict(record, outcome="failed", where=f"no answer in {limit:g} s")
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def judge(case, method, done, folder):
    """What a run has come to: solved, no equilibrium, wrong, failed."""
    try:
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
    except (OSError, ValueError):
        last = (done.stderr.strip().splitlines() or [""])[-1]
        return {"outcome": "failed", "where": f"exit status {done.returncode}: {last}"}
    cost = summary["cost"]
    figures = {"seconds": cost["setup_seconds"] + cost["solve_seconds"],
               "iterations": cost["iterations"],
               "certificate": max(summary["certificate"].get(name) or 0.
                                  for name in ("equilibrium", "contact"))}
    if summary["status"] == "no_equilibrium":
        figures["outcome"] = "solved" if case.no_equilibrium else "no equilibrium"
        figures["where"] = where_it_stops(summary)
    elif summary["status"] != "converged":
        figures.update(outcome="failed", where=where_it_stops(summary))
    else:
        figures.update(judge_answer(case, method, summary, figures["certificate"]))
    return figures


def judge_answer(case, method, summary, certificate):
    if case.no_equilibrium:
        return {"outcome": "wrong", "where": "an answer where there is no equilibrium"}
    if method == "exact" and not certificate <= CERTIFICATE:
        return {"outcome": "wrong", "where": f"certificate above {CERTIFICATE:g}"}
    for quantity in summary["quantities"]:
        if quantity["name"] == "max_error":
            error = quantity["value"]
            good = error is not None and error <= SLAB_ERROR
            return {"outcome": "solved" if good else "wrong", "error": error,
                    "where": "" if good else "error of the displacement above " +
                    f"{SLAB_ERROR:g}"}
    return {"outcome": "solved", "where": ""}


def where_it_stops(summary):
    """'step NAME, from TIME s on: why', of the step that did not converge."""
    for step in summary["steps"]:
        if not step["converged"]:
            remark = step["remark"].split(", also after halving")[0]
            stopped, _, why = remark.rpartition(": ")
            time = stopped.rpartition("stopped at time ")[2]
            try:
                when = f", from {float(time):.4g} s on"
            except ValueError:
                when = ""
            return f"step {step['step']}{when}: {why.strip() or 'no convergence'}"
    return "; ".join(summary["remarks"])


def run_several(case, method, program, limit):
    """The median of some runs of the same case, all of which must have solved it."""
    records = [run(case, method, program, limit) for _ in range(case.runs)]
    failed = [record for record in records if record["outcome"] != "solved"]
    if failed or case.runs == 1:
        return (failed or records)[0]
    return dict(records[0], seconds=statistics.median(record["seconds"] for record in records),
                runs=case.runs)


def run_series(cases, method, program, arguments):
    """Cases in order of length. Two failures in a row end the series."""
    limit = arguments.exact_limit if method == "exact" else arguments.limit
    records = []
    for case in cases:
        hopeless = [record["outcome"] != "solved" for record in records[-2:]] == [True, True]
        if case.series and hopeless and method != "exact" and not arguments.all:
            records.append({"case": case.name, "method": method, "row": case.row,
                            "column": case.column, "outcome": "not run",
                            "where": "not run: failed on two shorter ones"})
        else:
            records.append(run_several(case, method, program, limit))
    return records


def run_all(group, cases, program, arguments):
    """Records of all cases with all their methods, some series at a time."""
    series = {}
    for case in cases:
        for method in case.methods:
            series.setdefault((case.series or case.name, method), []).append(case)
    n_jobs = 1 if group == "speed" else arguments.jobs
    records = []
    with concurrent.futures.ThreadPoolExecutor(n_jobs) as pool:
        futures = [pool.submit(run_series, members, method, program, arguments)
                   for (_, method), members in series.items()]
        for n, future in enumerate(concurrent.futures.as_completed(futures), 1):
            records += future.result()
            if sys.stderr.isatty() or n % 50 == 0 or n == len(futures):
                n_bad = sum(record["outcome"] != "solved" for record in records)
                print(f"{group}: {n} of {len(futures)} series, {n_bad} of {len(records)} runs "
                      "without an answer", file=sys.stderr)
    order = {(case.name, method): i for i, case in enumerate(cases) for method in case.methods}
    return sorted(records, key=lambda record: order[record["case"], record["method"]])
