#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds crest-mpi and tests it: the same bytes as crest's by 1, 2, 4 and 8 processes, damaged input,
# a killed process and a restart. scripts/mpi.sh --programs FOLDER tests those in a folder instead.
set -eu
cd "$(dirname "$0")/.."

if [ "${1:-}" = "--programs" ]; then
  crest=$2/crest mpi=$2/crest-mpi
else
  command -v mpirun >/dev/null || { echo "Install libopenmpi-dev and openmpi-bin first." >&2; exit 1; }
  cmake -S . -B build -G Ninja -DCREST_WITH_MPI=ON >/dev/null
  cmake --build build --target crest crest-mpi
  crest=build/cli/crest mpi=build/distributed/crest-mpi
fi
crest=$(realpath "$crest") mpi=$(realpath "$mpi")
root=""
[ "$(id -u)" -ne 0 ] || root="--allow-run-as-root"
ranks() {  # COUNT ARGUMENTS: crest-mpi by so many processes
  count=$1
  shift
  mpirun -q $root --oversubscribe -np "$count" "$mpi" "$@" --quiet --threads 1
}
fail() { echo "FAILED: $1" >&2; exit 1; }

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

"$crest" sample moebius-sheet --nodes 48 -o sheet.nrrd --quiet
"$crest" extremal sheet.nrrd --ridge --min-value 0.4 -o one.vtp --certificate one.crest --quiet
same() {
  cmp one.vtp many.vtp && cmp one.crest many.crest || fail "$1: other bytes"
  rm many.vtp many.crest
  echo "$1: the same bytes"
}
for count in 1 2 4 8; do
  ranks $count extremal sheet.nrrd --ridge --min-value 0.4 -o many.vtp --certificate many.crest
  same "$count processes"
done
ranks 2 extremal sheet.nrrd --ridge --min-value 0.4 --blocks 27 -o many.vtp --certificate many.crest
same "2 processes, 27 blocks"

head -c -100 sheet.nrrd >short.nrrd
code=0
ranks 4 extremal short.nrrd --ridge -o bad.vtp 2>words || code=$?
[ "$code" = 3 ] && [ "$(wc -l <words)" = 1 ] && [ ! -e bad.vtp ] || fail "a truncated file"
echo "a truncated file: $(cat words)"

# A process is killed as soon as a block is done; a restart must end with the same bytes.
"$crest" sample moebius-sheet --nodes 80 -o sheet.nrrd --quiet
"$crest" extremal sheet.nrrd --ridge --min-value 0.4 -o one.vtp --certificate one.crest --quiet
mkdir done
ranks 2 extremal sheet.nrrd --ridge --min-value 0.4 --blocks 27 --restart done -o many.vtp \
  --certificate many.crest 2>words & run=$!
while [ -z "$(ls done)" ] && kill -0 $run 2>/dev/null; do sleep 0.01; done
victim=$(pgrep -n -f "^$mpi extremal sheet.nrrd .* --restart done" || true)
[ -z "$victim" ] || kill -9 "$victim" 2>/dev/null || true
if wait $run; then
  echo "the run ended before it could be killed"
else
  [ ! -e many.vtp ] && [ ! -e many.crest ] || fail "a killed process left output"
  echo "a process was killed after $(ls done | wc -l) of 27 blocks: $(cat words)"
fi
ranks 2 extremal sheet.nrrd --ridge --min-value 0.4 --blocks 27 --restart done -o many.vtp \
  --certificate many.crest
same "after a restart"
