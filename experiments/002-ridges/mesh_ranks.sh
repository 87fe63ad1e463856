#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What meshes and solids cost by several processes, as a table: mesh_ranks.sh CREST CREST-MPI
# (build/cli/crest, build/distributed/crest-mpi). CREST_SIZE: a percentage of the sizes.
set -eu
crest=$(realpath "$1") mpi=$(realpath "$2") percent=${CREST_SIZE:-100}
root=""
[ "$(id -u)" -ne 0 ] || root="--allow-run-as-root"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
vertices() { echo $(($1 * percent / 100)); }
"$crest" sample ellipsoid --noise 0.05 --vertices "$(vertices 200000)" -o noisy.off --quiet
"$crest" sample ellipsoid --vertices "$(vertices 40000)" -o clean.off --quiet
"$crest" sample block-twist --vertices "$(vertices 100000)" -o solid.vtu --quiet

echo "One thread a process; processor seconds and megabytes of process 0, then the most of any other."
echo
echo "| run | processes | s | MB | others: s | MB | bytes exchanged | same bytes |"
echo "|---|---|---|---|---|---|---|---|"
row() {  # NAME PROCESSES
  sent=$(awk '/which sent/ {print $(NF-1)}' words)
  cat times.* | awk -F_ -v name="$1" -v p="$2" -v sent="${sent:-0}" -v same="$3" '
    $1 == 0 { s = $2; mb = $3 }
    $1 > 0 { if ($2 > os) os = $2; if ($3 > om) om = $3; n++ }
    END {
      others = n ? sprintf("%.1f | %.0f", os, om / 1024) : "- | -"
      printf "| %s | %s | %.1f | %.0f | %s | %d | %s |\n", name, p, s, mb / 1024, others, sent, same
    }'
}
run() {  # NAME ARGUMENTS
  name=$1
  shift
  for count in 0 1 2 4; do
    rm -f times.* words
    if [ $count = 0 ]; then
      /usr/bin/time -o times.0 -f 0_%U_%M "$crest" "$@" -o one.vtp --certificate one.crest --threads 1 >words
      row "$name" "1 (crest)" yes
      continue
    fi
    # shellcheck disable=SC2016
    mpirun -q $root --oversubscribe -np $count sh -c '
      rank=$OMPI_COMM_WORLD_RANK
      exec /usr/bin/time -o times.$rank -f ${rank}_%U_%M "$@"' sh \
      "$mpi" "$@" -o many.vtp --certificate many.crest --threads 1 >words
    same=NO
    cmp -s one.vtp many.vtp && cmp -s one.crest many.crest && same=yes
    row "$name" $count $same
    rm -f many.vtp many.crest
  done
}
run "ridges, noise 0.05, $(vertices 200000) vertices" ridges noisy.off
run "ridges --scale auto, $(vertices 40000) vertices" ridges clean.off --scale auto
run "modes --mode 0.5 --neutral, some $(vertices 100000) vertices" modes solid.vtu --mode 0.5 --neutral
