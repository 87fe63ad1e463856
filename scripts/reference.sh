#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the reference of the public headers (cmake/public_headers.cmake) in build/reference/html with
# Doxygen (Debian: doxygen). Every warning is an error.
set -eu
cd "$(dirname "$0")/.."

to=${1:-build/reference}
mkdir -p "$to"
cmake -D SOURCE="$PWD" -D TO="$to/headers" -D IO=ON -P cmake/public_headers.cmake
# Comments are plain text with names in `code`: what follows < or # in them is neither a tag nor a link.
cat >"$to/Doxyfile" <<EOF
PROJECT_NAME = Crest
PROJECT_BRIEF = "Certified extraction of surface topology"
INPUT = $to/headers $to/main.md
USE_MDFILE_AS_MAINPAGE = $to/main.md
RECURSIVE = YES
STRIP_FROM_PATH = $to/headers
OUTPUT_DIRECTORY = $to
GENERATE_LATEX = NO
EXTRACT_ALL = YES
JAVADOC_AUTOBRIEF = YES
AUTOLINK_SUPPORT = NO
BUILTIN_STL_SUPPORT = YES
HAVE_DOT = NO
CLASS_GRAPH = NO
QUIET = YES
WARN_AS_ERROR = FAIL_ON_WARNINGS
EOF
cat >"$to/main.md" <<EOF
# Crest

The public headers, as they are installed under \`crest/\`. Of each system \`algorithms/NAME/NAME.hpp\` has the calls
and \`certificate.hpp\` the certificate, which \`certify/verify.hpp\` checks; certify/SPEC.md says what a certificate
states. Comments of a function say: what it does, shapes, what it requires, guarantees and throws, its cost.
Complete programs are in examples/.
EOF
doxygen "$to/Doxyfile"
echo "$to/html/index.html"
