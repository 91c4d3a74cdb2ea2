#!/bin/sh
# Write doc/charts anew: builds the program if needed, runs the lists of prm/chart (some minutes, with
# the machine to itself), and puts their pages together in doc/charts/README.md. Arguments: names of
# lists, to run only those; "none" to put the pages together only.
set -e
here=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
"$here/run" --version >/dev/null
charts="slab slab_line long_bar long_bar_zones oscillator bouncing_bar shaken_line rack hovgaard cantilever_plastic rack_plastic solid_bend solid_loop"
for name in ${*:-$charts}; do
  [ -f "$here/prm/chart/$name.prm" ] || continue
  "$here/build/bin/frictionbeam" chart "$here/prm/chart/$name.prm" --output-directory "$here/doc/charts"
  if [ "$name" = cantilever_plastic ] && command -v ccx >/dev/null; then
    "$here/prm/benchmark/against_calculix.py" --markdown "$here/doc/charts/$name.peer.md"
  fi
done
page="$here/doc/charts/README.md"
{
  cat <<'END'
# Error against time

How accurate is an answer, and what does it cost? Each chart runs one case in several ways and shows the
largest error of its quantities over the time to the solution (mesh, set-up, solution; median of several
runs, each a process of its own), both logarithmic: the lower and the further left, the better. The grey
band joins the runs that no other one beats in both; the small figures beside them are the entry that
varies along the curve. Below each chart stands what to choose, and the cheapest configuration for each
accuracy.

Each chart is made by `frictionbeam chart prm/chart/NAME.prm`, this page by `doc/charts.sh`.
END
  echo "Machine: $(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1), $(nproc) cores;" \
    "$("$here/build/bin/frictionbeam" --version)."
  for name in $charts; do
    if [ -f "$here/doc/charts/$name.md" ]; then
      echo
      cat "$here/doc/charts/$name.md"
    fi
    if [ -f "$here/doc/charts/$name.peer.md" ]; then
      echo
      cat "$here/doc/charts/$name.peer.md"
    fi
  done
} >"$page.new"
mv "$page.new" "$page"
