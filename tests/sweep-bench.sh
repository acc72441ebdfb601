#!/usr/bin/env bash
# sweep-bench.sh PROGRAM TABLE ROWS...: how fast sweeps of so many random rows are, and how much memory
# they take; by the default method, to 1e-6 and to 1e-3, and by the closed form. Printed as it comes;
# TABLE is written at the end.
set -eu -o pipefail
program=$1
table=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
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
TIMEFORMAT='%U %S'
sweep() { # sweep OPTION...
  { time "$program" sweep --verbose "$@" >/dev/null 2>"$work/said" || [ $? -eq 4 ]; } 2>"$work/seconds"
}
machine="$(nproc) × $(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed q | tr -d ,)"
header='method,tolerance,rows,rows/s,ms/row,MB,machine,date'
for count; do
  for run in ,1e-6 ,1e-3 closed-form,; do
    method=${run%,*} tolerance=${run#*,}
    rows "$count" "$method" | sweep ${tolerance:+--tolerance $tolerance} || { echo "sweep-bench: no rows: $(cat "$work/said")" >&2; exit 1; }
    read -r user system <"$work/seconds"
    awk -v name="${method:-default},$tolerance" -v seconds="$(awk "BEGIN { print $user + $system }")" \
      -v machine="$machine" -v date="$(date -u +%F)" '
      match($0, /[0-9]+ rows\/s, [0-9]+ MB$/) {
        split(substr($0, RSTART), rate, " ")
        printf "%s,%d,%d,%.3g,%d,%s,%s\n", name, $2, rate[1], 1000 * seconds / $2, rate[3], machine, date
        measured = 1
      }
      END { exit !measured }' "$work/said" >"$work/row" ||
      { echo "sweep-bench: nothing was measured: $(cat "$work/said")" >&2; exit 1; }
    [ -s "$work/table" ] || echo "$header" | tee "$work/table"
    tee -a "$work/table" <"$work/row"
  done
done
mv "$work/table" "$table"
