#!/usr/bin/env bash
# Take today's data as the golden data, and today's picture for the README (`make golden`); what
# changed is listed. The tolerances, in figures/golden/tolerances.csv, are written by hand.
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p figures/golden

# replace FILE: by what stands on stdin, if that is something else; never by half of it.
replace() {
  cat >"$1.tmp"
  if cmp -s "$1.tmp" "$1"; then
    rm "$1.tmp"
  else
    mv "$1.tmp" "$1"
    echo "$1"
  fi
}

for golden in figures/golden/*.csv; do
  name=$(basename "$golden")
  [ "$name" = tolerances.csv ] || [ ! -e "$golden" ] || [ -e "build/data/$name" ] || rm "$golden"
done
for table in build/data/*.csv; do
  case $(basename "$table") in times.csv | bars.csv | shares.csv | contact.csv) continue ;; esac # times are never golden
  replace "figures/golden/$(basename "$table")" <"$table"
done
bash tests/figures/readme-picture.sh >build/readme-picture.svg
replace figures/golden/temperature-load.svg <build/readme-picture.svg
