#!/bin/sh
# What a time step of a line of 10,000 cells with 100 friction supports costs, in back-substitutions with its
# factored matrix, measured in the same run:  prm/benchmark/transient_step.sh [--set "Section/Entry = value"]...
set -e
here=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd)
"$here/run" --version >/dev/null
cmake -S "$here" -B "$here/build" -DFRICTIONBEAM_TESTS=ON >/dev/null
ninja -C "$here/build" benchmark_transient_step >/dev/null
exec "$here/build/bin/benchmark_transient_step" "$here/prm/benchmark/transient_step.prm" "$@"
