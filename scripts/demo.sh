#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# From a fresh Debian 12 to certified ridges: installs what is missing, builds, samples the blend of
# two ellipsoids, extracts its ridges and umbilics, verifies the certificate. Results are in out/.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh
start=$(date +%s.%N)

step "Install missing packages" ./scripts/install_deps.sh
step "Configure (release, in build/)" cmake --preset release -DCREST_BUILD_TESTS=OFF
step "Build crest and crest-verify" cmake --build build --target crest crest-verify
mkdir -p out
step "Sample the blend, 40000 vertices" ./build/cli/crest sample blend --vertices 40000 -o out/blend.off
step "Extract ridges and umbilics" ./build/cli/crest ridges out/blend.off -o out/blend.vtp \
  --picture out/blend.svg --report out/blend.json --certificate out/blend.crest
sed 's/^/    /' "$steps_log"
step "Verify the certificate" ./build/cli/crest-verify out/blend.crest --input out/blend.off
sed 's/^/    /' "$steps_log"
step "Verify again with MPFR arithmetic" ./build/cli/crest-verify out/blend.crest --arithmetic mpfr

printf '%-44s%8.1f s\n' "All steps" "$(seconds_since "$start")"
echo "In out/: blend.vtp (ParaView), blend.svg (picture), blend.json (report), blend.crest (certificate)"
