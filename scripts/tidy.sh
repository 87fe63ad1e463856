#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# clang-tidy (.clang-tidy, warnings are errors) on the kernel, or on the sources given.
set -eu
cd "$(dirname "$0")/.."
if [ $# -eq 0 ]; then
  set -- $(git ls-files -co --exclude-standard 'kernel/*.cpp')
fi
# A folder of its own: clang reads no precompiled header of another compiler.
build=${CREST_BUILD:-build-tidy}
[ -f "$build/compile_commands.json" ] ||
  cmake -S . -B "$build" -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
printf '%s\n' "$@" | xargs -n 1 -P 2 clang-tidy --quiet -p "$build" \
  --extra-arg=-Wno-unknown-pragmas
