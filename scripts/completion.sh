#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Prints bash's completion of crest and its checkers, made from their --help.
#   scripts/completion.sh PROGRAM...      build/cli/crest build/cli/crest-verify ...
set -eu

# The options that a help text lists, on one line.
options() {
  grep -oE '^ +(-[a-zA-Z],)?--[a-z][a-z0-9-]*' | grep -oE -- '--[a-z0-9-]+' | sort -u | tr '\n' ' '
}
# The names of its commands.
commands() {
  awk '/^Subcommands:/ { inside = 1; next } inside && /^  [a-z]/ { print $1 } inside && /^$/ { exit }'
}

echo "# Made by scripts/completion.sh from --help."
for program in "$@"; do
  name=${program##*/}
  function=_$(echo "$name" | tr - _)
  echo "$function() {"
  echo '  local word=${COMP_WORDS[COMP_CWORD]} words='
  echo '  case ${COMP_WORDS[1]} in'
  for command in $("$program" --help | commands); do
    echo "    $command) words='$("$program" "$command" --help | options)' ;;"
  done
  echo "    *) words='$("$program" --help | commands | tr '\n' ' ')$("$program" --help | options)' ;;"
  echo '  esac'
  echo '  COMPREPLY=($(compgen -W "$words" -- "$word") $(compgen -f -- "$word"))'
  echo '}'
  echo "complete -o filenames -F $function $name"
done
