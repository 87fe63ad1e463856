#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The processor time of a clean build, a folder a line; it builds in build-cost/ (compilers only:
# linking is a few seconds). Options:
#   --tests        then the tests' too, a folder a line
#   TARGET...      what to build (default: all; the experiments are "experiments")
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh
folder=build-cost

tests=no
if [ "${1:-}" = "--tests" ]; then
  tests=yes
  shift
fi
[ $# -gt 0 ] || set -- all

# The launcher leaves a compiler's times beside what it wrote.
rm -rf "$folder"
mkdir "$folder"
cat >"$folder/launcher" <<'END'
#!/bin/sh
output=
for word in "$@"; do
  [ "$output" != "-o" ] || { output=$word; break; }
  [ "$word" != "-o" ] || output=-o
done
code=0
"$@" || code=$?
[ -z "$output" ] || times >"$output.cost"
exit $code
END
chmod +x "$folder/launcher"
export CCACHE_DISABLE=1
step "Configure (release, in $folder/)" cmake --preset release -B "$folder" -DCREST_BUILD_TESTS=ON \
  -DCMAKE_CXX_COMPILER_LAUNCHER="$PWD/$folder/launcher"
step "Build" cmake --build "$folder" --target "$@"

# seconds MINUTES_AND_SECONDS, as "times" writes them.
seconds='function seconds(text) { split(text, part, /[ms]/); return 60 * part[1] + part[2] }'
# tests/CMakeFiles/test_kernel.dir/kernel/jet_test.cpp.o.cost -> tests/kernel
echo "Build, processor time"
(cd "$folder" && find . -name '*.cost' -exec awk "$seconds"'
  FNR == 2 {
    count = split(FILENAME, part, "/")
    name = part[2]
    if (FILENAME ~ /cmake_pch/) name = name "/ (precompiled headers)"
    else if (count > 5) name = name "/" part[5]
    print seconds($1) + seconds($2), name
  }' {} +) | awk '
  { cost[$2 FS $3 FS $4] += $1; units[$2 FS $3 FS $4]++; all += $1 }
  END {
    for (name in cost) printf "%9.1f s %4d units  %s\n", cost[name], units[name], name | "sort -k4"
    close("sort -k4")
    printf "%9.1f s %4d units  all\n", all, NR
  }'

[ $tests = yes ] || exit 0
echo "Tests, processor time"
ctest --test-dir "$folder" -N | sed -n 's/^ *Test *#[0-9]*: \([a-z_]*\): .*/\1/p' | sort -u |
  while read -r name; do
    (ctest --test-dir "$folder" -R "^$name: " >/dev/null 2>&1 || echo "tests failed: $name" >&2
      times) | awk "$seconds"'
      NR == 2 { printf "%9.1f s  %s\n", seconds($1) + seconds($2), "'"$name"'" }'
  done
