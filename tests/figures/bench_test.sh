#!/usr/bin/env bash
# The benchmarks have the names that the report speaks of, and their output can be read.
. tests/common.sh

bench=build/thermoroll-bench
[ -x $bench ] || fail "no $bench: run make bench"
$bench --benchmark_list_tests >"$work/names"
for name in closed_form temperature_curve/points:400 \
  gauss_chebyshev{,_thrifty,_moments}/n:{25,200,800}/Pe:{100,4360}/H:0.0175 \
  gauss_chebyshev{,_thrifty,_moments}/n:200/Pe:100/H:1 \
  coupled/tol:{0.01,1e-06,1e-08}/Pe:{100/H:0.0175,4360/H:0.0175,100/H:1}; do
  grep -qxF "$name" "$work/names" || fail "no benchmark $name"
done
[ -z "$(sort "$work/names" | uniq -d)" ] || fail "named twice: $(sort "$work/names" | uniq -d)"

# Every name of the charts has been timed, but for what does not settle.
for chart in build/data/speed-*.csv; do
  cut -d, -f3 "$chart" | tail -n +2 | sort -u | while read -r name; do
    grep -q "^$name," build/data/times.csv || fail "no time of $name"
  done
done

$bench --benchmark_filter='^closed_form$|n:25/Pe:4360' --benchmark_min_time=0.001 \
  --benchmark_format=json >"$work/times.json" 2>/dev/null
build/thermoroll figure-data times --times "$work/times.json" --output "$work/times.csv"
[ "$(wc -l <"$work/times.csv")" = 5 ] || fail "$(cat "$work/times.csv")"
awk -F, 'NR > 1 && !($2 > 0 && $2 < 10) { exit 1 }' "$work/times.csv" || fail "$(cat "$work/times.csv")"
