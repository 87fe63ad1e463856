#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the ParaView plugin (docs/paraview.md) in build-paraview/ and runs its tests in ParaView's
# Python, with one process and with two. Not part of scripts/test.sh.
#   ./scripts/paraview.sh                     # install what is missing, build, test
#   ./scripts/paraview.sh --build             # without the tests
#   ./scripts/paraview.sh --pictures FOLDER   # make the pictures of docs/paraview.md
#
# Debian's python3-paraview conflicts with python3-vtk9, on which libvtk9-dev depends, and the CMake
# files of paraview-dev want the modules of python3-paraview. So the three packages of ParaView are
# unpacked into build-paraview/debian, and nothing is removed.
set -eu
cd "$(dirname "$0")/.."
root=$PWD
out=$root/build-paraview
mkdir -p "$out/debian" "$out/work"

# What ParaView needs, and what the CMake files of paraview-dev demand without declaring it.
packages="paraview xvfb x11-utils openmpi-bin qtbase5-dev qttools5-dev libqt5svg5-dev
  qtxmlpatterns5-dev-tools libqt5opengl5-dev libutfcpp-dev libogg-dev libtheora-dev libgdal-dev
  libgl2ps-dev libglew-dev libdouble-conversion-dev libavcodec-dev libavformat-dev libavutil-dev
  libswscale-dev libnetcdf-dev libjsoncpp-dev liblz4-dev liblzma-dev libtiff-dev libxt-dev
  libxcursor-dev libpython3-dev python3-mpi4py libopenmpi-dev"
missing=""
for package in $packages; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = "installed" ] || missing="$missing $package"
done
if [ -n "$missing" ]; then
  echo "Installing:$missing"
  run=""
  [ "$(id -u)" -eq 0 ] || run="sudo"
  $run env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi
./scripts/install_deps.sh

paraview=$out/debian/usr
if [ ! -x "$paraview/bin/pvpython" ]; then
  (cd "$out" && apt-get download paraview paraview-dev python3-paraview)
  for package in "$out"/*paraview*.deb; do
    dpkg -x "$package" "$out/debian"
    rm "$package"
  done
fi
libraries=$paraview/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)

# The programs to compare with, and the libraries as installed, without io/.
[ -f build/CMakeCache.txt ] || cmake -S . -B build -G Ninja
cmake --build build --target crest crest-verify
cmake --install build --prefix "$out/prefix" --component development >/dev/null
cmake -S plugins/paraview -B "$out/plugin" -G Ninja -D CMAKE_PREFIX_PATH="$out/prefix" \
  -D ParaView_DIR="$libraries/cmake/paraview-5.11"
cmake --build "$out/plugin"
plugin=$out/plugin/lib/paraview-5.11/plugins/Crest/Crest.so
echo "The plugin: $plugin"
[ "${1:-}" != "--build" ] || exit 0

# ParaView's Debian build draws in X only. -noreset: a server that starts anew whenever its last
# client leaves refuses the next one for a moment, and ParaView aborts.
rm -f "$out/display"
Xvfb -displayfd 3 -screen 0 1400x1000x24 -nolisten tcp -noreset 3>"$out/display" 2>/dev/null &
server=$!
trap 'kill $server' EXIT
until [ -s "$out/display" ]; do sleep 0.2; done
DISPLAY=:$(cat "$out/display")
export DISPLAY
export LD_LIBRARY_PATH="$libraries"
export CREST_PLUGIN="$plugin" CREST_WORK="$out/work"
export CREST="$root/build/cli/crest" CREST_VERIFY="$root/build/cli/crest-verify"
tests=$root/plugins/paraview/tests
if [ "${1:-}" = "--pictures" ]; then
  "$paraview/bin/pvpython" "$tests/pictures.py" "$2"
  exit
fi
rm -f "$out/work"/*
for test in certificates behaviour pictures; do
  echo "== $test"
  "$paraview/bin/pvpython" "$tests/$test.py"
done
echo "== ranks"
as_root=""
[ "$(id -u)" -ne 0 ] || as_root="--allow-run-as-root"
mpirun $as_root --oversubscribe -np 2 "$paraview/bin/pvbatch" "$tests/ranks.py"
