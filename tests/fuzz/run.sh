#!/usr/bin/env bash
# run.sh MINUTES JOBS TARGET...: looks for inputs that break the targets, beginning with their
# corpus, so many at a time, for so many minutes in all. What is learnt is kept in
# build/fuzz/corpus; an input that breaks a target is a file in build/fuzz/found. The last line is
# the total.
set -u
minutes=$1 jobs=$2
shift 2
[ "$jobs" -le $# ] || jobs=$#
seconds=$((minutes * 60 * jobs / $#))

# fuzz SECONDS TARGET
fuzz() {
  local target=$2 log=build/fuzz/$2.log
  mkdir -p "build/fuzz/corpus/$target" build/fuzz/found
  if "build/fuzz/tests/fuzz/fuzz-$target" "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target" \
    -max_total_time="$1" -timeout=120 -print_final_stats=1 \
    -artifact_prefix="build/fuzz/found/$target-" >"$log" 2>&1; then
    echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs, nothing found"
  else
    tail -30 "$log" >&2
    echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs, FOUND" \
      "$(find build/fuzz/found -name "$target-*" | tail -1); the log is $log"
    return 1
  fi
}
export -f fuzz

printf '%s\n' "$@" | xargs -P "$jobs" -I {} bash -c "fuzz $seconds {}" | tee build/fuzz/totals
awk -v minutes="$minutes" '{ inputs += $2 } /FOUND/ { found++ }
  END { printf "%d inputs by %d ways in, in %s min: %d found\n", inputs, NR, minutes, found }' build/fuzz/totals
! grep -q FOUND build/fuzz/totals
