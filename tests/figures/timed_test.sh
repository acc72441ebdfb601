#!/usr/bin/env bash
# Every name of the charts has been timed, but for what does not settle.
source tests/common.sh
for chart in build/data/speed.csv build/data/speed-*.csv; do
  cut -d, -f3 "$chart" | tail -n +2 | sort -u | while read -r name; do
    grep -q "^$name," build/data/times.csv || fail "no time of $name"
  done
done
