#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Whole commands on one mesh, files written: two programs in turn, medians, as Markdown tables.
#   measure.sh OLD NEW [VERTICES [RUNS [PREFIX]]]
# OLD and NEW are programs `crest`; PREFIX is put before each of their runs, as in "taskset -c 0".
set -eu
export LC_ALL=C
old=$(realpath "$1") new=$(realpath "$2") vertices=${3:-500000} runs=${4:-3} prefix=${5:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$new" sample blend --vertices "$vertices" --quiet -o blend.off
"$new" sample blend --vertices $((vertices / 5)) --quiet -o fifth.off
"$new" sample blend --vertices $((vertices / 5)) --noise 0.03 --quiet -o noisy.off

# run PROGRAM FILE ARGUMENTS...: a line "processor seconds, seconds, MB" to the file.
run() {
  program=$1 to=$2
  shift 2
  $prefix /usr/bin/time -o time.txt -f '%U %S %e %M' "$program" "$@" --quiet >/dev/null
  awk '{ printf "%.3f %.3f %.1f\n", $1 + $2, $3, $4 / 1024 }' time.txt >>"$to"
}
# median FILE COLUMN
median() {
  awk -v column="$2" '{ print $column }' "$1" | sort -n | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'
}
# row NAME ARGUMENTS...: one thread.
row() {
  name=$1
  shift
  rm -f old.txt new.txt
  for _ in $(seq "$runs"); do
    run "$old" old.txt "$@" --threads 1
    run "$new" new.txt "$@" --threads 1
  done
  echo "$(median old.txt 1) $(median new.txt 1) $(median old.txt 3) $(median new.txt 3)" |
    awk -v name="$name" '{ printf "| %s | %.2f | %.2f | %.2f | %.0f | %.0f |\n", name, $1, $2, $1 / $2, $3, $4 }'
}
# threads NAME ARGUMENTS...: seconds of the new program with one thread and two.
threads() {
  name=$1
  shift
  rm -f one.txt two.txt
  for _ in $(seq "$runs"); do
    run "$new" one.txt "$@" --threads 1
    run "$new" two.txt "$@" --threads 2
  done
  echo "$(median one.txt 2) $(median two.txt 2)" |
    awk -v name="$name" '{ printf "| %s | %.2f | %.2f | %.2f |\n", name, $1, $2, $1 / $2 }'
}

reeb='--expression x*x-y*z'
echo "Whole commands, blend of $vertices vertices, one thread: processor time in s, memory in MB"
echo
echo '| command | old | new | old / new | old MB | new MB |'
echo '|---|---|---|---|---|---|'
row 'ridges, VTP and certificate' ridges blend.off -o o.vtp --certificate o.crest
row 'ridges, nothing written' ridges blend.off
row 'curvature ne, nothing written' curvature blend.off
row 'curvature ne, PLY' curvature blend.off -o o.ply
row 'curvature ne, VTP' curvature blend.off -o o.vtp
row 'features, VTP and certificate' features blend.off -o o.vtp --certificate o.crest
row 'reeb, nothing written' reeb blend.off $reeb
row 'reeb, VTP' reeb blend.off $reeb -o o.vtp
row 'reeb, VTP and certificate' reeb blend.off $reeb -o o.vtp --certificate o.crest
row "sample, $((vertices / 5)) vertices" sample blend --vertices $((vertices / 5)) -o o.off
row "ridges, $((vertices / 5)) vertices, clean" ridges fifth.off
row 'the same with 3 % noise' ridges noisy.off
echo
echo 'Threads: seconds by the clock, new program'
echo
echo '| command | one thread | two | ratio |'
echo '|---|---|---|---|'
threads 'ridges, VTP and certificate' ridges blend.off -o o.vtp --certificate o.crest
threads 'curvature ne, PLY' curvature blend.off -o o.ply
threads 'features, VTP and certificate' features blend.off -o o.vtp --certificate o.crest
threads 'reeb, VTP and certificate' reeb blend.off $reeb -o o.vtp --certificate o.crest
