#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds crest-verify as one JavaScript file for pages, WebAssembly inside: build-wasm/crest-verify.js
# (docs/verify-in-a-page.md). Not part of the build: it takes minutes and needs Debian's packages
#   emscripten nodejs cmake ninja-build dpkg-dev libboost-dev libcgal-dev libfmt-dev
# and the sources of gmp and mpfr4, which it fetches (deb-src of this Debian, in its own lists) unless
# CREST_SOURCES names a folder that holds them (.dsc and tarballs).
#   scripts/wasm.sh           build
#   scripts/wasm.sh --test    and try a certificate of every claim in node, against build/cli/crest-verify
# Built in build-wasm/, or in CREST_WASM_BUILD; programs of CREST_BUILD (build).
set -eu
cd "$(dirname "$0")/.."
root=$PWD
build=${CREST_WASM_BUILD:-build-wasm}
mkdir -p "$build/sources"
build=$(cd "$build" && pwd)
prefix=$build/prefix
log=$build/log

# emcc is written in JavaScript, too: a node that is not Debian's finds neither Debian's modules nor
# the file system behind a fetch of its own.
export NODE_PATH=/usr/share/nodejs NODE_OPTIONS=--no-experimental-fetch
unset EM_CACHE  # Debian's cache is frozen, and complete

say() { printf '%s\n' "$*" >&2; }
quietly() { # STEP COMMAND...: the log's end if it fails
  local step=$1 code=0
  shift
  say "$step"
  set +e  # "|| ..." would switch it off inside the command, too
  (set -e; "$@") >"$log" 2>&1
  code=$?
  set -e
  [ $code -eq 0 ] || { tail -n 30 "$log" >&2; say "$step: failed"; exit 1; }
}

fetch_sources() {
  local apt=$build/apt
  mkdir -p "$apt/parts" "$apt/lists/partial" "$apt/cache/archives/partial"
  cat >"$apt/parts/source.sources" <<END
Types: deb-src
URIs: http://deb.debian.org/debian
Suites: $(. /etc/os-release && echo "$VERSION_CODENAME")
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
END
  local options=(-o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$apt/parts"
    -o Dir::State::Lists="$apt/lists" -o Dir::Cache="$apt/cache")
  apt-get "${options[@]}" update
  cd "$build/sources"
  apt-get "${options[@]}" source --download-only gmp mpfr4
}

unpack() { # PACKAGE
  rm -rf "$build/$1"
  dpkg-source --no-check -x "$build"/sources/"$1"_*.dsc "$build/$1"
}

build_gmp() {
  unpack gmp
  cd "$build/gmp"
  # Debian leaves the documents out, and the Makefile asks for them.
  mkdir -p doc
  [ -f doc/Makefile.in ] || printf 'all install:\n' >doc/Makefile.in
  emconfigure ./configure --host=none-unknown-none --disable-assembly --disable-shared \
    --prefix="$prefix" CFLAGS="-O2 -DNDEBUG" CC_FOR_BUILD=cc
  emmake make -j"$(nproc)"
  emmake make install
}

build_mpfr() {
  unpack mpfr4
  cd "$build/mpfr4"
  emconfigure ./configure --host=none-unknown-none --disable-thread-safe --disable-shared \
    --with-gmp="$prefix" --prefix="$prefix" CFLAGS="-O2 -DNDEBUG"
  emmake make -C src -j"$(nproc)"
  emmake make -C src install
}

build_checker() {
  # Headers without libraries, and nothing else of /usr/include.
  for headers in boost CGAL fmt; do ln -sfn /usr/include/$headers "$prefix/include/$headers"; done
  cmake -S "$root/cli/verify_page" -B "$build/checker" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_TOOLCHAIN_FILE="$root/cli/verify_page/toolchain.cmake" -DCREST_PREFIX="$prefix"
  cmake --build "$build/checker"
}

pack() {
  wasm-opt -O1 --enable-exception-handling --enable-simd --enable-bulk-memory --enable-sign-ext \
    --enable-nontrapping-float-to-int "$build/checker/crest-verify.wasm" -o "$build/crest-verify.wasm"
  version=$(sed -n 's/^project(Crest VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
  gzip -9 -n -c "$build/crest-verify.wasm" | base64 -w 0 >"$build/packed"
  awk -v version="$version" -v packed="$build/packed" '
    { sub(/@VERSION@/, version) }
    (at = index($0, "@WASM@")) {
      getline text <packed
      print substr($0, 1, at - 1) text substr($0, at + 6)
      next
    }
    { print }' cli/verify_page/crest-verify.js >"$build/crest-verify.js.part"
  mv "$build/crest-verify.js.part" "$build/crest-verify.js"
  rm "$build/packed"
}

try() {
  local cli=$root/${CREST_BUILD:-build}/cli folder=$build/certificates
  rm -rf "$folder"
  mkdir "$folder"
  PATH=$cli:$PATH tests/verify_page/certificates.sh "$folder"
  env -u NODE_OPTIONS node tests/verify_page/try.js "$build/crest-verify.js" "$cli/crest-verify" "$folder"
}

for program in clang++-14 wasm-ld-14 llvm-ar-14 emcc wasm-opt node cmake ninja dpkg-source; do
  command -v $program >/dev/null || { say "$program is missing; install the packages that $0 names"; exit 3; }
done
if [ -n "${CREST_SOURCES:-}" ]; then
  cp -u "$CREST_SOURCES"/gmp_* "$CREST_SOURCES"/mpfr4_* "$build/sources"
fi
ls "$build"/sources/gmp_*.dsc "$build"/sources/mpfr4_*.dsc >/dev/null 2>&1 ||
  quietly "Fetching the sources of GMP and MPFR" fetch_sources
[ -f "$prefix/lib/libgmp.a" ] || quietly "Building GMP" build_gmp
[ -f "$prefix/lib/libmpfr.a" ] || quietly "Building MPFR" build_mpfr
quietly "Building crest-verify" build_checker
quietly "Packing" pack
say "$build/crest-verify.js: $(stat -c %s "$build/crest-verify.js") bytes, $(gzip -9 -c "$build/crest-verify.js" | wc -c) gzipped;" \
  "the WebAssembly inside $(stat -c %s "$build/crest-verify.wasm"), $(gzip -9 -c "$build/crest-verify.wasm" | wc -c) gzipped"
[ "${1:-}" != --test ] || try
