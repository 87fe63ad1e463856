# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the scripts: say what is being done, and how long it took.

# step TEXT COMMAND...: runs the command; its output goes to the log, which is shown if it fails.
steps_log=$(mktemp)
trap 'rm -f "$steps_log"' EXIT
step() {
  step_text=$1
  shift
  printf '%-44s' "$step_text"
  step_start=$(date +%s.%N)
  if "$@" >"$steps_log" 2>&1; then
    printf '%8.1f s\n' "$(seconds_since "$step_start")"
  else
    step_code=$?
    printf ' FAILED (exit code %s): %s\n' "$step_code" "$*"
    tail -n 60 "$steps_log"
    exit "$step_code"
  fi
}

seconds_since() {
  awk -v from="$1" -v to="$(date +%s.%N)" 'BEGIN { printf "%.1f", to - from }'
}
