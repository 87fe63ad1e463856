#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What a user must trust who believes crest-verify: from the programs' sources, their #include
# "..." lines are followed; a source counts when its header is reached, or when its folder of
# certify/ is reached and no header has its name. Lines of code are those that are neither empty
# nor comments.
#   trusted_base.sh [CLAIM...]        files, lines of code, outside headers a claim (a folder of
#                                     certify/), and of all together
#   trusted_base.sh --table [CLAIM...]  the table alone
#   trusted_base.sh --update          writes the table between its marks in the documents
#   trusted_base.sh --check           fails if a document holds another table
set -eu
cd "$(dirname "$0")/.."

all_claims() { for f in certify/*/claim.cpp; do basename "$(dirname "$f")"; done; }

# The project's files reached from those given, and lines "outside HEADER".
reached() {
  awk '
    function exists(path,  line, found) {
      found = (getline line < path) > 0
      close(path)
      return found
    }
    function add(path) {
      if (!(path in seen)) { seen[path] = 1; queue[++last] = path }
    }
    # Sources that no header of their own name announces.
    function add_room(room,  command, source, header) {
      if (room in rooms) return
      rooms[room] = 1
      command = "ls " room "/*.cpp 2>/dev/null"
      while ((command | getline source) > 0) {
        header = source
        sub(/cpp$/, "hpp", header)
        if (!exists(header)) add(source)
      }
      close(command)
    }
    BEGIN {
      for (i = 1; i < ARGC; ++i) add(ARGV[i])
      for (at = 1; at <= last; ++at) {
        path = queue[at]
        if (path ~ /^certify\/[^\/]*\//) {
          room = path
          sub(/\/[^\/]*$/, "", room)
          add_room(room)
        }
        source = path
        if (sub(/hpp$/, "cpp", source) && exists(source)) add(source)
        while ((getline line < path) > 0)
          if (line ~ /^ *# *include *"/) {
            split(line, part, "\"")
            add(part[2])
          } else if (line ~ /^ *# *include *</) {
            split(line, part, /[<>]/)
            # The language has headers without a dot or folder, and c*; sys/ and these three are the
            # system.
            if (part[2] ~ /[.\/]/ && part[2] !~ /^(sys\/|(unistd|spawn|fcntl)\.h)/) print "outside " part[2]
          }
        close(path)
      }
      for (path in seen) print path
    }' "$@" | LC_ALL=C sort -u
}

# The files of crest-verify-<claim> for the claims given.
files_of() {
  seeds="cli/crest_verify.cpp certify/claim_table.cpp.in"
  for claim in "$@"; do seeds="$seeds certify/$claim/claim.cpp"; done
  # shellcheck disable=SC2086
  reached $seeds
}

# Lines of code of the files that standard input names, in sum.
code_lines() { xargs -r cat | grep -cvE '^[[:space:]]*(//.*)?$' || true; }

# The columns of the table.
# shellcheck disable=SC2046
kernel_folders=$(files_of $(all_claims) | sed -n 's|^\(kernel/[^/]*\)/.*|\1|p' | sort -u)

row() {
  program=$1
  shift
  list=$(files_of "$@")
  ours=$(echo "$list" | grep -v '^outside ')
  printf '| `%s` | %s | %s' "$program" "$(echo "$ours" | wc -l | tr -d ' ')" \
    "$(echo "$ours" | grep '^certify/' | code_lines)"
  for folder in $kernel_folders; do
    printf ' | %s' "$(echo "$ours" | { grep "^$folder/" || true; } | code_lines)"
  done
  printf ' | %s | %s |\n' "$(echo "$ours" | grep '^cli/' | code_lines)" \
    "$(echo "$ours" | code_lines)"
}

# Whose headers the files name.
libraries() {
  files_of "$@" | sed -n 's/^outside //p' |
    sed 's|^boost/.*|Boost.Multiprecision, GMP|; s|^CGAL/Interval_nt.h|CGAL (Interval_nt)|
      s|^CGAL/[Bb]ox_intersection_d.*|CGAL (boxes that meet)|
      s|^CLI/.*|CLI11|; s|^fmt/.*|fmt|; s|^mpfr.h|MPFR|; s|^openssl/.*|OpenSSL (SHA-256)|' |
    sort -u | paste -sd ';' - | sed 's/;/; /g'
}

# The second checker of claim 4, which the programs above have nothing of.
second() { ls certify/second/*.cpp certify/second/*.hpp; }

table() {
  printf '| program | files | lines of code: certify/'
  for folder in $kernel_folders; do printf ' | %s/' "$folder"; done
  printf ' | cli/ | sum |\n|---|---|---|'
  for folder in $kernel_folders; do printf -- '---|'; done
  printf -- '---|---|\n'
  for claim in "$@"; do row "crest-verify-$(echo "$claim" | tr _ -)" "$claim"; done
  if [ $# -gt 1 ]; then row crest-verify "$@"; fi
  printf '\nOutside: the compiler and its libraries; %s.\n' "$(libraries "$@")"
  if [ $# -gt 1 ] && [ -d certify/second ]; then
    printf '\nApart, for claim 4: `crest-recheck`, %s files, %s lines of code in certify/second/, none of those above.\n' \
      "$(second | wc -l | tr -d ' ')" "$(second | code_lines)"
    printf 'Outside it: the compiler and its libraries; Arb, FLINT, GMP, MPFR; OpenSSL (SHA-256).\n'
  fi
}

# A document with its tables made anew; a mark names the claims, none means all.
renewed() {
  while IFS= read -r line; do
    case $line in
      '<!-- trusted base'*'-->')
        skip=yes
        claims=${line#<!-- trusted base}
        claims=${claims%-->}
        echo "$line"
        # shellcheck disable=SC2086
        if [ -n "$(echo $claims)" ]; then table $claims; else printf '%s\n' "$all_claims_table"; fi
        ;;
      '<!-- end of trusted base -->') skip=no; echo "$line" ;;
      *) [ "${skip:-no}" = yes ] || printf '%s\n' "$line" ;;
    esac
  done <"$1"
}

documents() { grep -l '^<!-- trusted base' README.md docs/*.md certify/*.md certify/*/*.md; }

