#!/usr/bin/env bash
# A figure is the same bytes whenever and wherever it is drawn, alone and from its data.
. tests/common.sh

export LC_ALL=C.UTF-8  # elsewhere gnuplot warns that its output is not in the encoding of the terminal
project=$PWD
names=$(ls figures/*.gp | sed 's|.*/||; s|\.gp$||' | grep -vx style)

# In a fresh copy, by the plain command, from its folder.
mkdir -p "$work/project/build" "$work/elsewhere"
cp -r figures "$work/project/"
cp -r build/data "$work/project/build/"
for name in $names; do
  (cd "$work/project" && gnuplot "figures/$name.gp") >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  [ ! -s "$work/log" ] || fail "$name: $(cat "$work/log")"
  cmp "$work/project/build/figures/$name.svg" "build/figures/$name.svg" || fail "$name differs"
done

# From any other folder, with data and output named.
for name in $names; do
  (cd "$work/elsewhere" &&
    gnuplot -e "data='$project/build/data/$name.csv'; output='$name.svg'" \
      "$project/figures/$name.gp") || fail "$name from elsewhere"
  cmp "$work/elsewhere/$name.svg" "build/figures/$name.svg" || fail "$name differs"
done

# It is drawn from the data: with every other row gone it is another picture.
for name in $names; do
  awk 'NR % 2' "build/data/$name.csv" >"$work/half.csv"
  ! gnuplot -e "data='$work/half.csv'; output='$work/half.svg'" "figures/$name.gp" 2>/dev/null ||
    ! cmp -s "$work/half.svg" "build/figures/$name.svg" || fail "$name does not depend on its data"
done

# Without data there is an error.
for name in $names; do
  ! gnuplot -e "data='$work/none.csv'; output='$work/none.svg'" "figures/$name.gp" 2>/dev/null ||
    fail "$name was drawn from nothing"
done
