#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Certified ridges of 22 smooth surfaces: two programs' processor time in alternating runs on one
# thread, whether their certificates are the same, the first one's time on two threads by the clock
# and its checker's.
# Usage: smooth_speed.sh FOLDER BEFORE [RUNS] [NAME]   (folders that hold crest and crest-verify)
set -euo pipefail
new=$1 old=$2 runs=${3:-3} only=${4:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export LC_ALL=C

# The median of the runs' numbers, one a line.
median() { sort -g | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }
# Seconds by TIMEFORMAT $1 of the command, to file $2.
clock() {
  local TIMEFORMAT=$1 to=$2
  shift 2
  { time "$@" >"$folder/out" 2>&1; } 2>>"$to"
}

echo "| surface | before, s | after, s | ratio | same bytes | two threads over one | checker, s | of the extraction |"
echo "|---|---|---|---|---|---|---|---|"
while IFS=$'\t' read -r name kind expression domain periodic; do
  [[ $name == \#* || (-n $only && $name != *"$only"*) ]] && continue
  what=(--"$kind" "$expression")
  [[ $kind == surface ]] && what+=(--box="$domain") || what+=(--domain="$domain")
  [[ $periodic == - ]] || what+=(--periodic "$periodic")
  rm -f "$folder"/t.*
  for ((i = 0; i < runs; ++i)); do
    for which in old new; do
      clock %U "$folder/t.$which" "${!which}/crest" ridges "${what[@]}" --threads 1 --quiet \
        --certificate "$folder/$which.crest"
    done
    clock %R "$folder/t.one" "$new/crest" ridges "${what[@]}" --threads 1 --quiet
    clock %R "$folder/t.two" "$new/crest" ridges "${what[@]}" --threads 2 --quiet
    clock %U "$folder/t.check" taskset -c 0 "$new/crest-verify" "$folder/new.crest"
  done
  cmp -s "$folder/old.crest" "$folder/new.crest" && same=yes || same=no
  for t in old new one two check; do printf '%s ' "$(median <"$folder/t.$t")"; done |
    awk -v name="$name" -v same=$same '{
      printf "| %s | %.3f | %.3f | %.2f | %s | %.2f | %.3f | %.2f |\n", name, $1, $2, $1 / $2, same, $3 / $4, $5, $5 / $2
      print $1, $2, $5 >> "'"$folder/sums"'" }'
done <"$(dirname "$0")/smooth_speed.tsv"
awk '{ a += $1; b += $2; c += $3 } END {
  printf "| all | %.3f | %.3f | %.2f | | | %.3f | %.2f |\n", a, b, a / b, c, c / b }' "$folder/sums"
