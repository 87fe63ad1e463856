#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds crest-mpi and tests it: the same bytes as crest's by 1, 2, 4 and 8 processes, damaged input,
# killed processes and a restart. scripts/mpi.sh --programs FOLDER tests those in a folder instead.
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

# Meshes: rank 0 cuts them. The fits' support is chosen, which asks the ranks up to 14 times.
"$crest" sample ellipsoid --noise 0.05 --vertices 4000 -o mesh.off --quiet
"$crest" ridges mesh.off --scale auto -o one.vtp --certificate one.crest --quiet
for count in 1 2 4; do
  ranks $count ridges mesh.off --scale auto -o many.vtp --certificate many.crest
  same "ridges, $count processes"
done
"$crest" curvature mesh.off --method jet -o one.vtp --quiet
ranks 4 curvature mesh.off --method jet -o many.vtp
cmp one.vtp many.vtp || fail "curvature: other bytes"
echo "curvature, 4 processes: the same bytes"
rm many.vtp
"$crest" sample block-twist --vertices 4000 -o solid.vtu --quiet
"$crest" modes solid.vtu --mode 0.5 --neutral --degenerate -o one.vtp --certificate one.crest --quiet || [ $? = 1 ]
for count in 1 2 4; do
  ranks $count modes solid.vtu --mode 0.5 --neutral --degenerate -o many.vtp --certificate many.crest || [ $? = 1 ]
  same "modes, $count processes"
done

"$crest" modes solid.vtu --degenerate -o one.vtp --certificate one.crest --quiet || [ $? = 1 ]
for count in 1 2 4; do
  ranks $count modes solid.vtu --degenerate -o many.vtp --certificate many.crest || [ $? = 1 ]
  same "degenerate curves, $count processes"
done

# Messages of several parts (1 MiB), and more processes than vertices or nodes along an axis.
"$crest" sample ellipsoid --vertices 100000 --noise 0.05 -o large.off --quiet
"$crest" curvature large.off -o one.vtp --quiet
ranks 2 curvature large.off -o many.vtp
cmp one.vtp many.vtp || fail "large messages: other bytes"
echo "curvature of 100 000 vertices, 2 processes: the same bytes"
rm many.vtp
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n' >triangle.off
"$crest" ridges triangle.off -o one.vtp --certificate one.crest --quiet
ranks 8 ridges triangle.off -o many.vtp --certificate many.crest
same "a triangle, 8 processes"
"$crest" sample sphere-shell --nodes 4 -o tiny.nrrd --quiet
"$crest" extremal tiny.nrrd --ridge -o one.vtp --certificate one.crest --quiet
ranks 8 extremal tiny.nrrd --ridge -o many.vtp --certificate many.crest
same "4 x 4 x 4 nodes, 8 processes"

# Damaged input: the line of crest, exit code 3, nothing written.
damaged() {  # WHAT COMMAND FILE ARGUMENTS
  what=$1
  shift
  code=0
  ranks 4 "$@" -o bad.vtp 2>words || code=$?
  [ "$code" = 3 ] && [ "$(wc -l <words)" = 1 ] && [ ! -e bad.vtp ] || { cat words >&2; fail "$what"; }
  echo "$what: $(cat words)"
}
head -c -100 sheet.nrrd >short.nrrd
damaged "a truncated volume" extremal short.nrrd --ridge
sed '1000s/.*/1 nan 2/' mesh.off >nan.off
damaged "a mesh with a bad coordinate" ridges nan.off
head -c -4 sheet.nrrd >bad.nrrd
printf '\377\377\377\377' >>bad.nrrd
mkdir kept
damaged "a voxel that is no number, the last of 27 blocks" extremal bad.nrrd --ridge --blocks 27 --restart kept
[ "$(ls kept | wc -l)" -gt 0 ] || fail "no finished block was kept"
head -c 5000 solid.vtu >short.vtu
damaged "a truncated solid" modes short.vtu --neutral
code=0
ranks 2 ridges --surface 'x^2+y^2+z^2-1' --box '-2,2' -o bad.vtp 2>words || code=$?
[ "$code" = 2 ] && [ "$(wc -l <words)" = 1 ] || fail "a smooth surface"
echo "a smooth surface: $(cat words)"

# Of a mesh: a process is killed while it works; nothing is left.
ranks 2 ridges large.off --scale auto -o many.vtp --certificate many.crest 2>words & run=$!
until victim=$(pgrep -n -f "^$mpi ridges large.off"); do sleep 0.1; done
sleep 2
kill -9 "$victim"
if wait $run; then fail "a killed process went unnoticed"; fi
[ ! -e many.vtp ] && [ ! -e many.crest ] || fail "a killed process left output"
echo "a process was killed: $(cat words)"

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
