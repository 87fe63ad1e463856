#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Opens pages of --page in a real browser (headless Chromium) and uses them: switches, sliders, drags,
# picks, keys, the certificate, screenshots against the stored ones. Skipped where there is no
# Chromium, node or npm registry. Options:
#   --update   store the screenshots anew
#   --large    turn a surface of a million triangles instead, and print what a frame costs
#   --keep F   leave pages and screenshots in folder F
set -eu
cd "$(dirname "$0")/.."
build=${CREST_BUILD:-build}
update="" keep="" large=""
while [ $# -gt 0 ]; do
  case $1 in
    --update) update=--update ;;
    --large) large=--large ;;
    --keep) shift; keep=$1 ;;
    *) echo "usage: scripts/test_page.sh [--update] [--large] [--keep FOLDER]" >&2; exit 2 ;;
  esac
  shift
done

skip() {
  echo "SKIPPED: pages in a browser: $1"
  exit 0
}
browser=$(command -v chromium || command -v chromium-browser || true)
[ -n "$browser" ] || skip "no chromium (apt-get install chromium)"
command -v node >/dev/null || skip "no node"
command -v npm >/dev/null || skip "no npm"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tools=$folder
if [ -n "${CREST_PLAYWRIGHT:-}" ]; then
  tools=$CREST_PLAYWRIGHT
else
  timeout 60 npm install --prefix "$folder" --no-audit --no-fund --no-package-lock --loglevel=error \
    playwright-core@1.48.2 >"$folder/npm.log" 2>&1 || skip "npm cannot give playwright-core"
fi

crest=$PWD/$build/cli/crest
pages=${keep:-$folder/pages}
mkdir -p "$pages"
if [ -n "$large" ]; then
  $crest sample torus --vertices 500000 -o "$folder/torus.ply" --quiet
  $crest curvature "$folder/torus.ply" --page "$pages/million.html" --quiet
  NODE_PATH=$tools/node_modules node tests/page/browser.cjs --browser "$browser" --pages "$pages" $large
  exit
fi
$crest sample ellipsoid --parameters 1,1.5,2 --rotate --vertices 1200 -o "$folder/ellipsoid.off" --quiet
$crest ridges "$folder/ellipsoid.off" --all --certificate "$folder/ridges.crest" \
  --page "$pages/ridges.html" --quiet
$crest sample blend --vertices 12000 -o "$folder/blend.off" --quiet
$crest features "$folder/blend.off" --threshold 0.9 --prune 3 --page "$pages/features.html" --quiet
$crest reeb "$folder/ellipsoid.off" --expression 'x*x - y*z' --page "$pages/reeb.html" --quiet
NODE_PATH=$tools/node_modules node tests/page/browser.cjs --browser "$browser" --pages "$pages" \
  --stored tests/page/screenshots $update
