#!/bin/sh
# Write doc/verification.md anew: builds the program if needed, runs the cases of prm/verification.
set -e
here=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
"$here/run" --version >/dev/null
tool="$here/build/verification_table"
c++ -std=c++17 -O1 "$here/tests/cases/verification_table.cc" -o "$tool"
"$tool" "$here/build/bin/frictionbeam" "$here/prm/verification" >"$tool.md"
mv "$tool.md" "$here/doc/verification.md"
