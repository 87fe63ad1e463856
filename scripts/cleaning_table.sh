#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What `crest clean` makes of mesh files: file, exit code, vertices, faces, and what was cleaned or
# the line that refuses it.
#   scripts/cleaning_table.sh [FILE...]       default: all meshes of ../shared/data
#   OPTIONS="--split" scripts/cleaning_table.sh   with further options
#   CREST=PROGRAM scripts/cleaning_table.sh       default: build/cli/crest
# Fails on another exit code than 0 and 3, and where a refusal is not one line.
set -eu
cd "$(dirname "$0")/.."
crest=$(realpath "${CREST:-build/cli/crest}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

if [ $# -eq 0 ]; then
  find ../shared/data -type f \( -iname '*.off' -o -iname '*.obj' -o -iname '*.ply' -o -iname '*.stl' \
    -o -iname '*.vtp' -o -iname '*.vtu' -o -iname '*.vtk' -o -iname '*.msh' -o -iname '*.ply.xz' \) |
    LC_ALL=C sort >"$folder/files"
else
  printf '%s\n' "$@" >"$folder/files"
fi

# number KEY: of the report; the keys of `cleanup` are nowhere else.
number() { sed -n "s/^ *\"$1\": \([0-9]*\),*$/\1/p" "$folder/report.json" | head -n 1; }

cleaned() {
  sed -n '/"cleanup"/,/}/s/^ *"\([a-z_]*\)": \([0-9]*\),*$/\1 \2/p' "$folder/report.json" |
    awk '$2 != 0 { printf "%s%s %s", sep, $2, $1; sep = ", " }'
}

answered=0 refused=0 failed=0
printf '%-44s %4s %8s %8s  %s\n' file exit vertices faces "cleaned, or why not"
while read -r file; do
  path=$file
  case $file in
    *.xz)
      path=$folder/$(basename "$file" .xz)
      xz -dc "$file" >"$path"
      ;;
  esac
  code=0
  # shellcheck disable=SC2086
  "$crest" clean "$path" ${OPTIONS:-} --quiet --report "$folder/report.json" 2>"$folder/stderr" || code=$?
  case $code in
    0)
      answered=$((answered + 1))
      printf '%-44s %4d %8d %8d  %s\n' "${file#../shared/data/}" 0 "$(number vertices)" \
        "$(number faces)" "$(cleaned)"
      ;;
    *)
      refused=$((refused + 1))
      [ $code -eq 3 ] && [ "$(wc -l <"$folder/stderr")" -eq 1 ] || failed=$((failed + 1))
      printf '%-44s %4d %8s %8s  %s\n' "${file#../shared/data/}" $code - - \
        "$(sed "s|crest: $path: ||" "$folder/stderr" | head -n 1)"
      ;;
  esac
done <"$folder/files"
echo "$answered answered, $refused refused, $failed of these not in one line with exit code 3"
[ $failed -eq 0 ]
