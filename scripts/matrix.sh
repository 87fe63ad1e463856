#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs every command with default options and every format of its outputs on a dozen meshes, and on
# volumes, points, tensors and plane fields where there is ../shared, and prints
# a table: command, file, exit code, processor time, bytes of what was written; the sum of the times last.
#   scripts/matrix.sh [FILE...]     default: meshes of ../shared/data, or of `crest sample` without it
#   CREST=PROGRAM scripts/matrix.sh        default: build/cli/crest
# Fails on another exit code than 0, 1, 3 or 4, on an output that holds appended data or a number that
# is not finite, and on a file that is left by a run that refused its input.
set -eu
cd "$(dirname "$0")/.."
crest=$(realpath "${CREST:-build/cli/crest}")
meshes=../shared/data/meshes
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

if [ $# -eq 0 ] && [ -d "$meshes" ]; then
  set --
  for name in anchor.off bunny_3k.off cow.obj dino.off elephant.off fandisk.off horse.ply moebius.obj \
    rocker-arm.obj rotor.off stanford-bunny.obj suzanne.obj; do
    set -- "$@" "$meshes/$name"
  done
elif [ $# -eq 0 ]; then
  for surface in blend ellipsoid handles plane sphere torus; do
    for vertices in 300 3000; do
      "$crest" sample $surface --vertices $vertices -o "$folder/$surface-$vertices.off" --quiet
      set -- "$@" "$folder/$surface-$vertices.off"
    done
  done
fi

failures=0
total=0
TIMEFORMAT="%U %S"
fail() {
  echo "  FAILED: $*"
  failures=$((failures + 1))
}

# not_finite FILE: a word that is no finite number, outside of base64 and names.
not_finite() {
  case $1 in
    *.vtp | *.vtu | *.obj | *.ply | *.off | *.json | *.svg)
      sed -E 's/base64,[A-Za-z0-9+\/=]*//; /^#/d' "$1" |
        grep -aEiq '(^|[[:space:],:"[ML])[-+]?(nan|inf|infinity)([],[:space:]"]|$)' ;;
    *) return 1 ;;
  esac
}

# run FILE COMMAND [ARGUMENT...]: outputs go to the empty folder out/.
run() {
  file=$1
  shift
  rm -rf "$folder/out"
  mkdir "$folder/out"
  code=0
  { time (cd "$folder/out" && "$crest" "$@" --quiet >../stdout 2>../stderr); } 2>"$folder/time" || code=$?
  seconds=$(awk '{ printf "%.2f", $1 + $2 }' "$folder/time")
  total=$(awk -v sum="$total" -v more="$seconds" 'BEGIN { printf "%.2f", sum + more }')
  sizes=
  for output in "$folder"/out/* "$folder"/out/.[!.]*; do
    [ -e "$output" ] || continue
    sizes="$sizes ${output##*/}=$(wc -c <"$output")"
  done
  printf '%-10s %-24s %4d %8s %s\n' "$1" "$(basename "$file")" $code "$seconds" "${sizes# }"
  case $code in
    0 | 1 | 4) [ -n "$sizes" ] || fail "nothing was written: $*" ;;
    3) [ -z "$sizes" ] || fail "exit code 3 left files: $*"
      [ "$(wc -l <"$folder/stderr")" -eq 1 ] || fail "not one line on stderr: $*" ;;
    *) fail "exit code $code: $* ($(head -n 1 "$folder/stderr"))" ;;
  esac
  for output in "$folder"/out/*; do
    [ -e "$output" ] || continue
    if grep -aq AppendedData "$output"; then fail "${output##*/} holds appended data: $*"; fi
    if not_finite "$output"; then fail "${output##*/} holds a number that is not finite: $*"; fi
  done
}

printf '%-10s %-24s %4s %8s %s\n' command file exit seconds "bytes of outputs"
for file in "$@"; do
  path=$(realpath "$file")
  for format in vtp obj ply; do
    run "$file" ridges "$path" -o ridges.$format --picture p.svg --certificate c.crest --report r.json
  done
  for format in vtp vtu ply; do
    run "$file" curvature "$path" -o curvature.$format --focal focal.vtp --focal-picture f.svg \
      --picture p.png --report r.json
  done
  for format in vtp obj; do
    run "$file" features "$path" -o features.$format --picture p.svg --certificate c.crest --report r.json
  done
  for format in vtp vtu; do
    run "$file" reeb "$path" --expression z -o reeb.$format --picture p.svg --certificate c.crest \
      --report r.json
  done
done
for format in off obj ply vtp; do
  run "$format" sample ellipsoid -o "ellipsoid.$format" --report r.json
done
for format in vtp obj ply; do
  run "$format" ridges --surface 'x^2 + y^2/2.25 + z^2/4 - 1' --box=-3,3 -o ridges.$format \
    --mesh mesh.$format --picture p.svg --certificate c.crest --report r.json
done

# Other inputs: made by `crest sample`, and of the shared data.
inputs() {  # FOLDER FILE...: those that are there
  for name in "${@:2}"; do
    [ ! -e "../shared/data/$1/$name" ] || realpath "../shared/data/$1/$name"
  done
}
made() {  # SURFACE FILE
  "$crest" sample "$1" -o "$folder/$2" --quiet
  echo "$folder/$2"
}
for path in $(made moebius-sheet sheet.nrrd) \
  $(inputs volumes EMD-3001.map neghip.nrrd hydrogen_64.vti HeadMRVolume.mhd nut.nrrd bucky_32.nrrd ironProt.vtk); do
  for format in vtp obj ply; do
    run "$path" extremal "$path" --ridge -o extremal.$format --picture p.png --certificate c.crest --report r.json
  done
done
for path in $(made hemisphere-points hemisphere.xyz) $(inputs points sphere_1k.xyz); do
  for format in vtp obj ply; do
    run "$path" extremal "$path" --surface -o extremal.$format --picture p.png --report r.json
  done
done
for path in $(made block-twist twist.vtu) $(inputs tensors bunny_stress.vtk notch_stress_fixed.vtk); do
  for format in vtp obj ply; do
    run "$path" modes "$path" --mode 0.9 --neutral -o modes.$format --picture p.png --certificate c.crest --report r.json
  done
  run "$path" modes "$path" --degenerate -o curves.vtp --certificate c.crest --report r.json
done
for path in $(made lattice lattice.vtu) $(inputs vectorfields cylinder_Re35.vtk wind_gfs_2014-11-30.json \
  cylinder_slice_513x65.vti piv_insight_run1.vec piv_challenge_B00001.txt water_gbr.json sqflow2D-1608.nrrd); do
  run "$path" skeleton "$path" -o skeleton.vtp --picture p.png --certificate c.crest --report r.json
done
for path in $(made torus torus.off) $(inputs meshes moebius.obj suzanne.obj teapot.obj fandisk.off); do
  for format in svg pdf eps vtp; do
    run "$path" lineart "$path" --style contours -o lines.$format --certificate c.crest --report r.json
  done
done
for path in $folder/torus.off $(inputs meshes spot.obj); do
  for format in svg pdf eps vtp; do
    run "$path" lineart "$path" -o lines.$format --certificate c.crest --report r.json
  done
done
echo "processor time of all runs: $total s"
[ $failures -eq 0 ] || { echo "$failures failures"; exit 1; }
