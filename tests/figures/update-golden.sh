#!/usr/bin/env bash
# Take today's data as the golden data, with a digest of each figure drawn from them, and today's
# picture for the README (`make golden`); what changed is listed. The tolerances, in
# figures/golden/tolerances.csv, are written by hand.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/figures/digests.sh
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

# What the program lists, and no table that an earlier one has left in build/data.
names=$(build/thermoroll figure-data --list; find figures -name 'recipe-*.gp' -o -name evaluations.gp | sed 's|.*/||; s|\.gp$||' | sort)
for golden in figures/golden/*.csv; do
  name=$(basename "$golden" .csv)
  [ "$name" = tolerances ] || [ ! -e "$golden" ] || grep -qx "$name" <<<"$names" || rm "$golden"
done
for name in $names; do
  kind=csv
  [ "$name" != values ] || kind=json
  replace "figures/golden/$name.$kind" <"build/data/$name.$kind"
done
digests build/figures >build/digests.txt
replace figures/golden/digests.txt <build/digests.txt
bash tests/figures/readme-picture.sh >build/readme-picture.svg
replace figures/golden/temperature-load.svg <build/readme-picture.svg
