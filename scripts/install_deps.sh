#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian 12 packages that Crest needs and that are missing (apt; sudo when not root).
# scripts/install_deps.sh --list prints the names.
set -eu

packages="build-essential cmake ninja-build pkg-config git ca-certificates
  libcgal-dev libgmp-dev libmpfr-dev libflint-dev libflint-arb-dev libeigen3-dev libboost-dev libtbb-dev libfmt-dev libssl-dev
  nlohmann-json3-dev libcli11-dev catch2 libvtk9-dev libcairo2-dev libnetcdf-dev
  zlib1g-dev libdeflate-dev liblzma-dev
  libpython3-dev pybind11-dev python3-numpy python3-pytest python3-pip"

if [ "${1:-}" = "--list" ]; then
  printf '%s\n' $packages
  exit 0
fi

missing=""
for package in $packages; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = "installed" ] || missing="$missing $package"
done
if [ -z "$missing" ]; then
  echo "All packages are installed."
  exit 0
fi

echo "Installing:$missing"
run=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Need root or sudo to install:$missing" >&2; exit 1; }
  run="sudo"
fi
export DEBIAN_FRONTEND=noninteractive
$run apt-get update -qq
$run env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
echo "Installed."