list() {
  echo "$1"
  shift
  files_of "$@" | while read -r path; do
    case $path in
      outside*) printf '        %s\n' "<${path#outside }>" ;;
      *) printf '%6s  %s\n' "$(echo "$path" | code_lines)" "$path" ;;
    esac
  done
  printf '%6s  lines of code in %s files\n\n' "$(files_of "$@" | grep -v '^outside' | code_lines)" \
    "$(files_of "$@" | grep -vc '^outside')"
}

option=list
case ${1:-} in
  --table | --update | --check) option=${1#--}; shift ;;
  -*) sed -n '3,12s/^# //p' "$0" >&2; exit 2 ;;
esac
# shellcheck disable=SC2046
[ $# -gt 0 ] || set -- $(all_claims)
case $option in
  table) table "$@" ;;
  list)
    for claim in "$@"; do list "crest-verify-$(echo "$claim" | tr _ -)" "$claim"; done
    if [ $# -gt 1 ]; then list crest-verify "$@"; fi
    ;;
  update | check)
    result=0
    all_claims_table=$(table "$@")
    for document in $(documents); do
      new=$(mktemp)
      renewed "$document" >"$new"
      if cmp -s "$document" "$new"; then
        echo "$document agrees"
      elif [ $option = update ]; then
        cat "$new" >"$document"
        echo "$document updated"
      else
        echo "$document: the trusted base is another; scripts/trusted_base.sh --update" >&2
        diff "$document" "$new" >&2 || true
        result=1
      fi
      rm -f "$new"
    done
    exit $result
    ;;
esac
