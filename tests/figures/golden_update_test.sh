# The golden data are replaced by today's, and nothing else is; what is no longer made goes.
. tests/common.sh

mkdir -p "$work/project/build/data" "$work/project/figures/golden" "$work/project/tests/figures"
cp tests/figures/update-golden.sh "$work/project/tests/figures/"
cd "$work/project"
echo new | tee build/data/changed.csv build/data/added.csv >/dev/null
echo same | tee build/data/same.csv figures/golden/same.csv >/dev/null
echo old | tee figures/golden/changed.csv figures/golden/gone.csv figures/golden/tolerances.csv >/dev/null

listed=$(cd / && bash "$work/project/tests/figures/update-golden.sh" | sort | tr '\n' ' ')
[ "$listed" = "figures/golden/added.csv figures/golden/changed.csv " ] || fail "listed: $listed"
[ "$(cat figures/golden/{added,changed,same,tolerances}.csv | tr '\n' ' ')" = "new new same old " ] ||
  fail "golden data: $(cat figures/golden/*.csv)"
[ ! -e figures/golden/gone.csv ] || fail "a table that is no longer made stayed"
