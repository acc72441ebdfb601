#!/usr/bin/env bash
# The drawn figures have their curves, labels and nothing broken; and the check sees damage.
. tests/common.sh
. tests/figures/svg_check.sh

names=$(ls figures/*.gp | sed 's|.*/||; s|\.gp$||' | grep -vx style)
for name in $names; do
  [ -n "$(curves_of "$name")" ] || fail "what should $name show?"
  check_svg "$name" "build/figures/$name.svg" || fail "build/figures/$name.svg"
done

# expect_damage_seen NAME REASON SED-PROGRAM: the damaged picture is refused, for that reason.
expect_damage_seen() {
  sed -E "$3" "build/figures/$1.svg" >"$work/damaged.svg"
  ! cmp -s "build/figures/$1.svg" "$work/damaged.svg" || fail "$1, $2: nothing was damaged"
  ! check_svg "$1" "$work/damaged.svg" 2>"$work/log" || fail "$1: unseen: $2"
  grep -q "^$1: $2" "$work/log" || fail "$1: not seen as: $2: $(cat "$work/log")"
}
for name in $names; do
  first="/<title>$(curves_of "$name" | head -n 1 | sed 's/[*]/\\&/')<\/title>/"
  last="/<title>$(curves_of "$name" | tail -n 1 | sed 's/[*]/\\&/')<\/title>/"
  label=$(labels_of "$name" | head -n 1)
  expect_damage_seen "$name" "curves" "$last,/^\t<\/g>/d"
  expect_damage_seen "$name" "curves" "$first s/<title>.*<\/title>/<title\/>/"
  expect_damage_seen "$name" "an empty curve" \
    "$last,/^\t<\/g>/s/<(path|use|image|polygon) /<metadata /"
  expect_damage_seen "$name" "a coordinate that is none" "0,/ d='M[0-9.]+/s// d='Mnan/"
  expect_damage_seen "$name" "a coordinate that is none" "0,/ d='M[0-9.]+/s// d='Minf/"
  expect_damage_seen "$name" "label $label" "s/>${label/\*/\\*}</></"
  expect_damage_seen "$name" "something external" "0,/xlink:href='#gpPt5'/s//xlink:href='gpPt5'/"
  expect_damage_seen "$name" "something white" 's/color="black"/color="white"/'
  expect_damage_seen "$name" "not XML" '40,$d'
done
