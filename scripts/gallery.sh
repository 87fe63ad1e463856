#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pages of docs/gallery, one a system, of samples.
#   scripts/gallery.sh [--real] [FOLDER]
# FOLDER: writes them there; --real: of scans and volumes of ../shared, which are not the project's
# to publish, so that a FOLDER has to be given.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh
crest=$PWD/${CREST_BUILD:-build}/cli/crest
real=no
if [ "${1:-}" = --real ]; then
  real=yes
  shift
  [ $# -gt 0 ] || { echo "usage: scripts/gallery.sh [--real] [FOLDER]" >&2; exit 2; }
fi
to=$(realpath -m "${1:-docs/gallery}")
mkdir -p "$to"
work=$(mktemp -d)
trap 'rm -rf "$work"; rm -f "$steps_log"' EXIT
data=$(realpath -m ../shared/data)
[ $real = yes ] || data=$work/none
cd "$work"

# real NAME FILE SAMPLE...: NAME is the file of ../shared, or a sample.
real() {
  name=$1 file=$2
  shift 2
  if [ -f "$data/$file" ]; then cp "$data/$file" "$name"; else $crest sample "$@" -o "$name" --quiet; fi
}
# page NAME COMMAND...: the page docs/gallery/NAME.html.
page() {
  name=$1
  shift
  step "$name.html" "$crest" "$@" --page "$name.html"
  mv "$name.html" "$to/"  # the page names the command
}

$crest sample blend --vertices 3000 -o blend.off --quiet
page ridges ridges blend.off --all --certificate blend.crest
real scan.obj meshes/kitten.obj perturbed-torus --vertices 9000
page ridges-scan ridges scan.obj
page ridges-proven ridges --param '(1 + (0.45 + 0.1*cos(u))*cos(v))*cos(u); (1 + (0.45 + 0.1*cos(u))*cos(v))*sin(u); (0.45 + 0.1*cos(u))*sin(v) + 0.2*sin(u)' \
  --domain '0,2*pi,0,2*pi' --periodic uv --seconds 120
real animal.off meshes/dino.off handles --vertices 4000
page curvature curvature animal.off --method jet
real part.off meshes/fandisk.off handles --vertices 6000
page features features part.off --angle 25 --prune 2 --close-branches 3
$crest sample handles --parameters 3 --vertices 6000 -o handles.off --quiet
page reeb reeb handles.off --expression 'x + 0.2*y' --linear
$crest sample block-single --vertices 700 -o block.vtu --quiet
page modes modes block.vtu --mode 0.97 --up 0,0,1
if [ -f "$data/volumes/EMD-3001.map" ]; then
  cp "$data/volumes/EMD-3001.map" .
  page extremal extremal EMD-3001.map --ridge --tensor-sigma 2 --min-value 0.1
else
  $crest sample moebius-sheet --nodes 32 -o sheet.nrrd --quiet
  page extremal extremal sheet.nrrd --ridge --min-value 0.4
fi
$crest sample twin-bodden -o twin-bodden.vtu --quiet
page skeleton skeleton twin-bodden.vtu --vectors flow
if [ -f "$data/volumes/hydrogen_64.vti" ]; then
  cp "$data/volumes/hydrogen_64.vti" .
  page spline spline hydrogen_64.vti --isovalue 0.2
else
  $crest sample genus2-shell --nodes 32 -o shell.vti --quiet
  page spline spline shell.vti --isovalue 0.4
fi
page strips strips animal.off
page lineart lineart animal.off --view 40,15 --spacing 1.4
