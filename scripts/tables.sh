#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the tables of experiments/tables.txt again, those named or all that are deterministic:
#   scripts/tables.sh [NAME ...]               writes experiments/PAPER/tables/NAME.md
#   scripts/tables.sh speed                    those of times, which want a quiet machine
#   scripts/tables.sh --check [quick|small|NAME ...] compares with what is stored: exit 1 if they
#                                              differ, 77 if nothing does but some were left out
# A table's first line has the command, the commit and the machine's kind; these and columns of times
# and memory are not compared. Needs scripts/experiments.sh first (CREST_BUILD: the build folder);
# those that read ../shared are left out without it.
set -eu
cd "$(dirname "$0")/.."

check=no
if [ "${1:-}" = --check ]; then check=yes; shift; fi
list=experiments/tables.txt
build=${CREST_BUILD:-build}

wanted() {  # SIZE NAME WANTED...
  size=$1; name=$2; shift 2
  [ $# -gt 0 ] || { [ "$size" != speed ]; return; }
  for w in "$@"; do
    [ "$w" != "$size" ] && [ "$w" != "$name" ] && [ "$w" != "$table" ] || return 0
  done
  return 1
}

# What is compared: no first line; of a table no column whose heading is a unit of time or memory.
compared() {
  tail -n +2 "$1" | awk '
    /^[|]/ {
      line = $0; sub(/^[|] */, "", line); sub(/ *[|]$/, "", line)
      n = split(line, cell, / *[|] */)
      if (!within) for (i = 1; i <= n; ++i)
        drop[i] = cell[i] ~ /^(s|ms|seconds)$|^s:| s$| s:| MB$|^us |quotient/
      within = 1; out = "|"
      for (i = 1; i <= n; ++i) if (!drop[i]) out = out " " cell[i] " |"
      print out; next
    }
    { within = 0; delete drop; print }'
}

machine="$(nproc) cores, $(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)"
commit=$(git describe --always --dirty --abbrev=12 2>/dev/null || echo "no repository")
differing=0
left_out=0
found=0
fresh=$(mktemp)
trap 'rm -f "$fresh" "$fresh.a" "$fresh.b"' EXIT
while read -r size table program arguments; do
  case $size in ''|'#'*) continue ;; esac
  name=${table##*/}
  wanted "$size" "$name" "$@" || continue
  found=1
  stored=experiments/${table%/*}/tables/$name.md
  if [ ! -d ../shared ] && grep -q '"../shared' "experiments/${table%/*}/$program.cpp"; then
    echo "$name: left out, it needs ../shared"; left_out=1; continue
  fi
  # shellcheck disable=SC2086
  if ! "$build/experiments/${table%/*}/$program" $arguments >"$fresh"; then
    echo "$name: FAILED"; differing=1; continue
  fi
  if [ $check = no ]; then
    sed "1s/\$/; commit $commit; $machine/" "$fresh" >"$stored"
    echo "$name: written"
    continue
  fi
  compared "$stored" >"$fresh.a"
  compared "$fresh" >"$fresh.b"
  if diff "$fresh.a" "$fresh.b" >"$fresh"; then
    echo "$name: as stored"
  else
    echo "$name: DIFFERS from $stored"; head -n 20 "$fresh"; differing=1
  fi
done <$list
[ $found = 1 ] || { echo "scripts/tables.sh: no such table: $*; see $list" >&2; exit 2; }
[ $differing = 0 ] && [ $left_out = 1 ] && exit 77
exit $differing
