#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the coder by g++ and clang++, with -O1 and -O3, and prints the digest of the streams that
# each makes and of what it decodes, a row each.
#   scripts/same_streams.sh [COMPILER...]     default: g++ clang++
# Exit code 1 if two differ.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- g++ clang++
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/main.cpp" <<'END'
#include "tests/coding/stream_digests.hpp"

int main() {
  int count = 0;
  const std::string digest = crest::tests::digest_of_streams(count);
  std::printf("%d, %s\n", count, digest.c_str());
}
END
ls algorithms/coding/*.cpp algorithms/sampling/random_triangulations.cpp \
  kernel/geometry/corner_table.cpp kernel/geometry/strip_tree.cpp kernel/predicates/within.cpp \
  "$work/main.cpp" >"$work/files"

echo "| compiler | options | streams and their digest |"
echo "|---|---|---|"
for compiler in "$@"; do
  for level in -O1 -O3; do
    mkdir "$work/objects"
    while read -r file; do
      "$compiler" -std=c++20 "$level" -DNDEBUG -ffp-contract=off -frounding-math -I. -w -c "$file" \
        -o "$work/objects/$(basename "$file").o"
    done <"$work/files"
    "$compiler" "$work"/objects/*.o -lgmp -lmpfr -lcrypto -o "$work/digests"
    digest=$("$work/digests")
    echo "| $("$compiler" --version | head -n 1) | $level | $digest |"
    echo "$digest" >>"$work/all"
    rm -r "$work/objects"
  done
done
[ "$(sort -u "$work/all" | wc -l)" -eq 1 ]
