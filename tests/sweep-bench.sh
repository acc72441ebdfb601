#!/usr/bin/env bash
# sweep-bench.sh PROGRAM ROWS...: how fast sweeps of so many random rows are, and how much memory
# they take; by the default method and by the closed form.
set -eu -o pipefail
program=$1
shift
rows() { # rows COUNT METHOD: log-uniform in Pe 1e-2...1e6, H 1e-4...3, f 0.05...1
  awk -v count="$1" -v method="$2" 'BEGIN {
    srand(1)
    print "friction,traction,peclet,heating,method,formulation"
    for (i = 0; i < count; ++i) {
      f = 0.05 * 20^rand()
      printf "%.6g,%.6g,%.6g,%.6g,%s,%s\n", f, f * (0.01 + 0.989 * rand()), 10^(8 * rand() - 2),
        1e-4 * 3e4^rand(), method, rand() < 0.5 ? "printed" : "corrected"
    }
  }'
}
# Rows with an error are no failure here: the status 4.
sweep() { "$program" sweep --verbose 2>&1 >/dev/null || [ $? -eq 4 ]; }
for count; do
  for method in "" closed-form; do
    said=$(rows "$count" "$method" | sweep) || { echo "sweep-bench: ${said:-no rows}" >&2; exit 1; }
    sed -n "s/^thermoroll: \(.* rows\/s, .*\)/${method:-default}: \1/p" <<<"$said" | grep . ||
      { echo "sweep-bench: nothing was measured: $said" >&2; exit 1; }
  done
done
