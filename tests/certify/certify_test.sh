#!/usr/bin/env bash
# certify_test.sh PROGRAM: the first ball of the temperatures, computed anew, is the one that is kept.
source tests/common.sh
[ -x "$1" ] || exit 77

kept=figures/measured/certified-temperatures.csv
: >"$work/rows"
"$1" temperatures revision date >"$work/rows" 2>/dev/null &
for ((i = 0; i < 600; ++i)); do
  [ "$(wc -l <"$work/rows")" -lt 2 ] || break
  sleep 0.1
done
kill $! 2>/dev/null || true
diff <(sed -n 2p $kept | cut -d, -f1-5) <(sed -n 2p "$work/rows" | cut -d, -f1-5) ||
  fail "another ball is kept"
