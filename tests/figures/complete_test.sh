#!/usr/bin/env bash
# Every figure has its script, data, golden data, caption, description and use, and nothing is left
# over.
. tests/common.sh

# The tables that the program writes, those of times among them; values and speed are no tables.
listed=$(build/thermoroll figure-data --list; build/thermoroll figure-data --list --times build/data/times.json)
listed=$(grep -vx 'values\|speed' <<<"$listed")

# complete PROJECT: the first thing missing, on stderr, and a failure.
complete() (
  cd "$1" || exit
  missing() { echo "$*" >&2; exit 1; }

  # The figures of the chapters: NAME ID, one a line; the paragraph is ![caption](file){#id fig-alt=""}.
  figures=$(awk 'BEGIN { RS = "" } /^!\[/ {
    gsub(/\n/, " ")
    if (!match($0, /\]\(figures\/[a-z-]+\.svg\)/)) next
    caption = substr($0, 3, RSTART - 3); name = substr($0, RSTART + 10, RLENGTH - 15)
    rest = substr($0, RSTART + RLENGTH)
    if (length(caption) < 20) { print "!caption of " name; next }
    if (rest !~ /fig-alt="[^"]+"/) { print "!description of " name; next }
    if (!match(rest, /#fig:[a-z0-9-]+/)) { print "!identifier of " name; next }
    print name, substr(rest, RSTART + 1, RLENGTH - 1)
  }' paper/*.md)
  case $figures in *!*) missing "no ${figures#*!}" ;; esac
  [ -n "$figures" ] || missing "no figures"

  used=$(echo "$figures" | cut -d' ' -f1 | sort)
  [ -z "$(echo "$used" | uniq -d)" ] || missing "shown twice: $(echo "$used" | uniq -d)"
  scripts=$(ls figures/*.gp | sed 's|.*/||; s|\.gp$||' | grep -vx style | sort)
  [ "$used" = "$scripts" ] || missing "figures and scripts: $(echo "$used $scripts" | tr ' ' '\n' | sort | uniq -u)"
  while read -r name id; do
    [ -s "build/data/$name.csv" ] || missing "no data of $name"
    [ -s "figures/golden/$name.csv" ] || [ -s "figures/measured/study/$name.csv" ] || [ -s "figures/measured/$name.csv" ] || missing "no golden data of $name"
    [ -s "build/figures/$name.svg" ] || missing "$name is not drawn"
    grep -qE "@${id%-[b-z]}(-a)?([^a-z-]|$)" paper/*.md || missing "$id is not referred to"  # -a stands for its panels
  done <<<"$figures"

  # Data without a figure belong to a table, or are read by a figure beside its own.
  for name in $listed; do
    grep -qx "$name" <<<"$used" || grep -q "csv=\"$name.csv\"" paper/*.md ||
      grep -q "/$name.csv" figures/*.gp || missing "$name.csv is not used"
  done
)

complete . || fail "see above"

# Each thing taken away is missed.
mkdir "$work/project"
restore() {
  rm -rf "$work/project"
  mkdir -p "$work/project/build"
  cp -r paper figures "$work/project/"
  cp -r build/data build/figures "$work/project/build/"
}
expect_missed() {
  ! complete "$work/project" 2>"$work/log" || fail "unmissed: $1"
  grep -q "$1" "$work/log" || fail "not missed as '$1': $(cat "$work/log")"
  restore
}
restore
complete "$work/project" || fail "the copy"
chapter=$work/project/$(grep -l '(figures/slip.svg)' paper/*.md)
rm "$work/project/figures/slip.gp"; expect_missed "figures and scripts: slip"
cp "$work/project/figures/slip.gp" "$work/project/figures/other.gp"; expect_missed "figures and scripts: other"
sed -i 's|(figures/slip.svg)|(slip.svg)|' "$chapter"; expect_missed "figures and scripts: slip"
rm "$work/project/build/data/slip.csv"; expect_missed "no data of slip"
rm "$work/project/figures/golden/slip.csv"; expect_missed "no golden data of slip"
rm "$work/project/build/figures/slip.svg"; expect_missed "slip is not drawn"
listed+=" other"; expect_missed "other.csv is not used"; listed=${listed% other}
sed -i 's/fig-alt=/alt=/' "$chapter"; expect_missed "no description of"
sed -i 's/^!\[.*/![/' "$chapter"; expect_missed "no caption of\|figures and scripts"
sed -i 's/@fig:slip/@sec:slip/g' "$work/project"/paper/*.md; expect_missed "fig:slip is not referred to"
