#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the man pages of programs and of their commands (crest-ridges.1, ...), made from their --help.
#   scripts/man.sh FOLDER VERSION PROGRAM...
set -eu
folder=$1
version=$2
shift 2
mkdir -p "$folder"

# page NAME HELP...: the help as it is, its first line (the summary) under NAME.
page() {
  name=$1
  shift
  "$@" --help | awk -v name="$name" -v version="$version" '
    function quoted(line) {
      gsub(/\\/, "\\\\", line); gsub(/-/, "\\-", line)
      return line ~ /^[.\x27]/ ? "\\&" line : line
    }
    NR == 1 {
      printf ".TH %s 1 \"\" \"Crest %s\" \"Crest\"\n.SH NAME\n%s \\- %s\n", toupper(name), version,
             quoted(name), quoted($0)
      next
    }
    /^Usage:/ { sub(/^Usage: */, ""); printf ".SH SYNOPSIS\n.nf\n%s\n.fi\n", quoted($0); next }
    /^[A-Z][A-Za-z ]*:$/ { sub(/:$/, ""); printf "%s.SH %s\n.nf\n", open ? ".fi\n" : "", toupper($0); open = 1; next }
    { if (!open && NF) { print ".SH DESCRIPTION\n.nf"; open = 1 } if (open || NF) print quoted($0) }
    END { if (open) print ".fi" }' >"$folder/$name.1"
}

for program in "$@"; do
  page "${program##*/}" "$program"
  for command in $("$program" --help |
    awk '/^Subcommands:/ { inside = 1; next } inside && /^  [a-z]/ { print $1 } inside && /^$/ { exit }'); do
    page "${program##*/}-$command" "$program" "$command"
  done
done
