#!/usr/bin/env bash
# recipes_test.sh CASE PROGRAM: each recipe of the appendix, run as it stands there. The cases are the
# functions below that begin with a capital.
source tests/program/program.sh
mkdir "$scratch/bin"
ln -s "$program" "$scratch/bin/thermoroll"
export PATH="$scratch/bin:$PATH"
recipes="$project/src/program/recipes"
cp "$recipes/locomotive.toml" .

# cook RECIPE [COMMAND]: it answers and says nothing.
cook() {
  "${2:-sh}" "$recipes/$1" >out 2>err || fail "$1: $(cat err)"
  [ ! -s err ] || fail "$1 said: $(cat err)"
}

# column NAME FILE: its cells.
column() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i; next } { print $column }' "$2"
}

# The three lines of the README, in a copy, with the program in its place.
ReadmeCommands() {
  sed -n '/^    mkdir -p build\/try/,/gnuplot/p' "$project/README.md" >commands
  [ "$(wc -l <commands)" -eq 3 ] || fail "the README has other commands"
  mkdir -p copy/src/program copy/build
  cp -r "$recipes" copy/src/program/
  cp -r "$project/figures" copy/
  ln -s "$program" copy/build/thermoroll
  (cd copy && bash ../commands >../out 2>../err) || fail "$(cat err)"
  [ ! -s err ] && [ ! -s out ] || fail "said: $(cat out err)"
  grep -q '</svg>' copy/build/try/curves.svg || fail "no picture"
  # those that answer a question, each by itself
  grep -E '^    (build/thermoroll|printf)' "$project/README.md" >answers
  [ "$(wc -l <answers)" -ge 10 ] || fail "the README has lost its commands"
  (cd copy && bash -e ../answers >../out 2>../err) || fail "$(cat err)"
  [ "$(wc -l <copy/results.csv)" -eq 3 ] || fail "no table of scenes"
  grep -q 'creep,' copy/results.csv && [ -s copy/law.c ] && [ -s copy/profile.csv ] || fail "not all was written"
}

# A higher speed has less force at the end, and the rest of the curve is that of the options alone.
CurvesAtThreeSpeeds() {
  cook curves.sh
  [ "$(column speed curves.csv | uniq -c | tr -s ' ' | paste -sd,)" = " 101 20, 101 40, 101 80" ] || fail "$(head -3 curves.csv)"
  answers creep-curve --config locomotive.toml --speed 40 --from-ratio 0 --to-ratio 0.03
  paste -d, <(column creep_ratio out) <(column tangential_load out) <(column contact_temperature_celsius out) |
    paste -d, <(grep '^40,' curves.csv | cut -d, -f2-) - | awk -F, 'function near(a, b) { d = a - b; return d * d <= 1e-18 * b * b }
      !near($1, 100 * $4) || !near($2, 9e-6 * $5) || !near($3, $6) { exit 1 } END { exit NR != 101 }' || fail "another curve"
  local slow fast
  slow=$(column force_kn curves.csv | sed -n 101p) fast=$(column force_kn curves.csv | tail -1)
  awk -v slow="$slow" -v fast="$fast" 'BEGIN { exit !(0 < fast && fast < slow) }' || fail "$fast is not less than $slow"
}

# The picture has a curve, its name and its place for each speed of the table, and axes that reach as far.
OtherSpeedsAreDrawn() {
  sed "s/^speeds=.*/speeds='30 55 70 90'/; s/0\.03/0.012/" "$recipes/curves.sh" >others.sh
  sh others.sh
  gnuplot -e "data = 'curves.csv'; output = 'curves.svg'" "$project/figures/recipe-curves.gp"
  [ "$(grep -o '<title>[0-9]* m/s, [a-z]*' curves.svg | cut -d'>' -f2 | paste -sd+)" = \
    "30 m/s, force+55 m/s, force+70 m/s, force+90 m/s, force+30 m/s, temperature+55 m/s, temperature+70 m/s, temperature+90 m/s, temperature" ] ||
    fail "$(grep -o '<title>[^<]*' curves.svg)"
  [ "$(grep -oE '>[0-9]+ m/s</tspan>' curves.svg | sort | uniq -c | tr -s ' ' | paste -sd,)" = \
    " 2 >30 m/s</tspan>, 2 >55 m/s</tspan>, 2 >70 m/s</tspan>, 2 >90 m/s</tspan>" ] || fail "$(grep -o '>[^<>]* m/s<' curves.svg)"
  ! grep -qE '> (2|3|300)</tspan>' curves.svg || fail "the axes are those of other data"
}

