#!/usr/bin/env bash
# The golden data and the README's picture are replaced by today's, and nothing else is; what is no
# longer made goes; what cannot be written whole is not written.
. tests/common.sh

mkdir -p "$work/project/build/data" "$work/project/build/figures" "$work/project/figures/golden" \
  "$work/project/tests/figures"
cp tests/figures/{update-golden,digests,readme-picture}.sh "$work/project/tests/figures/"
cd "$work/project"
printf '#!/bin/sh\nprintf "%%s\\n" changed added same values\n' >build/thermoroll # what the program lists
chmod +x build/thermoroll
touch figures/{temperature-load,cost,speed-hot,style}.gp
update() { (cd / && bash "$work/project/tests/figures/update-golden.sh"); }

picture=build/figures/temperature-load.svg
echo new | tee build/data/changed.csv build/data/added.csv >/dev/null
echo same | tee build/data/same.csv figures/golden/same.csv build/data/stale.csv build/data/times.csv >/dev/null
echo '{}' | tee build/data/values.json >figures/golden/values.json
echo old | tee figures/golden/changed.csv figures/golden/gone.csv figures/golden/tolerances.csv >/dev/null
printf '<rect fill="none"/>\n<path fill="none"/>\n' >"$picture"

listed=$(update | sort | tr '\n' ' ')
[ "$listed" = "figures/golden/added.csv figures/golden/changed.csv figures/golden/digests.txt figures/golden/temperature-load.svg " ] ||
  fail "listed: $listed"
[ "$(cat figures/golden/{added,changed,same,tolerances}.csv | tr '\n' ' ')" = "new new same old " ] ||
  fail "golden data: $(cat figures/golden/*.csv)"
[ ! -e figures/golden/gone.csv ] || fail "a table that is no longer made stayed"
[ "$(ls figures/golden | tr '\n' ' ')" = "added.csv changed.csv digests.txt same.csv temperature-load.svg tolerances.csv values.json " ] ||
  fail "golden data: $(ls figures/golden)"
expected="# $(gnuplot --version)"$'\n'"$(sha256sum <"$picture" | cut -d' ' -f1)  temperature-load.svg"
[ "$(cat figures/golden/digests.txt)" = "$expected" ] || fail "digests: $(cat figures/golden/digests.txt)"
[ "$(cat figures/golden/temperature-load.svg)" = $'<rect fill="white"/>\n<path fill="none"/>' ] ||
  fail "picture: $(cat figures/golden/temperature-load.svg)"
[ -z "$(update)" ] || fail "a second run changed something"

# Every file is renamed into its place: a reader of the old one keeps it whole, and no picture to
# take leaves the picture there was.
exec 3<figures/golden/changed.csv
echo newer >build/data/changed.csv
update >/dev/null
[ "$(cat <&3)" = new ] || fail "a golden table was written over in its place"
rm "$picture"
! update >/dev/null 2>&1 || fail "worked without a picture"
[ -s figures/golden/temperature-load.svg ] || fail "the picture was emptied"
[ -z "$(find figures -name '*.tmp')" ] || fail "left behind: $(find figures -name '*.tmp')"
