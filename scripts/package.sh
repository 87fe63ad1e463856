#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes build/package/crest_*.deb of the built programs. With --try (root; Debian: debootstrap) installs
# it in a bare Debian 12 of its own and runs the programs there: sample, extract, verify.
set -eu
cd "$(dirname "$0")/.."

build=${CREST_BUILD:-build}
(cd "$build" && cpack -G DEB -B package >/dev/null)
deb=$(ls -t "$build"/package/crest_*.deb | head -n 1)
echo "$deb"
[ "${1:-}" = --try ] || exit 0

root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
debootstrap --variant=minbase bookworm "$root" >/dev/null
cp "$deb" "$root/crest.deb"
chroot "$root" sh -euc '
  export DEBIAN_FRONTEND=noninteractive LC_ALL=C
  apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends /crest.deb >/dev/null
  cd /tmp
  crest --version
  crest sample ellipsoid --vertices 1500 -o e.off --quiet
  crest ridges e.off -o e.vtp --picture e.png --certificate e.crest --quiet
  crest-verify e.crest --input e.off
  crest-verify-ridges-mesh e.crest
  test -s e.vtp && test -s e.png
  apt-get purge -y -qq -o Dpkg::Use-Pty=0 crest >/dev/null
  test ! -e /usr/bin/crest'
echo "installed, run and removed in a bare Debian 12"
