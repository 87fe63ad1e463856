#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Files of Crest and of Draco for the same meshes at Draco's own steps, as a Markdown table (README.md
# beside this file).
#   draco.sh CREST MESH...    CREST: the program; draco_encoder is found by its name
set -eu
export LC_ALL=C
crest=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Crest within the tolerance at which its step is Draco's; prints bytes of the file and seconds.
row() {
  mesh=$1 name=$(basename "$1")
  # The same triangles for both: Draco reads no OFF.
  "$crest" encode "$mesh" --method valence -o "$work/m.cmc" >/dev/null 2>&1 || return 0
  "$crest" decode "$work/m.cmc" -o "$work/m.obj" >/dev/null 2>&1
  line="| $name | $(grep -c '^v ' "$work/m.obj")"
  for bits in 11 14; do
    tolerance=$(awk -v bits=$bits '$1 == "v" {
        for (k = 2; k <= 4; ++k) {
          if (!(k in low) || $k < low[k]) low[k] = $k
          if (!(k in high) || $k > high[k]) high[k] = $k
        }
      }
      END {
        for (k in low) if (high[k] - low[k] > range) range = high[k] - low[k]
        printf "%.17g", range / (2 ^ bits - 1) * sqrt(3) / 2
      }' "$work/m.obj")
    "$crest" encode "$work/m.obj" --tolerance "$tolerance" -o "$work/c.cmc" >/dev/null 2>&1
    draco_encoder -i "$work/m.obj" -qp $bits -cl 10 -o "$work/d.drc" >/dev/null
    line="$line | $(stat -c %s "$work/c.cmc") | $(stat -c %s "$work/d.drc")"
  done
  echo "$line |"
}

echo "| mesh | vertices | Crest, 11 bits | Draco | Crest, 14 bits | Draco |"
echo "|---|---|---|---|---|---|"
for mesh in "$@"; do row "$mesh"; done
