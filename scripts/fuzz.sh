#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzes readers and checkers: builds the targets with clang (in build-fuzz/), runs each on its corpus
# and prints what was run, a row each.
#   scripts/fuzz.sh [--seconds N] [TARGET...]
# N: of processor time of each (default 600); TARGET: off obj ply stl vtk msh vtp vtu (the default),
# field_vtu, volume_nrrd (mha vti nii mrc cube inr png pgm vtk xyz), planar_json (txt vec nrrd nc vti vtr vts vtk vtu vtp msh), expression, reeb and the others of tests/fuzz/CMakeLists.txt. A file that fails is left in
# build-fuzz/found/TARGET/; once it is mended it belongs into tests/fuzz/corpus/FORMAT/. Exit code 1
# if there is one.
set -eu
cd "$(dirname "$0")/.."
seconds=600
if [ "${1:-}" = "--seconds" ]; then
  seconds=${2:?--seconds N}
  shift 2
fi
[ $# -gt 0 ] || set -- off obj ply stl vtk msh vtp vtu
compiler=${CXX:-$(command -v clang++ || command -v clang++-14 || true)}
[ -n "$compiler" ] || { echo "scripts/fuzz.sh: there is no clang++; install clang" >&2; exit 2; }

cmake -S . -B build-fuzz -G Ninja -DCREST_FUZZ=ON -DCMAKE_CXX_COMPILER="$compiler" >build-fuzz.log ||
  { tail -n 20 build-fuzz.log >&2; exit 1; }
cmake --build build-fuzz --target "${@/#/fuzz_}" >>build-fuzz.log ||
  { tail -n 40 build-fuzz.log >&2; exit 1; }

echo "$("$compiler" --version | head -n 1); address and undefined behaviour sanitizers"
echo
echo "| target | processor time, s | inputs | new ones kept | failures |"
echo "|---|---|---|---|---|"
failed=0
TIMEFORMAT="%U %S"
for target in "$@"; do
  found=build-fuzz/found/$target
  log=build-fuzz/$target.log
  corpus=tests/fuzz/corpus/${target#field_}
  mkdir -p "$found" "build-fuzz/new/$target"
  options="-max_total_time=$seconds -timeout=10 -rss_limit_mb=4000 -print_final_stats=1"
  # VTK leaks on damaged files and asks malloc for absurd sizes, which Crest reports.
  export ASAN_OPTIONS=allocator_may_return_null=1
  case $target in *vt[piu] | *png) ASAN_OPTIONS=$ASAN_OPTIONS:detect_leaks=0 ;; esac
  [ -d "$corpus" ] || corpus=
  # The fuzzer counts seconds of the clock: again until it has had them of the processor.
  used=0 inputs=0 kept=0 runs=0
  while [ "$used" -lt "$seconds" ] && [ $runs -lt 20 ] && [ -z "$(ls -A "$found")" ]; do
    runs=$((runs + 1))
    { time "build-fuzz/tests/fuzz/fuzz_$target" $options \
      -artifact_prefix="$found/" "build-fuzz/new/$target" $corpus >"$log" 2>&1 || true; } 2>"$log.time"
    used=$((used + $(awk 'END { printf "%d", $1 + $2 }' "$log.time")))
    inputs=$((inputs + $(awk '/stat::number_of_executed_units/ { n = $2 } END { print n + 0 }' "$log")))
    kept=$((kept + $(awk '/stat::new_units_added/ { n = $2 } END { print n + 0 }' "$log")))
  done
  failures=$(find "$found" -type f | wc -l)
  [ "$failures" -eq 0 ] || failed=1
  echo "| $target | $used | $inputs | $kept | $failures |"
done
exit $failed
