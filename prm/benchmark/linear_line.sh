#!/bin/sh
# The linear part of a line of 200,000 cells against a bare deal.II loop with one SimplicialLDLT, in
# one run:  prm/benchmark/linear_line.sh [cells]
set -e
here=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
"$here/run" --version >/dev/null
cmake -S "$here" -B "$here/build" -DFRICTIONBEAM_TESTS=ON >/dev/null
ninja -C "$here/build" benchmark_linear_line >/dev/null
exec "$here/build/bin/benchmark_linear_line" "$@"
