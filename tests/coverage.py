#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which lines of plugin, source and include no test has run: coverage.py BUILD-FOLDER PAGE.md"""
import gzip
import json
import os
import subprocess
import sys
import tempfile


def ranges(lines):
    """1 2 3 7 as 1-3, 7."""
    parts = []
    for line in sorted(lines):
        if parts and line <= parts[-1][1] + 1:
            parts[-1][1] = line
        else:
            parts.append([line, line])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def counts_of(build, root):
    """How often each line of each file ran, of all objects together."""
    counts = {}
    data = [os.path.join(folder, name) for folder, _, names in os.walk(build) for name in names
            if name.endswith(".gcda")]
    for path in data:
        with tempfile.TemporaryDirectory() as work:
            subprocess.run(["gcov", "--json-format", "--object-directory", os.path.dirname(path), path],
                           cwd=work, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
            for name in os.listdir(work):
                with gzip.open(os.path.join(work, name)) as file:
                    for source in json.load(file)["files"]:
                        full = os.path.normpath(os.path.join(root, source["file"]))
                        relative = os.path.relpath(full, root)
                        if relative.split("/")[0] not in ("plugin", "source", "include"):
                            continue
                        of_file = counts.setdefault(relative, {})
                        for line in source["lines"]:
                            number = line["line_number"]
                            of_file[number] = of_file.get(number, 0) + line["count"]
    return counts


def main():
    build, page = os.path.abspath(sys.argv[1]), sys.argv[2]
    root = os.path.dirname(build)
    counts = counts_of(build, root)
    if not counts:
        sys.exit("There are no counts below " + build + ": has anything run?")
    total = sum(len(of_file) for of_file in counts.values())
    missed = {file: [line for line, n in of_file.items() if n == 0] for file, of_file in counts.items()}
    n_missed = sum(len(lines) for lines in missed.values())
    with open(page, "w") as out:
        commit = subprocess.run(["git", "-C", root, "log", "-1", "--format=%h"], capture_output=True, text=True).stdout.strip()
        out.write(f"# Coverage\n\nMade by `./test --coverage` (gcov) of commit {commit}.\n\n"
                  f"Of {total} lines with code, the tests run {total - n_missed} "
                  f"({100. * (total - n_missed) / total:.1f} %). The others, by file:\n\n"
                  "| file | lines | not run | which |\n| --- | --- | --- | --- |\n")
        for file in sorted(missed, key=lambda name: -len(missed[name])):
            if missed[file]:
                out.write(f"| {file} | {len(counts[file])} | {len(missed[file])} | "
                          f"{ranges(missed[file])} |\n")
    print(f"{100. * (total - n_missed) / total:.1f} % of {total} lines; the others are named in {page}")


if __name__ == "__main__":
    main()
