#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What checking a scan's certificate costs beside the command that wrote it: processor time of whole
# commands on one thread, in turns, medians.
#   scan_check.sh FOLDER MESH [RUNS]     FOLDER has crest and crest-verify; MESH may be packed (.xz)
set -eu
export LC_ALL=C
programs=$(realpath "$1") mesh=$2 runs=${3:-5}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
case $mesh in
  *.xz) name=$(basename "$mesh" .xz); xz -dc "$mesh" >"$folder/$name" ;;
  *) name=$(basename "$mesh"); cp "$mesh" "$folder/$name" ;;
esac
cd "$folder"
# run FILE COMMAND...: its processor seconds to the file.
run() {
  to=$1
  shift
  /usr/bin/time -o time.txt -f '%U %S' "$@" >/dev/null
  awk '{ print $1 + $2 }' time.txt >>"$to"
}
median() { sort -n "$1" | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }
for _ in $(seq "$runs"); do
  run made.txt "$programs/crest" ridges "$name" --certificate scan.crest --threads 1 --quiet
  run checked.txt "$programs/crest-verify" scan.crest
done
echo "Command: experiments/002-ridges/scan_check.sh FOLDER $2 $runs"
echo
echo '| mesh | crest ridges --certificate, s | crest-verify, s | quotient | certificate, MB |'
echo '|---|---|---|---|---|'
echo "$(median made.txt) $(median checked.txt) $(wc -c <scan.crest)" |
  awk -v name="$name" '{ printf "| %s | %.2f | %.2f | %.3f | %.1f |\n", name, $1, $2, $2 / $1, $3 / 1e6 }'
