#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Formats all sources (.clang-format); --check only reports and fails where something would change.
set -eu
cd "$(dirname "$0")/.."
mode="-i"
[ "${1:-}" != "--check" ] || mode="--dry-run --Werror"
git ls-files -co --exclude-standard '*.cpp' '*.hpp' | xargs clang-format $mode
