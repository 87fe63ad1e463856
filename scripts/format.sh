#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Formats all sources (.clang-format) and takes the braces off single statements; --check only
# reports and fails where something would change.
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Two passes: clang-format 14 breaks lambdas oddly in the pass that removes braces.
cp .clang-format "$work/braces"
echo "RemoveBracesLLVM: true" >>"$work/braces"
sources=$(git ls-files -co --exclude-standard '*.cpp' '*.hpp')
if [ "${1:-}" != "--check" ]; then
  clang-format -i "--style=file:$work/braces" $sources
  clang-format -i $sources
  exit
fi
mkdir "$work/tree"
cp --parents $sources "$work/tree"
cp .clang-format "$work/tree"
(cd "$work/tree" && clang-format -i "--style=file:$work/braces" $sources && clang-format -i $sources)
result=0
for source in $sources; do
  diff -u "$source" "$work/tree/$source" || result=1
done
exit $result
