#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Count the functions of source, plugin and include that are longer than some lines.

    tests/layers/long_functions.py [LINES = 60]

A function goes from the first line of its signature to its closing brace, which clang-format puts alone and as far
in as the signature; its lambdas are part of it. Longest first.
"""
import pathlib
import re
import sys

NO_FUNCTION = re.compile(r"\b(namespace|class|struct|enum|union)\b|^(if|for|while|switch|else|do|return|try|case)\b")


def functions_of(path):
    """First and last line of each, counted from 0, and the signature."""
    lines = path.read_text().split("\n")
    for end, line in enumerate(lines):
        if not re.match(r"^ {0,4}\}$", line):
            continue
        indent = line[:-1]
        begin = end - 1  # back to the line that stands as far in
        while begin > 0 and not re.match(rf"^{indent}[^ #/}}]", lines[begin]) or re.search(
                r"^\s*(public|private|protected):", lines[begin]):
            begin -= 1
        signature = " ".join(part.strip() for part in lines[begin:end]).split("{")[0]
        if "(" in signature and not NO_FUNCTION.search(signature.split("(")[0].strip()):
            yield begin, end, signature


def main():
    limit = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    root = pathlib.Path(__file__).resolve().parents[2]
    found = []
    for folder in ("source", "plugin", "include"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".cc", ".h"):
                continue
            of_file = list(functions_of(path))
            for begin, end, signature in of_file:
                within = any(b < begin and end < e for b, e, _ in of_file)
                if not within and end - begin + 1 > limit:
                    found.append((end - begin + 1, f"{path.relative_to(root)}:{begin + 1}", signature[:60]))
    for one in sorted(found, reverse=True):
        print(*one)
    print(len(found), "functions are longer than", limit, "lines")


main()
