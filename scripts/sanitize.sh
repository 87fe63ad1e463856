#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the tests of folders with AddressSanitizer and UndefinedBehaviorSanitizer (in build-asan/),
# runs them and prints what was run, a row a folder.
#   scripts/sanitize.sh [FOLDER...]     folders of tests/; default: all
# Exit code 1 if a test fails or a sanitizer complains.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- $(cd tests && ls -d */ | tr -d / | grep -vxE 'support|fuzz|install')
log=build-asan/sanitize.log
mkdir -p build-asan
cmake --preset asan -DCREST_BUILD_TESTS=ON >$log || { tail -n 20 $log >&2; exit 1; }
cmake --build build-asan --target "${@/#/test_}" >>$log || { tail -n 40 $log >&2; exit 1; }

echo "$(c++ --version | head -n 1); -fsanitize=address,undefined"
echo
echo "| tests | processor time, s | cases and assertions | result |"
echo "|---|---|---|---|"
failed=0
TIMEFORMAT="%U %S"
for folder in "$@"; do
  result=passed
  { time find build-asan/tests -name "test_$folder" -type f -exec {} \; >"$log.$folder" 2>&1; } \
    2>"$log.time" || result=failed
  if grep -qE "runtime error:|ERROR: (Address|Leak)Sanitizer" "$log.$folder" ||
    ! grep -q "^All tests passed" "$log.$folder"; then
    result=failed
    tail -n 40 "$log.$folder" >&2
  fi
  [ $result = passed ] || failed=1
  used=$(awk 'END { printf "%.1f", $1 + $2 }' "$log.time")
  echo "| $folder | $used | $(grep -E '^All tests passed|^test cases:' "$log.$folder" | tail -n 1) | $result |"
done
exit $failed
