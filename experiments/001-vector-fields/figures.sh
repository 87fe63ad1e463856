#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Figures 5.10 to 5.23 on the twins, as pictures in a folder:
# experiments/001-vector-fields/figures.sh FOLDER [BUILD]
set -eu
folder=$1
build=${2:-build}
crest=$build/cli/crest
mkdir -p "$folder"
# Exit code 1: something is undecided, which is written nevertheless.
run() {
  "$crest" "$@" --quiet || [ $? -eq 1 ]
}
for twin in bodden skin; do
  field=$folder/$twin.vtu
  run sample twin-$twin -o "$field"
  for notion in original strong relaxed; do
    run compress "$field" --equivalence $notion -o "$folder/$twin-$notion.vtu" --picture "$folder/$twin-$notion.png"
    case $twin in
      bodden) part=44,34,64,54 ;;
      skin) part=0.15,2,0.35,4 ;;
    esac
    run compress "$field" --equivalence $notion -o "$folder/$twin-$notion.vtu" --picture "$folder/$twin-$notion-close.png" --close-up $part
  done
  for w in 0 0.5 1; do
    run skeleton "$field" --simplify $w -o "$folder/$twin-$w.vtp" --picture "$folder/$twin-important-$w.png"
    run compress "$field" --simplify $w -o "$folder/$twin-$w.vtu" --picture "$folder/$twin-simpler-$w.png"
  done
  run skeleton "$field" --simplify 0.5 --paths "$folder/$twin-paths.vtp"
done
"$build/experiments/001-vector-fields/collapse_figures" --folder "$folder"
