#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What blocks and processes cost, as tables: scaling.sh CREST CREST-MPI LARGE-VOLUME
# (build/cli/crest, build/distributed/crest-mpi, build/experiments/000-extremal/large_volume).
# CREST_RUN: a command before each program (chrt -f 10, on a machine that others use).
set -eu
crest=$(realpath "$1") mpi=$(realpath "$2") volume=$(realpath "$3")
root=""
[ "$(id -u)" -ne 0 ] || root="--allow-run-as-root"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
task() { echo "v$1.raw --raw $1,$1,$1,uint8 --ridge --min-value 100"; }
time="/usr/bin/time -a -o times -f %U_%e_%M"

echo "Spherical sheet and half plane in N^3 bytes, least value 100, no certificate, one thread a process."
echo "Processor seconds are of all processes, megabytes of the one with most and of the one with least."
echo
echo "| N | blocks | processes | processor s | wall s | MB, most | MB, least | bytes exchanged | same bytes |"
echo "|---|---|---|---|---|---|---|---|---|"
run() {  # N BLOCKS PROCESSES
  rm -f times many.vtp
  if [ "$3" = 0 ]; then
    ${CREST_RUN:-} $time "$crest" extremal $(task $1) --blocks $2 -o many.vtp --threads 1 >words
  else
    mpirun -q $root --oversubscribe -np $3 ${CREST_RUN:-} $time "$mpi" extremal $(task $1) --blocks $2 \
      -o many.vtp --threads 1 >words
  fi
  sent=$(awk '/which sent/ {print $(NF-1)}' words)
  same=$(cmp -s one$1.vtp many.vtp && echo yes || echo NO)
  awk -F_ -v n=$1 -v b=$2 -v p=$3 -v sent="${sent:-0}" -v same=$same '
    { user += $1; if ($2 > wall) wall = $2; if ($3 > most) most = $3; if (!least || $3 < least) least = $3 }
    END { printf "| %d | %d | %s | %.1f | %.1f | %.0f | %.0f | %d | %s |\n", n, b, p ? p : "1 (crest)", user,
                 wall, most / 1024, least / 1024, sent, same }' times | tee -a rows
}
for n in ${CREST_SIZES:-64 96 128}; do
  "$volume" v$n.raw --nodes $n >/dev/null
  "$crest" extremal $(task $n) -o one$n.vtp --threads 1 --quiet
  run $n 1 0
  run $n 8 0
  run $n 1 1
  run $n 2 2
  run $n 8 2
  run $n 8 4
done

# The halo is 11 nodes on each side: radius 3 and 8.
awk -F'|' '
  $4 ~ /crest/ {
    n = $2; b = $3 + 0; side = b == 1 ? n : n / 2 + 11
    voxels = side ^ 3
    tv += $5 * b * voxels; vv += (b * voxels) ^ 2
    k++; sm += $7; sv += voxels; smv += $7 * voxels; svv += voxels ^ 2
  }
  $9 > 0 { bytes = $9 / $2 ^ 2 }
  END {
    a = tv / vv; d = (k * smv - sm * sv) / (k * svv - sv * sv); c = (sm - d * sv) / k
    side = 1e10 ^ (1 / 3) / 10; v = (side + 22) ^ 3
    printf "\nFitted to the rows of crest: %.2f microseconds a voxel, halo and all; %.0f MB and %.0f bytes a voxel.\n", 1e6 * a, c, 1e6 * d
    printf "10^10 voxels on 1000 processes, a block each (%.0f^3, with its halo %.0f^3), of a sheet of the same shape: ", side, side + 22
    printf "%.0f s and %.0f MB a process for its block; %.0f MB of records and values to process 0, by the square of N. ", a * v, c + d * v, bytes * 1e10 ^ (2 / 3) / 1e6
    printf "(Numbers of edges have 32 bits: today at most 2^30 nodes.)\n"
  }' rows
