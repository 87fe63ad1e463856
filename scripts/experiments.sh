#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the experiments into build/experiments/, or those named: scripts/experiments.sh growth
# (packages: scripts/install_deps.sh). With all of them, the quick tables (experiments/tables.txt) are
# made again and compared with the stored ones.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

targets=experiments
[ $# -eq 0 ] || targets=$(printf 'experiment_%s ' "$@")
step "Configure (release, in build/)" cmake --preset release -DCREST_BUILD_TESTS=ON
step "Build the experiments" cmake --build build --target $targets
[ $# -gt 0 ] || step "Compare the quick tables" \
  ctest --test-dir build -C Experiments -R '^tables: ' --no-tests=error --output-on-failure