# The surface, at its points and in its units, and cooler below.
TemperaturesInCelsius() {
  cook celsius.sh
  [ "$(column depth celsius.csv | sort -u | paste -sd' ')" = "0 0.01 0.03" ] || fail "$(cat celsius.csv)"
  [ "$(wc -l <celsius.csv)" -eq 274 ] || fail "$(wc -l <celsius.csv) lines"
  answers solve --config locomotive.toml --speed 40 --creep-ratio 0.01 --format csv
  local hottest
  hottest=$(column physical.max_temperature_celsius out)
  # The hottest point of the curve is at most the hottest of all, and misses it by the points' distance.
  column temperature_celsius celsius.csv | sort -g | tail -1 |
    awk -v hottest="$hottest" '{ exit !($1 <= hottest * (1 + 1e-6) && $1 > 0.99 * hottest) }' || fail "not $hottest"
}

MapBelowTheSurface() {
  cook map.sh
  [ "$(column depth_m map.csv | sort -u | wc -l) $(column x_m map.csv | sort -u | wc -l)" = "17 37" ] || fail "$(head -3 map.csv)"
  # Below any point of the surface it is cooler, as all heat comes from there.
  awk -F, 'NR > 1 { if ($3 == 0) top[$1] = $6; else if ($6 > top[$1] + 1e-6) exit 1 }' map.csv || fail "warmer below"
}

# A scene by hand is a row of the table; all are solved.
SweepOfManyScenes() {
  ROWS=50 cook sweep.sh
  [ "$(column status sweep.csv | sort | uniq -c | tr -s ' ')" = " 50 0" ] || fail "$(cat sweep.csv)"
  local row
  row=$(sed -n 8p scenes.csv)
  IFS=, read -r friction traction peclet heating <<<"$row"
  answers solve --friction "$friction" --traction "$traction" --peclet "$peclet" --heating "$heating" --tolerance 1e-3 --format csv
  [ "$(column creep out)" = "$(column creep sweep.csv | sed -n 7p)" ] || fail "another creep than of $row"
}

# The hottest of the rows, as the table of the program has it. Skipped where NumPy is missing.
SameSweepFromPython() {
  local python
  for python in python3 /usr/bin/python3; do # another Python than Debian's may stand before it
    ! "$python" -c 'import numpy' 2>err || break
  done
  [ ! -s err ] || { echo "skipped: $(cat err)"; exit 77; }
  ROWS=50 cook sweep.sh
  export PYTHONDONTWRITEBYTECODE=1 THERMOROLL_LIBRARY PYTHONPATH="$project/src/python"
  THERMOROLL_LIBRARY="$(dirname "$program")/libthermoroll_c.so"
  cook sweep.py "$python"
  awk -F, 'NR > 1 && $7 > most { most = $7; row = NR - 1 }
    END { printf "50 scenes, 0 failed\nrow %d is the hottest: T* = %.4g +- \n", row, most }' sweep.csv >expected
  sed 's/+- .*/+- /' out | cmp - expected || fail "$(cat out) is not $(cat expected)"
}

# Both languages have the answers of one sweep.
CoprocessAnswersRowByRow() {
  cook coprocess.sh
  cp out shell.csv
  [ ! -e rows ] && [ ! -e answers ] || fail "left its pipes"
  cook coprocess.py python3
  cmp out shell.csv || fail "$(cat out) is not $(cat shell.csv)"
  printf 'friction,traction\n0.6,0.1\n0.6,0.2\n0.6,0.3\n0.6,0.4\n' |
    "$program" sweep --peclet 100 --heating 1 --columns creep,max_temperature | cmp - out || fail "$(cat out)"
}

# The three commands of the text, of which the force given back is that of the creep.
CaseFileTakesOptions() {
  local base=(solve --config locomotive.toml --speed 40 --format csv) load
  answers "${base[@]}" --creep-ratio 0.005
  load=$(column physical.tangential_load out)
  answers "${base[@]}" --tangential-load "$load" --branch rising
  # Both are solved to a millionth, and the curve is flat here: a thousandth holds far from its maximum.
  awk -v creep="$(column physical.creep_ratio out)" 'BEGIN { d = creep / 0.005 - 1; exit !(d * d < 1e-6) }' || fail "$(cat out)"
  answers "${base[@]}" --creep-ratio -0.01
  [ "$(column direction out)" = braking ] || fail "$(cat out)"
}

# CONTACT's law at the hottest point, FREF + DFHEAT T / DTHEAT, and the strip has Hertz's pressure.
LawOfContact() {
  answers solve --config "$recipes/contact-law.toml" --format csv
  local hottest pressure least
  hottest=$(column physical.contact_temperature_celsius out) pressure=$(column physical.hertz_pressure out)
  least=$(column friction_min out)
  awk -v t="$hottest" -v p="$pressure" -v f="$least" 'function near(a, b, by) { return (a - b) ^ 2 <= by * by }
    BEGIN { exit !(100 < t && t < 200 && near(f, 0.3 - 0.18 * t / 400, 1e-6) && near(p, 770.41e6, 1e5)) }' || fail "$(cat out)"
  [ "$(column full_slip out)" = true ] || fail "$(cat out)"
}

"$1"
