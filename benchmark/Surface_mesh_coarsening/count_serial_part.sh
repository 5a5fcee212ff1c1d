#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Counts, with valgrind's callgrind, the instructions of a run on one thread, and which part of them is in loops that do not run on many
# threads, as a line of the CSV of compare_speed: instructions are the same in each run, so there is one value.
#
#   count_serial_part.sh COMPARE_SPEED default|clustering MODEL VERTICES
set -e
log=$(mktemp)
trap 'rm -f "$log" "$log.out"' EXIT
count() {
  valgrind --tool=callgrind --callgrind-out-file="$log.out" --toggle-collect="$1" "$2" --once "$3" "$4" "$5" > "$log" 2>&1
  sed -n 's/.*Collected : *\([0-9]*\).*/\1/p' "$log"
}
all=$(count '*run_once*' "$@")
concurrent=$(count '*run_concurrently*' "$@")
awk -v what="$2" -v model="$(basename "$3" .off)" -v vertices="$4" -v all="$all" -v concurrent="$concurrent" 'BEGIN {
  part = (all - concurrent) / all
  printf "\"%s, serial part\",%s,,%s,1,%g,%g,%g,%g,%g\n", what == "default" ? "default run" : "clustering", model, vertices, part, part, part, part, part
}'
