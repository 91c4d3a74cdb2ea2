#!/bin/sh
# readers.sh READER SECONDS [options of libFuzzer]
# Let clang's libFuzzer look for bytes that a reader cannot bear: parameters, history, mesh, geometry,
# checkpoint, contacts, law. Needs clang, libclang-rt-dev and a build of the program in build; what it
# builds and finds is in build-readers.
set -e
root=$(cd "$(dirname "$0")/../../.." && pwd)
work=$root/build-readers
reader=$1 seconds=$2
shift 2
if [ ! -e "$work/build.ninja" ]; then
  cmake -S "$root/tests/fuzz/readers" -B "$work" -G Ninja -DCMAKE_CXX_COMPILER=clang++-14 >/dev/null
fi
ninja -C "$work" >/dev/null
corpus=$work/corpus/$reader
mkdir -p "$corpus" "$work/found"
seeds() { # of a kind of file, those that are not large
  find "$root/prm" "$root/tests" -name "$1" -size -20k -exec cp -n {} "$corpus" \;
}
case $reader in
parameters) seeds '*.prm' ;;
history) seeds '*.csv'; seeds '*.txt'; printf '0 0\n1 1\n' >"$corpus/ramp" ;;
mesh) seeds '*.msh' ;;
geometry) seeds '*.geo' ;;
contacts) cp "$work"/../tests/fuzz/found/*.hdf5 "$corpus" ;;
esac
# Parts of the libraries are not compiled here: what they keep until the end is not ours.
ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=0 exec "$work/fuzz_readers" "$reader" \
  "$corpus" -artifact_prefix="$work/found/$reader-" -max_total_time="$seconds" -timeout=10 \
  -rss_limit_mb=4000 -print_final_stats=1 "$@"
