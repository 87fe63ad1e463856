#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# One more arithmetic: builds kernel, certify and the systems with CGAL's intervals in round to nearest,
# each bound moved to the next double (CGAL_ALWAYS_ROUND_TO_NEAREST, as in a page), runs the tests of
# the kernel and of the checkers, and prints what was run, a row a folder.
#   scripts/round_to_nearest.sh [FOLDER...]   folders of tests/; default: kernel, certify and certify_*
# Built in build-nearest/, or in CREST_BUILD. Exit code 1 if a test fails.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- kernel $(cd tests && ls -d certify*/ | tr -d /)
build=${CREST_BUILD:-build-nearest}
log=$build/nearest.log
mkdir -p "$build"
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCREST_WITH_VTK=OFF \
  -DCMAKE_CXX_FLAGS=-DCGAL_ALWAYS_ROUND_TO_NEAREST >"$log" || { tail -n 20 "$log" >&2; exit 1; }
echo "| tests | processor time, s | cases and assertions | result |"
echo "|---|---|---|---|"
failed=0
TIMEFORMAT="%U %S"
for folder in "$@"; do  # built one after another: whoever stops it has the rows so far
  cmake --build "$build" --target "test_$folder" >>"$log" || { tail -n 40 "$log" >&2; exit 1; }
  result=passed
  { time "$build/tests/test_$folder" >"$log.$folder" 2>&1; } 2>"$log.time" || result=failed
  if [ $result = failed ]; then
    failed=1
    tail -n 40 "$log.$folder" >&2
  fi
  used=$(awk 'END { printf "%.1f", $1 + $2 }' "$log.time")
  echo "| $folder | $used | $(grep -E '^All tests passed|^test cases:' "$log.$folder" | tail -n 1) | $result |"
done
exit $failed
