#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds and runs all tests. Options:
#   --asan       with AddressSanitizer and UndefinedBehaviorSanitizer (in build-asan/)
#   --no-install leave the machine's packages alone
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh
start=$(date +%s.%N)

preset=release
folder=build
install=yes
for option in "$@"; do
  case $option in
    --asan) preset=asan; folder=build-asan ;;
    --no-install) install=no ;;
    *) echo "usage: scripts/test.sh [--asan] [--no-install]" >&2; exit 2 ;;
  esac
done

[ $install = no ] || step "Install missing packages" ./scripts/install_deps.sh
# Tests on by name: the demo configures the same folder without them.
# The Python package against Debian's interpreter, whatever comes first on PATH. Under the sanitizers
# an interpreter without them cannot load it.
python=ON
[ $preset = release ] || python=OFF
step "Configure ($preset, in $folder/)" cmake --preset $preset -DCREST_BUILD_TESTS=ON \
  -DCREST_WITH_PYTHON=$python -DPython_EXECUTABLE=/usr/bin/python3
step "Build" cmake --build $folder
echo "Run the tests (2 at a time)"
tests_start=$(date +%s.%N)
result=0
ctest --test-dir $folder -j2 --output-on-failure --progress >"$steps_log" 2>&1 || result=$?
if [ $result -ne 0 ]; then
  tail -n 400 "$steps_log"
fi
summary=$(grep -E '^[0-9]+% tests passed' "$steps_log" || echo "no test was run")
[ "$summary" != "no test was run" ] || result=1
skipped=$(grep -cE '\(Skipped\)$' "$steps_log" || true)
verdict=PASSED
[ $result -eq 0 ] || verdict=FAILED
echo "$summary; $skipped skipped"
printf '%s; tests %s s, all steps %s s\n' "$verdict" \
  "$(seconds_since "$tests_start")" "$(seconds_since "$start")"
exit $result
