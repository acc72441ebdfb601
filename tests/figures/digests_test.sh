#!/usr/bin/env bash
# The last net below the pictures: drawn from the golden data, or those of the study, each is the same
# bytes as when `make golden` was run. Another gnuplot may draw otherwise; then nothing can be said,
# which is no failure.
. tests/common.sh
. tests/figures/digests.sh

export LC_ALL=C.UTF-8
golden=figures/golden/digests.txt
[ -s $golden ] || fail "no $golden: run make golden"

# judge FILE: whether the digests in FILE are those of the pictures drawn now; 77 for another gnuplot.
judge() {
  local drawer
  drawer=$(sed -n '1s/^# //p' "$1")
  [ "$drawer" = "$(gnuplot --version)" ] || { echo "the digests are of $drawer"; return 77; }
  digests "$work" >"$work/digests.txt"
  diff "$1" "$work/digests.txt"
}

for name in $(same_whenever_drawn); do
  data=figures/golden/$name.csv
  [ -s "$data" ] || data=figures/measured/study/$name.csv
  [ -s "$data" ] || data=figures/measured/$name.csv
  gnuplot -e "data='$data'; output='$work/$name.svg'" "figures/$name.gp"
done

# Another digest, another number of figures and another gnuplot are told.
sed 's/^0/1/; t; s/^[1-9a-f]/0/' $golden >"$work/other.txt"
sed '$d' $golden >"$work/short.txt"
sed '1s/.*/# gnuplot 4.0 patchlevel 0/' $golden >"$work/old.txt"
judge "$work/old.txt" >/dev/null && fail "another gnuplot was judged" || [ $? = 77 ] || fail "another gnuplot is a failure"

status=0
judge $golden || status=$?
[ $status != 77 ] || exit 77
[ $status = 0 ] || fail "these figures are drawn otherwise: look at them, and run make golden if they are right"
for damaged in other short; do
  ! judge "$work/$damaged.txt" >/dev/null || fail "$damaged digests were accepted"
done
