#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the experiments into build/experiments/, or those named: scripts/experiments.sh growth
# (packages: scripts/install_deps.sh).
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

targets=experiments
[ $# -eq 0 ] || targets=$(printf 'experiment_%s ' "$@")
step "Configure (release, in build/)" cmake --preset release
step "Build the experiments" cmake --build build --target $targets
