#!/usr/bin/env bash
# run.sh TARGET SECONDS: looks for inputs that break the target, beginning with its corpus. What is
# learnt is kept in build/fuzz/corpus; an input that breaks it is a file in build/fuzz/found.
set -eu
target=$1
mkdir -p "build/fuzz/corpus/$target" build/fuzz/found
if "build/fuzz/tests/fuzz/fuzz-$target" "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target" \
  -max_total_time="$2" -timeout=120 -print_final_stats=1 -artifact_prefix="build/fuzz/found/$target-" \
  >"build/fuzz/$target.log" 2>&1; then
  echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz/$target.log") inputs, nothing found"
else
  tail -30 "build/fuzz/$target.log" >&2
  echo "$target: FOUND $(ls "build/fuzz/found/$target"-* 2>/dev/null | tail -1); the log is build/fuzz/$target.log" >&2
  exit 1
fi
