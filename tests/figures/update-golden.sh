#!/bin/bash
# Take today's data as the golden data (`make golden`), with what changed. The tolerances, in
# figures/golden/tolerances.csv, are written by hand.
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p figures/golden
for golden in figures/golden/*.csv; do
  name=$(basename "$golden")
  [ "$name" = tolerances.csv ] || [ ! -e "$golden" ] || [ -e "build/data/$name" ] || rm "$golden"
done
for table in build/data/*.csv; do
  golden=figures/golden/$(basename "$table")
  cmp -s "$table" "$golden" && continue
  cp "$table" "$golden"
  echo "$golden"
done
