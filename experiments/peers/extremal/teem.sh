#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Ridge surfaces of sheets with known borders by Crest and by Teem's seek in one run, as a Markdown
# table (README.md beside this file).
#   teem.sh CREST [NODES...]    CREST: the program; NODES: along an axis, 64 and 128
# Without Teem (Debian: libteem-dev) it says so and ends well: nothing else needs it.
set -eu
export LC_ALL=C
here=$(dirname "$(realpath "$0")")
crest=$(realpath "$1")
shift
[ $# -gt 0 ] || set -- 64 128
runs=3 strength=60 eval_diff=2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if ! echo '#include <teem/seek.h>' | ${CC:-cc} -E - >/dev/null 2>&1; then
  echo "skipped: Teem's headers are not there (Debian: libteem-dev)"
  exit 0
fi
${CC:-cc} -std=gnu11 -O2 -o "$work/teem_ridges" "$here/teem_ridges.c" -lteem -lm

# row PROGRAM, then polygons, valence 1, 3, 4 or more, seconds of all runs one a word (the least is taken)
row() {
  program=$1
  shift
  echo "$@" | awk -v start="| $sheet | $n | $program" -v voxels=$((n * n * n)) '{
    least = $5
    for (i = 6; i <= NF; ++i) if ($i < least) least = $i
    printf "%s | %d | %d | %d | %d | %.2f | %.2f |\n", start, $1, $2, $3, $4, least, 1e6 * least / voxels }'
}
teem() { row "Teem $1" $("$work/teem_ridges" "$work/v.nrrd" "$1" $strength $eval_diff $runs 2>"$work/words"); }

crest_row() {  # NAME, options
  name=$1
  shift
  : >"$work/times"
  for run in $(seq $runs); do
    /usr/bin/time -a -o "$work/times" -f %U "$crest" extremal "$work/v.nrrd" --ridge --min-value 0.4 --min-strength $strength \
      --threads 1 --quiet --report "$work/report.json" "$@"
  done
  row "Crest $name" $(python3 - "$work/report.json" <<'P'
import json, sys
r = json.load(open(sys.argv[1]))
v = r["valence"]
print(r["polygons"], v["1"], v["3"], v["4+"])
P
  ) $(cat "$work/times")
}

echo "Ridge surfaces of at least strength $strength (Teem: a difference of eigenvalues of $eval_diff, too; Crest: a value of 0.4, too); least processor"
echo "seconds of $runs runs on one thread, Crest's of the whole command"
echo
echo "| sheet | nodes along an axis | by | polygons | edges with 1 | with 3 | with 4 or more | s | us/voxel |"
echo "|---|---|---|---|---|---|---|---|---|"
for sheet in sphere-shell moebius-sheet junction; do
  for n in "$@"; do
    "$crest" sample $sheet --nodes $n -o "$work/v.nrrd" --quiet
    teem RidgeSurface
    teem RidgeSurfaceT
    crest_row "structure"
    crest_row "hessian" --definition hessian
    crest_row "structure, certified" --certificate "$work/x.crest"
  done
done
