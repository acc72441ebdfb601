#!/usr/bin/env bash
# sweep_test.sh CASE PROGRAM: what users of sweeps rely on. The cases are the functions below that
# begin with a capital.
source tests/program/program.sh

# The chapter's table and as many copies of its rows as asked for.
write_scenes() { # write_scenes [COPIES]
  code csv D-sweeps-and-reliability.md >chapter.csv
  grep -q '^friction,' chapter.csv || fail "the chapter has no table"
  { head -1 chapter.csv; for _ in $(seq "${1:-1}"); do tail -n +2 chapter.csv; done; } >scenes.csv
}

# sweeps STATUS ARGUMENT...: solves scenes.csv to results.csv, with this status; all rows are whole.
sweeps() {
  local expected=$1
  shift
  status=0
  "$program" sweep "$@" <scenes.csv >results.csv 2>err || status=$?
  [ $status -eq "$expected" ] || fail "status $status: $(cat err)"
  whole_rows <results.csv
}

# Every line ends, and has as many cells as the header; commas between quotes do not count.
whole_rows() {
  sed 's/"\([^"]\|""\)*"/quoted/g' | awk -F, 'NR == 1 { cells = NF } NF != cells { wrong = 1 }
    END { exit wrong || NR == 0 }' || fail "rows are not whole"
  [ -z "$(tail -c 1 results.csv)" ] || fail "the last line does not end"
}

# cell COLUMN ROW [FILE]: the first row is 1; the columns asked for stand before any quotes.
cell() {
  awk -F, -v name="$1" -v row="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i }
    NR == row + 1 { print $column }' "${3:-results.csv}"
}

error_of() { LC_ALL=C sed -n "$(($1 + 1))s/.*,\([0-9]\),\(.*\)/\1 \2/p" results.csv | tr -d '"'; } # error_of ROW

# The words of roller and direction are columns as all options; a column for the roller brings what
# two bodies have added, in every row.
RollersAndDirections() {
  cat >scenes.csv <<'END'
friction,traction,stick-slip-border,peclet,heating,roller,direction,heating-2,conductivity-ratio
0.6,0.5,,100,1,,,,
0.6,-0.5,,100,1,identical,,,
0.6,,0.1,100,1,conducting,braking,2,0.3
0.6,0.3,,100,1,conducting,braking,2,0.3
0.6,0.3,,100,1,conducting,,2,
END
  sweeps 4
  [ "$(cell roller 1) $(cell direction 1) $(cell heat_partition 1)" = "insulated driving 1.0" ] ||
    fail "$(cat results.csv)"
  [ "$(cell roller 2) $(cell direction 2) $(cell heating-2 2) $(cell conductivity-ratio 2)" = \
    "identical braking 1.0 1.0" ] || fail "$(cat results.csv)"
  [ "$(cell roller 3) $(cell direction 3) $(cell heating-2 3) $(cell full_slip 3)" = \
    "conducting braking 2 false" ] || fail "$(cat results.csv)"
  grep -q '^0.6,-0.4' <<<"$(sed -n 4p results.csv)" || fail "no traction of its sign: $(cat results.csv)"
  [ "$(error_of 4)" = "2 --direction braking contradicts --traction 0.3: it is positive for driving and negative for braking" ] ||
    fail "$(error_of 4)"
  [ "$(error_of 5)" = "2 --roller conducting lacks --conductivity-ratio" ] || fail "$(error_of 5)"
  cut -d, -f1-5 scenes.csv | sed -n 1,3p >some.csv
  mv some.csv scenes.csv
  sweeps 0
  ! head -1 results.csv | tr ',' '\n' | grep -qx 'roller\|heat_1\|full_slip' || fail "$(head -1 results.csv)"
  [ "$(cell traction 2) $(cell status 2)" = "-0.5 0" ] || fail "$(cat results.csv)"
}

# How many rows have notes is told, also where their column is not asked for.
RowsWithNotesAreCounted() {
  printf 'creep-ratio\n0.002\n2\n5\n' >scenes.csv
  local wheel=(--friction 0.35 --load 1.2e7 --speed 40 --half-width 7.8e-3 --shear-modulus 8.1e10 --poisson 0.3
    --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50 --roller identical)
  sweeps 0 "${wheel[@]}" --columns creep-ratio,status
  [ "$(cat err)" = "thermoroll: note: 2 of 3 rows have notes: see their column notes" ] || fail "$(cat err)"
  cp results.csv whole
  head -2 whole >part
  "$program" sweep "${wheel[@]}" --columns creep-ratio,status --resume part <scenes.csv 2>err || fail "$(cat err)"
  [ "$(cat err)" = "thermoroll: note: 2 of 2 more rows have notes: see their column notes" ] || fail "$(cat err)"
  cmp whole part || fail "$(cat part)"
  sed -i '3,$d' scenes.csv
  sweeps 0 "${wheel[@]}" --columns creep-ratio,status
  [ ! -s err ] || fail "$(cat err)"
}

# Laws and branches are columns as all options; a column for the law brings what it has added, and
# one for the bulk temperature the absolute temperature.
LawsOfFriction() {
  cat >scenes.csv <<'END'
friction,traction,creep,peclet,heating,friction-law,friction-temperature,friction-floor,branch
0.6,0.39,,100,0.0175,linear,0.02,,
0.6,-0.39,,100,0.0175,linear,0.02,,falling
0.6,,0.5,100,0.0175,exponential,0.02,0.3,
0.6,,0.5,100,0.0175,,,,
0.6,0,,100,0.0175,,,,
0.6,0.5,,100,0.0175,linear,0.02,,
0.6,0.3,,100,0.0175,,0.02,,
END
  sweeps 4
  [ "$(cell friction-law 1) $(cell branch 1) $(cell full_slip 1)" = "linear rising false" ] || fail "$(cat results.csv)"
  [ "$(cell branch 2) $(cell friction-floor 2)" = "falling 0.0" ] || fail "$(cat results.csv)"
  grep -q '^-0.397' <<<"$(cell traction_limit 2)" || fail "$(cat results.csv)"
  [ "$(cell full_slip 3) $(cell traction_limit 3)" = "true " ] || fail "$(cat results.csv)"
  [ "$(cell friction-law 4) $(cell traction 4) $(cell friction_min 4)" = "constant 0.6 " ] || fail "$(cat results.csv)"
  [ "$(cell creep 5) $(cell stick_slip_border 5) $(cell status 5)" = "0.0 1.0 0" ] || fail "$(cat results.csv)"
  grep -q '^2 traction = 0.5 is not allowed: it must be at most 0.3977' <<<"$(error_of 6)" || fail "$(error_of 6)"
  grep -q '^2 constant friction has none of these: --friction-temperature' <<<"$(error_of 7)" || fail "$(error_of 7)"
  cat >scenes.csv <<'END'
friction,traction,load,speed,half-width,shear-modulus,poisson,expansion,diffusivity,conductivity,bulk-temperature
0.6,0.5,1.2e7,22.2,5.5e-3,8.1e10,0.3,1.1e-5,1.4e-5,50,20
0.6,0.5,1.2e7,22.2,5.5e-3,8.1e10,0.3,1.1e-5,1.4e-5,50,
END
  sweeps 0
  awk -v a="$(cell physical.contact_temperature_celsius 1)" -v b="$(cell physical.max_temperature_celsius 1)" \
    'BEGIN { d = a - b - 20; exit !(d * d < 1e-18) }' || fail "$(cat results.csv)"
  [ -z "$(cell physical.contact_temperature_celsius 2)" ] || fail "$(cat results.csv)"
}

# same_cells ROW [BUT]: this row of the sweep has the cells of the answer in out, but for columns that match BUT;
# sets `same` to their number. The words between quotes count as equal. What was given stays as it was written,
# so that 1 may stand for 1.0.
same_cells() {
  sed 's/"[^"]*"/quoted/g' out >answer
  sed 's/"[^"]*"/quoted/g' results.csv >rows
  same=$(awk -F, -v row="$1" -v but="${2:-none}" '
    function differ(a, b) { return a "" != b "" && !(a ~ number && b ~ number && a + 0 == b + 0) }
    BEGIN { number = "^-?[0-9.]+(e[-+]?[0-9]+)?$" }
    FILENAME == "answer" && FNR == 1 { columns = split($0, name) }
    FILENAME == "answer" { split($0, cell) }
    FILENAME == "rows" && FNR == 1 { for (i = 1; i <= NF; ++i) place[$i] = i }
    FILENAME == "rows" && FNR == row + 1 {
      for (i = 1; i <= columns && !wrong; ++i) {
        if (name[i] ~ but) continue
        if (!(name[i] in place)) wrong = "no column " name[i]
        else if (differ($place[name[i]], cell[i])) wrong = name[i] " is " $place[name[i]] ", not " cell[i]
        ++count
      }
    }
    END { if (wrong) print wrong >"/dev/stderr"; else print count + 0; exit wrong != "" }' answer rows) ||
    fail "row $1 has other cells"
}

AnswersAsSolveDoes() {
  write_scenes
  sweeps 4
  one_line "1 of 4 rows have an error"
  [ "$(cut -d, -f1-5 results.csv)" = "$(cat scenes.csv)" ] || fail "other rows: $(cat results.csv)"
  local row column same
  for row in 1 2 4; do
    [ "$(error_of $row)" = "0 " ] || fail "row $row: $(error_of $row)"
    local arguments=()
    for column in friction traction peclet heating tolerance; do
      [ -z "$(cell $column $row)" ] || arguments+=("--$column" "$(cell $column $row)")
    done
    answers solve "${arguments[@]}" --format csv
    same_cells "$row"
    [ "$same" -ge 30 ] || fail "only $same cells of row $row were compared"
  done
  [ "$(error_of 3)" = "2 traction = 0.7 is not allowed: it must be between -0.6 and 0.6, the friction" ] ||
    fail "row 3: $(error_of 3)"
}

# Of two bodies, in SI units, with a law of friction and a bulk difference, a sweep has every column that
# solve has, with the same cell.
HasEveryColumnOfSolve() { # slow
  code toml B-command-line.md | grep -v traction >wheel.toml
  local base=(--config wheel.toml) same count=0
  same_columns() { # same_columns OPTION...: of solve, and of a sweep of one row
    local but=none
    [[ "$*" != *config* ]] || but='^friction.*_temperature$' # which stays in K, or out
    printf 'traction\n0.3\n' >scenes.csv
    answers solve --traction 0.3 "$@" --format csv
    sweeps 0 "$@"
    same_cells 1 $but
    count=$((count + same))
  }
  same_columns "${base[@]}"
  same_columns "${base[@]}" --roller identical --bulk-temperature 20
  same_columns "${base[@]}" --roller conducting --conductivity-2 20 --expansion-2 1e-5 --friction-law linear --friction-temperature 3000
  same_columns "${base[@]}" --roller identical --bulk-temperature 20 --bulk-temperature-2 21
  same_columns --friction 0.6 --peclet 100 --heating 1 --roller conducting --conductivity-ratio 2 --heating-2 1 --peclet-2 30
  same_columns --friction 0.6 --peclet 100 --heating 1 --friction-law rational --friction-temperature 0.1
  [ $count -ge 250 ] || fail "only $count cells were compared"
}

# A creep and a traction that belong together: either gives the other, in its own column.
GivenCellsStayAndEmptyOnesAreFilled() {
  printf '%s\n' peclet,creep,traction,friction,method 100,,0.50,0.6,closed-form 100,0.2,,0.60,closed-form >scenes.csv
  sweeps 0
  [ "$(cut -d, -f1-5 results.csv | sed -n 1p)" = "$(sed -n 1p scenes.csv)" ] || fail "$(cat results.csv)"
  grep -q '^100,0.2[0-9]*,0.50,0.6,closed-form,' results.csv || fail "$(cat results.csv)"
  grep -q '^100,0.2,0.4[0-9]*,0.60,closed-form,' results.csv || fail "$(cat results.csv)"
  [ "$(head -1 results.csv | tr , '\n' | sort | uniq -d)" = "" ] || fail "a column twice"
}

# A solution that is no contact is a row with its numbers, what is wrong with them, and the status 5.
NoContactIsARow() {
  printf '%s\n' friction,traction,peclet,heating,formulation,method 0.6,0.5,1000,30,printed,gauss-chebyshev \
    0.6,0.5,1000,0,printed,gauss-chebyshev >scenes.csv
  sweeps 4
  grep -qF ',true,false,separation -0.999512..1; backward slip -0.999844..1,' results.csv || fail "$(cat results.csv)"
  grep -q ',5,.*is no contact: separation at s = -0.9995.* to 1"\{0,1\}$' results.csv || fail "$(cat results.csv)"
  tail -1 results.csv | grep -q ',true,true,,.*,0,$' || fail "$(tail -1 results.csv)"
}

BadRowsGiveTheirError() {
  printf '%s\n' friction,traction,peclet,heating,method,nodes,creep >scenes.csv
  : >expected
  bad() { # bad ROW STATUS WORDS
    printf '%b\n' "$1" >>scenes.csv
    printf '%s\n' "$2 $3" >>expected
  }
  bad '0.6,0.5,100,0,closed-form,,' 0 ""
  bad '0.6,0.5,100,0,closed-form,' 2 "the row has 6 cells and the header 7"
  bad '0.6,0.5,100,0,closed-form,,,' 2 "the row has 8 cells and the header 7"
  bad ',,,,,,' 2 "--friction is required"
  bad '0.6,,100,0,,,' 2 "exactly one of --traction, --creep and --stick-slip-border is needed"
  bad '0.6,0.5,100,0,,,0.1' 2 "exactly one of --traction, --creep and --stick-slip-border is needed"
  bad '0.6,0.5,nan,0,,,' 2 "peclet = nan is not allowed: it must be a finite number"
  bad '0.6,0.5,"1e",0,,,' 2 "peclet = 1e is not allowed: it must be a finite number"
  bad '0.6,0.5,"100,0,,,' 2 "a quote is not closed on its line"
  bad '0.6,0.5,"100"0,0,,,' 2 "a quote is followed by text: two quotes stand for one"
  bad '0.6,0.5,100\00001,0,,,' 2 "the row holds a null character"
  bad '0.6,0.5,1\a0,0,,,' 2 "peclet = 1 0 is not allowed: it must be a finite number"
  bad '0.6,0.5,\xff,0,,,' 2 'peclet = \xff is not allowed: it must be a finite number'
  bad '0.6,0.5,--help,0,,,' 2 "peclet = --help is not allowed: it must be a finite number"
  bad '0.6,0.5,100,-1,,,' 2 "heating = -1 is not allowed: it must be zero or positive"
  bad '0.6,0.5,100,0,best,,' 2 "method = best is not allowed: it must be auto or closed-form or first-order or coupled or gauss-chebyshev"
  bad '0.6,0.5,100,0,,2.5,' 2 "nodes = 2.5 is not allowed: it must be a whole number"
  bad '0.6,,100,0,closed-form,,0.5' 2 "creep = 0.5 is not allowed: it must be below 2 f / pi"
  bad '0.6,0.5,100,1e6,,,' 1 "coupled: no solution found near the border"
  bad '0.6,0.5,100,4,gauss-chebyshev,20,' 3 "the iteration did not converge; what is written is its last iterate"
  bad '0.6,0.5,1e200,1e200,gauss-chebyshev,20,' 3 "no finite result"
  sweeps 4
  local row rows
  rows=$(wc -l <expected)
  one_line "$((rows - 1)) of $rows rows have an error: see their columns status and error"
  [ "$(wc -l <results.csv)" -eq $((rows + 1)) ] || fail "$(wc -l <results.csv) rows"
  for row in $(seq "$rows"); do
    local said want
    said=$(error_of "$row") want=$(sed -n "${row}p" expected)
    [ "${said#"$want"}" != "$said" ] || [ "$said" = "$want" ] || fail "row $row: $said; expected: $want"
  done
  grep -q '^0.6,0.5,100,4,gauss-chebyshev,20,0.[0-9]*,.*,false,' results.csv || fail "no last iterate"
}

BadHeaders() {
  bad() { # bad WORDS HEADER
    status=0
    printf '%b\n0.6,0.5,100\n' "$2" | "$program" sweep >out 2>err || status=$?
    [ $status -eq 2 ] && [ ! -s out ] || fail "$2: status $status: $(cat out err)"
    one_line "$1"
  }
  bad "the header names what is no option of solve: pecle (did you mean peclet?); --keep lets a label pass" 'friction,traction,pecle'
  bad "the header names what is no option of solve: modle (did you mean model?)" 'friction,traction,peclet,modle'
  bad "the header names what is no option of solve: friction;traction;peclet" 'friction;traction;peclet'
  bad "the header names what is no option of solve: 0.6" '0.6,0.5,100'
  bad "(are its fields separated by ';'? only commas separate them)" 'friction;traction;peclet'
  bad "(are its fields separated by a tab? only commas separate them)" 'friction\ttraction\tpeclet'
  bad "a quote is not closed on its line" '"friction,traction,peclet'
  bad "the header names stick_slip_border twice" 'friction,peclet,stick-slip-border,stick_slip_border'
  bad "the header lacks traction, creep, stick-slip-border or, with data in SI units, creep-ratio or tangential-load" 'friction,peclet'
  bad "the header lacks peclet (or data in SI units)" 'friction,traction'
  bad "the header lacks, of data in SI units: load shear-modulus poisson" 'friction,traction,speed'
  bad "the header lacks half-width or radius" \
    'friction,traction,load,speed,shear-modulus,poisson,expansion,diffusivity,conductivity'
  bad "the lines end in carriage returns alone" 'friction,traction,peclet\r0.6,0.5,100\r'
  bad "the header names what is no option of solve: --friction" '--friction,traction,peclet'
  bad "the header names what is no option of solve: help" 'friction,traction,help'
  bad "the header names what is no option of solve: output" 'friction,traction,output'
  bad "the header has a column without a name (a comma at its end?)" 'friction,traction,'
  bad "the header names traction twice" 'friction,traction,traction'
  bad "the header lacks friction" 'traction,peclet'
  status=0
  "$program" sweep </dev/null >out 2>err || status=$?
  [ $status -eq 2 ] && [ ! -s out ] || fail "an empty table: status $status: $(cat out err)"
  one_line "the table is empty: it has no header"
  echo friction,creep,peclet >scenes.csv
  sweeps 0
  [ "$(wc -l <results.csv)" -eq 1 ] || fail "rows from nothing: $(cat results.csv)"
  refuses 2 "jobs = 0 is not allowed: it must be from 1 to 1024" sweep --jobs 0
  refuses 2 "jobs = 1025 is not allowed: it must be from 1 to 1024" sweep --jobs 1025
  refuses 2 "jobs = two is not allowed: it must be a whole number" sweep --jobs two
}

# An option of the sweep, or of a case file, holds where a row has no value of its own: its results are
# those of the table that has it in every row. A creep in a row replaces a traction of the sweep.
OptionsHoldInAllRows() {
  printf '%s\n' friction,traction,peclet,heating,tolerance,roller,method 0.6,0.5,100,1,1e-3,identical,coupled \
    0.6,0.5,100,1,1e-5,identical,coupled >scenes.csv
  sweeps 0 --columns traction,creep,heat_1,unknowns,error_estimate.creep,roller
  cp results.csv expected
  printf '%s\n' friction,traction,tolerance 0.6,0.5,1e-3 0.6,0.5, >scenes.csv
  sweeps 0 --columns traction,creep,heat_1,unknowns,error_estimate.creep,roller --peclet 100 --heating 1 --tolerance 1e-5 \
    --roller identical --method coupled
  cmp results.csv expected || fail "$(cat results.csv) is not $(cat expected)"
  printf '%s\n' 'peclet = 100' 'heating = 1' 'tolerance = 1e-5' 'roller = "identical"' 'method = "coupled"' >case.toml
  sweeps 0 --columns traction,creep,heat_1,unknowns,error_estimate.creep,roller --config case.toml
  cmp results.csv expected || fail "a case file: $(cat results.csv) is not $(cat expected)"
  printf '%s\n' friction,creep 0.6,0.1 0.6, 0.6,0.2 >scenes.csv
  sweeps 0 --traction 0.5 --peclet 100 --method closed-form
  grep -q '^0.1\|^0.6,0.1,' results.csv && [ "$(cell traction 2)" = 0.5 ] || fail "$(cat results.csv)"
  [ "$(cell creep 1) $(cell creep 3)" = "0.1 0.2" ] || fail "$(cat results.csv)"
}

# The data of the wheel from its file, the tractions and the speeds from the table.
CaseFileAndTable() {
  code toml B-command-line.md >wheel.toml
  printf '%s\n' traction,speed 0.3,10 0.5, >scenes.csv
  sweeps 0 --config wheel.toml
  answers solve --config wheel.toml --traction 0.5 --format csv
  local column
  for column in creep max_temperature physical.max_temperature_celsius physical.error_estimate.creep_ratio; do
    [ "$(cell $column 2)" = "$(cell $column 1 out)" ] && [ -n "$(cell $column 1)" ] || fail "$column: $(cat results.csv)"
  done
  [ "$(cell peclet 1)" != "$(cell peclet 2)" ] || fail "one speed: $(cat results.csv)"
  printf '%s\n' traction,radius 0.5,0.3 0.5, >scenes.csv
  sweeps 0 --config wheel.toml
  [ "$(cell creep 2)" = "$(cell creep 1 out)" ] || fail "no radius: $(cat results.csv)"
  answers solve --config wheel.toml --traction 0.5 --radius 0.3 --format csv
  [ "$(cell creep 1)" = "$(cell creep 1 out)" ] && [[ "$(cell physical.radius 1)" = 0.3* ]] || fail "$(cat results.csv)"
  echo 'resume = "x.csv"' >case.toml
  refuses 2 "no option of sweep: resume" sweep scenes.csv --config case.toml
}

# Labels stay as they are, with what needs quotes in CSV, and are no options; results do not get them.
LabelsPassThrough() {
  cat >scenes.csv <<'END'
"id",friction,"my note",traction,peclet,method
7,0.6,"a, ""b"" ; c",0.5,100,closed-form
, 0.6 ,é,0.7,100,closed-form
x,0.6,,0.4,100,"closed-form"
END
  sweeps 4 --keep "my note"
  [ "$(cut -d, -f1-4 results.csv | sed -n 2p)" = '7,0.6,"a, ""b"" ; c"' ] || fail "$(cat results.csv)"
  grep -q '^,0.6,é,0.7,100,closed-form,.*,2,"traction' results.csv || fail "$(cat results.csv)"
  grep -q '^x,0.6,,0.4,100,closed-form,.*,0,$' results.csv || fail "$(cat results.csv)"
  local bad
  for bad in creep model status physical.half_width; do
    refuses 2 "keep = $bad is not allowed: it must be no name of a result" sweep scenes.csv --keep "$bad"
  done
  refuses 2 "the header lacks note, which --keep names" sweep scenes.csv --keep "my note,note"
  refuses 2 "the header names what is no option of solve: my note; --keep lets a label pass" sweep scenes.csv
}

# The results of a sweep are a table again: the prescribing column stays, and all else comes out as before
# to the errors. The data of a roller that has none and the groups in SI units were results too.
ResultsAreSweptAgain() {
  cat >scenes.csv <<'END'
id,friction,traction,creep,peclet,heating,load,speed,shear_modulus,poisson,expansion,diffusivity,conductivity,half-width,roller,tolerance,friction-law,friction-temperature,bulk-temperature
a,0.6,0.5,,100,1,,,,,,,,,,1e-8,,,
b,0.6,-0.5,,100,1,,,,,,,,,identical,1e-8,,,
c,0.6,,0.2,,,1.2e7,22.2,8.1e10,0.3,1.1e-5,1.4e-5,50,5.5e-3,identical,1e-8,,,
d,0.6,0.4,,,,1.2e7,22.2,8.1e10,0.3,1.1e-5,1.4e-5,50,5.5e-3,,1e-8,linear,3000,20
END
  sweeps 0
  cp results.csv first.csv
  local given row column
  for given in creep traction stick_slip_border; do
    "$program" sweep first.csv --given $given --output results.csv || fail "$given was not swept again"
    whole_rows <results.csv
    for row in 1 2 3 4; do
      [ "$(cell $given $row)" = "$(cell $given $row first.csv)" ] || fail "$given: $(cat results.csv)"
      for column in traction creep heat_integral max_temperature; do
        awk -v a="$(cell $column $row)" -v b="$(cell $column $row first.csv)" -v e="$(cell error_estimate.$column $row)" \
          'BEGIN { d = a - b; exit !(d * d <= (2 * e + 4e-8 * (b < 0 ? -b : b))^2 && a != "") }' ||
          fail "$given: $column of row $row: $(cell $column $row), not $(cell $column $row first.csv)"
      done
    done
  done
  refuses 2 "the table has results: --given says which of its columns prescribes" sweep first.csv
  "$program" sweep first.csv --given creep --columns id,friction,creep,peclet,heating,model | head -3 >second.csv || true
  answers sweep second.csv
  refuses 2 "given = traction is not allowed: the header lacks it" sweep second.csv --given traction
  # the direction is a result, too: that of the slip, where the bulk temperatures differ
  printf '%s\n' friction,stick_slip_border,peclet,heating,roller,direction,bulk_difference \
    0.6,0.3,100,0.0175,identical,driving,0.002 0.6,0.3,100,0.0175,identical,braking,0.002 >scenes.csv
  sweeps 0
  cp results.csv first.csv
  for given in traction creep stick_slip_border; do
    "$program" sweep first.csv --given $given --output results.csv || fail "$given was not swept again: $(cat results.csv)"
    for row in 1 2; do
      awk -v a="$(cell stick_slip_border $row)" -v b="$(cell stick_slip_border $row first.csv)" \
        'BEGIN { d = a - b; exit !(d * d < 1e-12 && a != "") }' || fail "$given: $(cat results.csv)"
      [ "$(cell direction $row)" = "$(cell direction $row first.csv)" ] || fail "$given: $(cat results.csv)"
    done
  done
}

# The columns asked for, in their order, under either spelling.
ChosenColumns() {
  write_scenes
  sweeps 4 --columns status,stick-slip-border,peclet,error_estimate.creep
  [ "$(head -1 results.csv)" = "status,stick_slip_border,peclet,error_estimate.creep" ] || fail "$(cat results.csv)"
  [ "$(sed -n 4p results.csv)" = "2,,100," ] || fail "$(cat results.csv)"
  cp results.csv some.csv
  sweeps 4
  local column
  for column in status stick_slip_border peclet error_estimate.creep; do
    [ "$(cell $column 2 some.csv)" = "$(cell $column 2)" ] || fail "$column: $(cat some.csv)"
  done
  refuses 2 "columns = crep is not allowed: it must be a column (did you mean creep?)" sweep scenes.csv --columns crep
  refuses 2 "columns = half_width is not allowed: it must be a column" sweep scenes.csv --columns half_width
  refuses 2 "columns =  is not allowed" sweep scenes.csv --columns traction,
  refuses 2 "columns = stick_slip_border is not allowed: it is named twice" sweep scenes.csv --columns stick-slip-border,status,stick_slip_border
}

# An object a line, with numbers, truth values, nulls and texts, which say what the cells say.
LinesOfJson() {
  write_scenes
  sed -i '1s/^/id,/; 2,$s/^/7,/' scenes.csv
  sweeps 4
  "$program" sweep scenes.csv --format jsonl >rows 2>err || [ $? -eq 4 ] || fail "$(cat err)"
  python3 - <<'END' || fail "other rows: $(head -1 rows)"
import csv, json
cells, rows = list(csv.DictReader(open("results.csv"))), [json.loads(x) for x in open("rows")]
assert len(rows) == len(cells) == 4
for row, cell in zip(rows, cells):
    assert list(row) == list(cell)
    for name, value in row.items():
        text = cell[name]
        if name in ("id", "error"): assert value == (text or None) or value == text, name
        elif text == "": assert value is None, name
        elif text in ("true", "false"): assert value is (text == "true"), name
        elif isinstance(value, str): assert value == text, name
        else: assert float(text) == value, name
assert rows[0]["id"] == "7" and rows[0]["status"] == 0 and rows[2]["status"] == 2 and rows[0]["admissible"] is True
END
}

# Every column is described, with a type that its cells have, and numbers with a unit.
DataPackageDescribesTheColumns() {
  code toml B-command-line.md >wheel.toml
  printf '%s\n' id,traction,speed a,0.3,10 b,0.5, c,0.7,1 >scenes.csv
  mkdir results
  refuses 4 "1 of 3 rows have an error" sweep scenes.csv --config wheel.toml --output results/all.csv --datapackage package.json
  python3 - <<'END' || fail "$(cat package.json)"
import csv, json
package = json.load(open("package.json"))
resource = package["resources"][0]
assert resource["path"] == "results/all.csv" and resource["format"] == "csv"
fields = {x["name"]: x for x in resource["schema"]["fields"]}
rows = list(csv.DictReader(open(resource["path"])))
assert list(fields) == list(rows[0]), (list(fields), list(rows[0]))
for name, field in fields.items():
    for row in rows:
        text = row[name]
        if text == "": continue
        if field["type"] == "boolean": assert text in ("true", "false"), name
        elif field["type"] == "integer": int(text)
        elif field["type"] == "number": float(text)
        else: assert field["type"] == "string" and "unit" not in field, name
    assert ("unit" in field) == (field["type"] in ("number", "integer")), name
    if "errorColumn" in field: assert field["errorColumn"] in fields
texts = [x["name"] for x in fields.values() if x["type"] == "string"]
assert all(any(not row[x].replace(".", "").isdigit() for row in rows) for x in texts)
unit = lambda name: fields[name]["unit"]
assert [unit(x) for x in ("speed", "creep", "physical.hertz_pressure", "physical.error_estimate.radius")] == ["m/s", "1", "Pa", "m"]
assert fields["creep"]["symbol"] == "xi*" and fields["creep"]["errorColumn"] == "error_estimate.creep"
assert fields["physical.radius"]["errorColumn"] == "physical.error_estimate.radius"
END
  printf '%s\n' traction,friction_law,friction_temperature,bulk_temperature,friction_reference_temperature \
    0.3,linear,800,20,50 >law.csv
  "$program" sweep law.csv --config wheel.toml --output law-rows.csv --datapackage law.json || fail "no results"
  python3 - <<'END' || fail "$(cat law.json)"
import json
fields = {x["name"]: x for x in json.load(open("law.json"))["resources"][0]["schema"]["fields"]}
assert fields["friction_temperature"]["unit"] == "K", fields
assert fields["friction_reference_temperature"]["unit"] == "degree C", fields
assert fields["bulk_temperature"]["unit"] == "degree C", fields
END
  refuses 2 "it must stand above or beside the results" sweep scenes.csv --config wheel.toml --output all.csv --datapackage results/p.json
  refuses 2 "--datapackage describes the results of a whole table" sweep scenes.csv --config wheel.toml --datapackage p.json
  [ ! -e all.csv ] && [ ! -e p.json ] || fail "left behind: $(ls)"
  printf 'caf\351,friction,traction,peclet\n1,0.6,0.5,100\n' >scenes.csv
  run sweep scenes.csv --keep $'caf\351' --output $'caf\351.csv' --datapackage p.json
  [ $status -eq 0 ] && [ ! -s err ] || fail "status $status: $(cat err)"
  grep -qF '"name": "caf�"' p.json && grep -qF '"path": "caf�.csv"' p.json || fail "$(cat p.json)"
}

# Before a row is solved: with --resume, rows would be there.
BadPackagesAreFoundAtOnce() {
  write_scenes
  mkdir folder closed closed/open
  refuses 1 "cannot write folder: Is a directory" sweep scenes.csv --resume results.csv --datapackage folder
  [ ! -e results.csv ] || fail "rows were solved: $(cat results.csv)"
  cp "$program" program
  chmod 755 "$scratch" . program
  chmod 777 closed/open
  chmod 555 closed
  status=0
  powerless ./program sweep scenes.csv --resume closed/open/results.csv --datapackage closed/p.json 2>err || status=$?
  chmod 755 closed
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  one_line "cannot write closed/p.json: Permission denied"
  [ ! -e closed/open/results.csv ] || fail "rows were solved: $(cat closed/open/results.csv)"
  refuses 2 "it must be a file" sweep scenes.csv --resume folder --datapackage p.json
  [ "$(ls)" = "$(printf '%s\n' chapter.csv closed err folder out program scenes.csv)" ] || fail "left behind: $(ls)"
}

# A file as the argument, `-`, or standard input: the same bytes.
TableInAFile() {
  write_scenes
  sweeps 4
  cp results.csv expected
  "$program" sweep scenes.csv >results.csv 2>err || [ $? -eq 4 ] || fail "$(cat err)"
  cmp results.csv expected
  "$program" sweep - <scenes.csv >results.csv 2>err || [ $? -eq 4 ] || fail "$(cat err)"
  cmp results.csv expected
  refuses 2 "cannot read the table absent.csv: No such file" sweep absent.csv
  refuses 2 "cannot read the table .: Is a directory" sweep .
}

# The file is complete when it appears. After a signal, a refusal or a full disk there is none, or the old one.
OutputIsWholeOrAbsent() {
  write_scenes
  sweeps 4
  cp results.csv expected
  refuses 4 "1 of 4 rows have an error" sweep scenes.csv --output results.csv
  cmp results.csv expected
  echo old >results.csv
  endless() { cat scenes.csv; yes 0.6,0.7,100,1,; }
  interrupt INT 600000 "$program" sweep --output results.csv < <(endless)
  [ $status -eq 130 ] || fail "status $status: $(cat err)"
  one_line "stopped by a signal: Interrupt, after "
  [ "$(cat results.csv)" = old ] || fail "$(head -1 results.csv)"
  refuses 2 "the header names" sweep --given creep --output results.csv <<<friction,crep
  status=0
  (ulimit -f 2 && "$program" sweep <scenes.csv --output results.csv 2>err) || status=$?
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  one_line "cannot write results.csv: File too large"
  [ "$(cat results.csv)" = old ] || fail "$(head -1 results.csv)"
  [ -z "$(find . -name 'thermoroll-*')" ] || fail "left behind: $(ls)"
  refuses 2 "--output and the table are the same file, scenes.csv" sweep scenes.csv --output ./scenes.csv
  ln -s scenes.csv link.csv
  refuses 2 "--datapackage and the table are the same file" sweep scenes.csv --output results.csv --datapackage link.csv
  refuses 2 "--datapackage and --output are the same file" sweep scenes.csv --output results.csv --datapackage results.csv
  refuses 1 "cannot write nowhere/results.csv" sweep scenes.csv --output nowhere/results.csv
}

# Stopped by a signal, cut in a row, cut in the header or never begun: the end is the same file. A failed
# row counts whenever it was written.
ResumesWhereItWasStopped() {
  write_scenes 10
  sed -i '1s/$/,method/; 2,$s/$/,closed-form/' scenes.csv
  local format bytes
  for format in csv jsonl; do
    "$program" sweep scenes.csv --format $format >expected 2>err || [ $? -eq 4 ] || fail "$(cat err)"
    for bytes in 0 10 5000 "$(wc -c <expected)"; do
      head -c "$bytes" expected >results
      refuses 4 "10 of 40 rows have an error" sweep scenes.csv --format $format --resume results
      cmp results expected || fail "$format: not the same after $bytes bytes"
    done
    rm results
    refuses 4 "10 of 40 rows have an error" sweep scenes.csv --format $format --resume results
    cmp results expected || fail "$format: not the same from nothing"
  done
  for format in csv jsonl; do
    "$program" sweep scenes.csv --part 40/40 --format $format >expected
    for bytes in 0 10 "$(wc -c <expected)"; do
      head -c "$bytes" expected >results
      "$program" sweep scenes.csv --part 40/40 --format $format --resume results
      cmp results expected || fail "$format: a part of a row is not the same after $bytes bytes"
    done
  done
  { echo friction,traction,peclet,heating,tolerance; yes 0.6,0.7,100,1, | head -50000; } >scenes.csv
  rm results
  interrupt TERM 600000 "$program" sweep scenes.csv --jobs 1 --resume results
  [ $status -eq 143 ] || fail "status $status: $(cat err)"
  one_line "stopped by a signal: Terminated, after "
  local rows
  rows=$(sed -n 's/.*, after \([0-9]*\) rows$/\1/p' err)
  [ "$(wc -l <results)" -eq $((rows + 1)) ] || fail "$(wc -l <results) lines, said: $(cat err)"
  run sweep scenes.csv --resume results
  [ $status -eq 4 ] || fail "$(cat err)"
  "$program" sweep scenes.csv >expected 2>err || true
  cmp results expected || fail "not the same after a signal"
}

# Another table, other options, too many rows, or no file at all are refused, and the file stays as it is.
# Not what stands in a file without a line feed, unless it is a beginning of the results.
ErasesNoOtherFile() {
  write_scenes
  head -1 scenes.csv >header.csv
  printf 'precious data' >notes.txt
  cp notes.txt kept
  local arguments
  for arguments in scenes.csv header.csv "scenes.csv --format jsonl" "header.csv --format jsonl" \
    "scenes.csv --part 2/2" "header.csv --part 2/2"; do
    # shellcheck disable=SC2086
    refuses 2 "resume = notes.txt is not allowed: it does not begin as the results of this sweep do" sweep $arguments --resume notes.txt
    cmp notes.txt kept || fail "$arguments changed the file: $(cat notes.txt)"
  done
}

# What may be written but not read is not empty.
UnreadableFileIsNotResumed() {
  write_scenes
  echo precious >secret
  cp "$program" program
  chmod 755 "$scratch" . program
  [ "$(id -u)" != 0 ] || chown 65534 secret
  chmod 200 secret
  status=0
  powerless ./program sweep scenes.csv --resume secret 2>err || status=$?
  [ $status -eq 2 ] || fail "status $status: $(cat err)"
  one_line "resume = secret is not allowed: it cannot be read"
  chmod 600 secret
  [ "$(cat secret)" = precious ] || fail "the file was changed: $(cat secret)"
}

ResumesNothingElse() {
  local text
  write_scenes
  sweeps 4
  head -3 results.csv >some.csv
  cp some.csv kept
  refuses 2 "resume = some.csv is not allowed: it ends with another row" sweep scenes.csv --resume some.csv --formulation printed
  refuses 2 "it has other columns than the results" sweep scenes.csv --resume some.csv --roller identical
  refuses 2 "it has other columns than the results" sweep scenes.csv --resume some.csv --columns creep
  head -2 scenes.csv >few.csv
  refuses 2 "it has more rows than the table" sweep few.csv --resume some.csv
  cmp some.csv kept || fail "the file was changed"
  sed '3s/^/"/' some.csv >open.csv
  refuses 2 "it has a row that no sweep has written: row 2" sweep scenes.csv --resume open.csv
  for text in garbage '0.6,0.5,100'; do
    sed "3s/.*/$text/" some.csv >damaged.csv
    refuses 2 "it has a row that no sweep has written: row 2" sweep scenes.csv --resume damaged.csv
  done
  for text in '{"status": "x"}' '{"status": {}}' '["status"]' 7 words; do
    echo "$text" >some.json
    refuses 2 "it has a row that no sweep has written: row 1" sweep scenes.csv --format jsonl --resume some.json
    [ "$(cat some.json)" = "$text" ] || fail "the file was changed: $(cat some.json)"
  done
  refuses 2 "resume = . is not allowed: it must be a file" sweep scenes.csv --resume .
  echo before >before
  "$program" sweep scenes.csv --resume - >>before 2>err && fail "- is no file that ends"
  one_line "resume = - is not allowed: it must be a file"
  [ "$(cat before)" = before ] || fail "standard output was cut: $(head -2 before)"
  refuses 2 "resume = /dev/full is not allowed: it must be a file" sweep scenes.csv --resume /dev/full
  refuses 2 "--output and --resume exclude each other" sweep scenes.csv --resume some.csv --output other.csv
  refuses 2 "--resume and the table are the same file" sweep scenes.csv --resume scenes.csv
  mkfifo rows
  "$program" sweep <rows --resume some.csv 2>first &
  exec 3>rows
  cat scenes.csv >&3
  until [ "$(wc -l <some.csv)" -eq 5 ]; do sleep 0.05; done
  refuses 1 "cannot write some.csv, to which another sweep appends" sweep scenes.csv --resume some.csv
  exec 3>&-
  wait $! || true
  cmp some.csv results.csv || fail "other results: $(cat first)"
}

# Files, appended rows, descriptions and refusals are the same bytes in languages with other letters and decimals.
SameInEveryLocale() { # slow
  make_locales
  code toml B-command-line.md >wheel.toml
  printf '%s\n' id,traction,speed I,0.3,10.5 ı,-0.5, c,0.75,1.5 i,0.25,2e-3 >scenes.csv
  local locale torn command=(sweep scenes.csv --config wheel.toml)
  refuses 4 "1 of 4 rows have an error" "${command[@]}" --output all.csv --datapackage package.json
  mv all.csv expected
  mv package.json expected.json
  refuses 2 "" sweep - <<<FRICTION,TRACTİON
  mv err expected-err
  for locale in tr_TR de_DE; do
    LC_ALL=$locale.UTF-8 refuses 4 "1 of 4 rows have an error" "${command[@]}" --output all.csv --datapackage package.json
    cmp all.csv expected && cmp package.json expected.json || fail "$locale makes a difference"
    for torn in 0 100 2500 3300; do
      head -c $torn expected >all.csv
      LC_ALL=$locale.UTF-8 refuses 4 "1 of 4 rows have an error" "${command[@]}" --resume all.csv --datapackage package.json
      cmp all.csv expected && cmp package.json expected.json || fail "$locale makes a difference to what follows byte $torn"
    done
    LC_ALL=$locale.UTF-8 refuses 2 "" sweep - <<<FRICTION,TRACTİON
    cmp err expected-err || fail "$locale: $(cat err)"
  done
}

# Any number of parts, also more than rows, and with empty lines among them.
PartsJoinedAreTheWhole() {
  write_scenes 3
  sed -i '3s/$/\n\n  /' scenes.csv
  local format of part
  for format in csv jsonl; do
    "$program" sweep scenes.csv --format $format >expected 2>err || true
    for of in 1 5 16; do
      : >joined
      for part in $(seq $of); do
        status=0
        "$program" sweep scenes.csv --format $format --part "$part/$of" >>joined 2>err || status=$?
        [ $status -eq 0 ] || [ $status -eq 4 ] || fail "part $part of $of: $(cat err)"
      done
      cmp joined expected || fail "$of parts of $format are not the whole"
    done
  done
}

PartsOfFilesOnly() {
  write_scenes
  local bad
  for bad in 0/2 3/2 1/0 1 1/ /2 a/b 1.5/2 1/2/3 -1/2 1/1000001 nan/2 0x1/0x3 ' 1/3'; do
    refuses 2 "part = $bad is not allowed: it must be I/N" sweep scenes.csv --part "$bad"
  done
  refuses 2 "--part needs the table as a file" sweep --part 1/2 <scenes.csv
  mkfifo rows
  cat scenes.csv >rows &
  refuses 2 "a part can be had of a table in a file only" sweep rows --part 1/2
}

BadOptions() {
  write_scenes
  refuses 2 "given = peclet is not allowed: it must be traction, creep, stick-slip-border, creep-ratio or tangential-load" sweep scenes.csv --given peclet
  refuses 2 "output = " sweep scenes.csv --output ""
  refuses 2 "TABLE = " sweep ""
  refuses 2 "resume = " sweep scenes.csv --resume ""
  refuses 2 "columns =  is not allowed: it must be A,B,..." sweep scenes.csv --columns ""
  refuses 2 "keep =  is not allowed" sweep scenes.csv --keep ""
  refuses 2 "given =  is not allowed" sweep scenes.csv --given ""
  refuses 2 "part =  is not allowed: it must be I/N" sweep scenes.csv --part ""
  refuses 2 "format = text is not allowed: it must be csv or jsonl" sweep scenes.csv --format text
  refuses 2 "a quote is not closed" sweep scenes.csv --columns '"a'
  refuses 2 "unexpected more.csv" sweep scenes.csv more.csv
  refuses 2 "speed = x is not allowed" sweep scenes.csv --speed x
}

# One line says that the program waits, only on a terminal and not for a file.
NoteOnATerminal() { # slow
  script -qec true /dev/null </dev/null >"$work/script" 2>&1 || { echo "skipped: $(cat "$work/script")"; exit 77; }
  write_scenes
  printf 'friction,traction,peclet\n0.6,0.5,100\n\004' | script -qec "'$program' sweep >results.csv" /dev/null >terminal
  grep -q 'thermoroll: note: the table is read from the terminal' terminal || fail "$(cat terminal)"
  script -qec "'$program' sweep scenes.csv >results.csv" /dev/null </dev/null >terminal || true
  ! grep -q 'note:' terminal || fail "$(cat terminal)"
}

# In SI units, with a half-width or a radius, and a dimensionless row among them.
DataInSiUnits() {
  cat >scenes.csv <<'END'
friction,traction,load,speed,shear-modulus,poisson,expansion,diffusivity,conductivity,half-width,radius,peclet,method
0.6,0.5,1.2e7,22.2,8.1e10,0.3,1.1e-5,1.4e-5,50,5.5e-3,,,
0.6,0.5,1.2e7,22.2,8.1e10,0.3,1.1e-5,1.4e-5,50,,0.229,,
0.6,0.5,,,,,,,,,,4360,closed-form
0.6,0.5,1.2e7,22.2,8.1e10,0.3,1.1e-5,1.4e-5,50,,,,
0.6,0.5,1.2e7,22.2,8.1e10,0.3,1.1e-5,1.4e-5,50,,-1,,
0.6,0.5,1.2e7,22.2,81,0.3,1.1e-5,1.4e-5,50,5.5e-3,,,
END
  sweeps 4
  local base=(--friction 0.6 --traction 0.5 --load 1.2e7 --speed 22.2 --shear-modulus 8.1e10 --poisson 0.3
    --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50) column row
  for row in 1 2; do
    if [ $row = 1 ]; then answers solve "${base[@]}" --half-width 5.5e-3 --format csv
    else answers solve "${base[@]}" --radius 0.229 --format csv; fi
    for column in peclet heating creep physical.half_width physical.radius physical.max_temperature_celsius; do
      [ "$(cell $column $row)" = "$(cell $column 1 out)" ] || fail "row $row, $column: $(cell $column $row)"
    done
  done
  [ "$(cell physical.half_width 3)" = "" ] && [ "$(error_of 3)" = "0 " ] || fail "$(cat results.csv)"
  [ "$(error_of 4)" = "2 data in SI units need either --half-width or --radius" ] || fail "$(error_of 4)"
  [ "$(error_of 5)" = "2 radius = -1 is not allowed: it must be positive" ] || fail "$(error_of 5)"
  [ "$(cell notes 1)" = "" ] && [ "$(error_of 6)" = "0 " ] || fail "$(cat results.csv)"
  [[ "$(cell notes 6)" == "half_width_over_radius = "*"; creep_ratio = "* ]] || fail "$(cell notes 6)"
}

# What a spreadsheet may do to a table makes no difference, nor does a missing end of the last line.
ForgivesSpreadsheets() {
  write_scenes
  sweeps 4
  cp results.csv expected
  { printf '\xef\xbb\xbf'; sed 's/,/ ,\t/g; s/$/\r/' scenes.csv; printf '\r\n\n'; } >other
  mv other scenes.csv
  sweeps 4
  cmp results.csv expected || fail "carriage returns, blanks and a byte-order mark make a difference"
  write_scenes
  printf '%s' "$(cat scenes.csv)" >other
  mv other scenes.csv
  sweeps 4
  cmp results.csv expected || fail "the missing line end makes a difference"
  printf '\n \t\r' >>scenes.csv
  sweeps 4
  cmp results.csv expected || fail "a last line of blanks makes a difference"
}

# The header and each row are there before the next row is written.
RowsComeAsTheyAreRead() {
  coproc "$program" sweep 2>err
  local line row
  echo friction,traction,peclet,method >&"${COPROC[1]}"
  read -r -t 20 line <&"${COPROC[0]}" || fail "no header came"
  for row in 0.1 0.2 0.3; do
    echo "0.6,$row,100,closed-form" >&"${COPROC[1]}"
    read -r -t 20 line <&"${COPROC[0]}" || fail "no row came"
    [ "${line#"0.6,$row,100,"}" != "$line" ] || fail "another row: $line"
  done
}

SameBytesWithAnyNumberOfJobs() {
  write_scenes 20
  sweeps 4 --jobs 1
  cp results.csv expected
  local jobs
  for jobs in 2 7; do
    sweeps 4 --jobs $jobs
    cmp results.csv expected || fail "$jobs jobs make a difference"
  done
  sweeps 4
  cmp results.csv expected || fail "all processors make a difference"
}

# While the first row is being solved, far more rows are done than may wait for it.
RowsKeepTheirOrder() {
  { echo friction,traction,peclet,heating,method,nodes
    echo 0.6,0.5,100,0.1,gauss-chebyshev,1000
    seq 1 3000 | sed 's/.*/0.6,0.7,&,,,/'; } >scenes.csv
  sweeps 4 --jobs 4
  cut -d, -f1-3 results.csv | cmp - <(cut -d, -f1-3 scenes.csv) || fail "other rows, or in another order"
}

# The same program with the sanitizers and little optimisation differs by less than the errors that
# both state, and in no status. (With one compiler the bits are the same.)
SameWithSanitizers() {
  local other="$project/build/asan-ubsan"
  grep -q '^CMAKE_CXX_FLAGS:STRING=-O1 .*-fsanitize=address' "$other/CMakeCache.txt" || fail "compiled otherwise"
  local version # without the revision, which each build took when it was made
  version=$("$program" --version)
  [[ "$("$other/thermoroll" --version)" == "${version% (*}"* ]] || fail "another version"
  write_scenes
  awk 'BEGIN { srand(1); for (i = 1; i <= 20; ++i)
    printf "%.6g,%.6g,%.6g,%.6g,%g\n", 0.6, 0.6 * (0.02 + 0.96 * rand()), 10^(5 * rand()),
      10^(-4 + 4 * rand()), 10^-(2 + i % 7) }' >>scenes.csv
  sweeps 4
  cp results.csv optimised
  program="$other/thermoroll"
  sweeps 4
  numbers() { # numbers FILE: a result a line: row, name, value, error; "-" where there is none
    awk -F, 'function or_none(cell) { return cell == "" ? "-" : cell }
      NR == 1 { for (i = 1; i <= NF; ++i) column[name[i] = $i] = i; next }
      { print NR, "status", $column["status"], 0
        for (i = 6; i <= NF; ++i) if (("error_estimate." name[i]) in column)
          print NR, name[i], or_none($i), or_none($column["error_estimate." name[i]]) }' "$1"
  }
  paste -d' ' <(numbers optimised) <(numbers results.csv) >both
  [ "$(grep -c stick_slip_border both)" -eq 24 ] || fail "$(head both)"
  awk '{ apart = $3 - $7; if (apart < 0) apart = -apart }
    NF != 8 || $1 != $5 || $2 != $6 || !(apart <= $4 + $8) || ($3 == "-") != ($7 == "-") { print; exit 1 }' both >out ||
    fail "differs by more than the errors: $(cat out)"
}

# Twenty times the rows, which are mostly refusals and so soon done, take no more memory: certainly
# less than a quarter of what they would take if they were kept, or their results.
MemoryIsBounded() { # for a release
  memory() { # memory COPIES: megabytes at most
    write_scenes 1
    { cat scenes.csv; yes 0.6,0.7,100,1, | head -"$1"; } >more
    mv more scenes.csv
    sweeps 4 --jobs 4 --verbose
    sed -n 's/.* rows\/s, \([0-9]*\) MB$/\1/p' err
  }
  local few many
  few=$(memory 5000) many=$(memory 300000)
  # Thirty bytes of each row, kept, would be nine megabytes.
  [ $((many - few)) -le 2 ] || fail "$few MB for few, $many MB for many rows"
}

LongLines() {
  { echo friction,traction,peclet,method; head -c 3000000 /dev/zero | tr '\0' 7; echo; echo 0.6,0.5,100,closed-form; } >scenes.csv
  sweeps 4
  [ "$(error_of 1)" = "2 the row has more than 10000 characters" ] || fail "$(error_of 1)"
  [ "$(error_of 2)" = "0 " ] || fail "$(error_of 2)"
  { echo friction,traction,peclet; head -c 10002 /dev/zero | tr '\0' ' '; echo 0.6,0.5,100; } >scenes.csv
  sweeps 4
  [ "$(error_of 1)" = "2 the row has more than 10000 characters" ] || fail "$(error_of 1)"
  printf 'friction,traction,peclet,%09968d,heating-2\n0.6,0.5,100,x,1\n' 1 >scenes.csv # was cut to heating
  refuses 2 "the header has more than 10000 characters" sweep scenes.csv --keep "$(printf '%09968d' 1)"
}

UnreadableInput() {
  status=0
  "$program" sweep <. >out 2>err || status=$?
  [ $status -eq 1 ] && [ ! -s out ] || fail "a folder: status $status: $(cat out err)"
  one_line "cannot read the table: Is a directory"
  status=0
  "$program" sweep <&- >out 2>err || status=$?
  [ $status -eq 1 ] && [ ! -s out ] || fail "no input: status $status: $(cat out err)"
  one_line "cannot read the table: Bad file descriptor"
}

# More threads than there is memory for: those that have started end as well.
TooManyThreads() {
  write_scenes
  status=0
  (ulimit -v 2000000 && "$program" sweep --jobs 1024 <scenes.csv >results.csv 2>err) || status=$?
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  grep -q '^thermoroll: cannot solve more than [1-9][0-9]* rows at a time (see --jobs): Resource temp' err || fail "$(cat err)"
}

# The rows never end, but the sweep does when nobody reads them.
ClosedPipe() {
  write_scenes
  set +o pipefail
  { status=0; { cat scenes.csv; yes 0.6,0.7,100,1,; } | "$program" sweep 2>err || status=$?; echo $status >status; } | head -3 >out
  [ "$(cat status)" = 1 ] || fail "status $(cat status): $(cat err)"
  one_line "cannot write to standard output: Broken pipe"
  [ "$(wc -l <out)" = 3 ] || fail "$(cat out)"
}

# Of many slow rows, those are solved that were begun when the first could not be written.
NobodyReadsNobodyWorks() { # slow
  { echo friction,traction,peclet,heating,method,nodes
    yes 0.6,0.5,100,0.1,gauss-chebyshev,300 | head -24; } >scenes.csv
  seconds() { # seconds COMMAND: of all processors
    local TIMEFORMAT=%U
    { time bash -c "$1" "$program" >/dev/null 2>&1; } 2>&1
  }
  local all few
  all=$(seconds '"$0" sweep --jobs 2 <scenes.csv')
  few=$(seconds '"$0" sweep --jobs 2 <scenes.csv | head -1')
  awk -v all="$all" -v few="$few" 'BEGIN { exit !(all > 0 && few < all / 3) }' ||
    fail "$few s of the $all s for all rows"
}

# A thread cannot be started, while the first row is being solved and another thread has come to the
# end of the window: that one is woken, and writes no row in place of the first. (LD_PRELOAD is cut at
# blanks.)
FullWindowWhenThreadsRunOut() { # slow
  "${CXX:-c++}" -shared -fPIC -o "$scratch/few-threads.so" -x c++ - -ldl <<'END'
#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>
#include <cerrno>
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*start)(void*), void* argument) {
  static int count = 0;
  if (++count == 4) return usleep(300000), EAGAIN;
  const auto create = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, start, argument);
}
END
  { echo friction,traction,peclet,heating,method,nodes
    echo 0.6,0.5,100,0.1,gauss-chebyshev,1000
    yes 0.6,0.7,100,1,, | head -3000; } >scenes.csv
  status=0
  LD_PRELOAD="$scratch/few-threads.so" timeout -s KILL 60 "$program" sweep --jobs 8 <scenes.csv >out 2>err || status=$?
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  one_line "Resource temporarily unavailable"
  cut -d, -f1-3 out | cmp - <(cut -d, -f1-3 scenes.csv | head -"$(wc -l <out)") || fail "other rows: $(head -3 out)"
}

# An input that does not wait: `dd` sets that for all who share it.
WaitsWhereItMayNotBlock() {
  { echo friction,traction,peclet; yes 0.6,0.7,100 | head -2000; } >scenes.csv
  sweeps 4
  cp results.csv expected
  { sleep 0.3; cat scenes.csv; } | { dd iflag=nonblock count=0 of=dd 2>dd && "$program" sweep 2>err; } >results.csv || true
  cmp results.csv expected || fail "other rows: $(cat err)"
}

# On a full device, and in a file that may not grow further. The rows in the file are whole, but for
# the last.
FullDiskLeavesWholeRows() {
  write_scenes 100
  status=0
  "$program" sweep <scenes.csv >/dev/full 2>err || status=$?
  [ $status -eq 1 ] || fail "status $status on a full device"
  one_line "cannot write to standard output: No space left on device"
  status=0
  (ulimit -f 20 && "$program" sweep <scenes.csv >results.csv 2>err) || status=$?
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  one_line "cannot write to standard output: File too large"
  head -n -1 results.csv >whole
  mv whole results.csv
  whole_rows <results.csv
  [ "$(wc -c <results.csv)" -gt 10000 ] || fail "hardly anything in the file"
}

# Rows that never end, a signal when some are written: what is there is whole, and the program dies
# of the signal. A reader that does not read cannot prevent that.
InterruptedLeavesWholeRows() {
  write_scenes
  endless() { cat scenes.csv; yes 0.6,0.7,100,1,; }
  died() { # died NUMBER NAME
    [ $status -eq "$1" ] || fail "status $status, not $1: $(cat err)"
    one_line "stopped by a signal: $2"
  }
  interrupt INT 600000 "$program" sweep < <(endless) >results.csv
  died 130 Interrupt
  whole_rows <results.csv
  interrupt TERM 600000 "$program" sweep < <(endless) >results.csv
  died 143 Terminated
  whole_rows <results.csv
  mkfifo unread
  exec 3<>unread
  interrupt HUP 1 "$program" sweep < <(endless) >unread
  exec 3>&-
  died 129 Hangup
}

IgnoredSignalsStayIgnored() {
  write_scenes
  mkfifo rows
  (trap '' HUP && exec "$program" sweep <rows >results.csv 2>err) &
  local pid=$!
  exec 3>rows
  cat scenes.csv >&3
  sleep 0.3
  kill -HUP $pid
  tail -n +2 scenes.csv >&3
  exec 3>&-
  status=0
  wait $pid || status=$?
  [ $status -eq 4 ] || fail "status $status: $(cat err)"
  [ "$(wc -l <results.csv)" = 9 ] || fail "$(wc -l <results.csv) rows"
}

# A file that is appended to keeps its rows when the disk is full, and is gone on with; a description that
# cannot be written leaves the results, and is itself absent.
FullDiskIsGoneOnWith() {
  write_scenes 100
  "$program" sweep scenes.csv >expected 2>err || [ $? -eq 4 ] || fail "$(cat err)"
  status=0
  (ulimit -f 20 && "$program" sweep scenes.csv --resume results.csv 2>err) || status=$?
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  one_line "cannot write results.csv: File too large"
  [ "$(wc -c <results.csv)" -gt 10000 ] || fail "hardly anything in the file"
  refuses 4 "100 of 400 rows have an error" sweep scenes.csv --resume results.csv
  cmp results.csv expected || fail "not the same after a full disk"

  head -2 scenes.csv >one.csv
  status=0
  (ulimit -f 2 && "$program" sweep one.csv --output one --datapackage package.json 2>err) || status=$?
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  one_line "cannot write package.json: File too large"
  [ "$(wc -l <one)" = 2 ] && [ ! -e package.json ] || fail "left behind: $(ls)"
  [ -z "$(find . -name 'thermoroll-*')" ] || fail "left behind: $(ls)"
}

# Only there, and not among the rows.
ProgressOnATerminal() { # slow
  script -qec true /dev/null </dev/null >"$work/script" 2>&1 || # as in a chroot without /dev/pts
    { echo "skipped: $(cat "$work/script")"; exit 77; }
  write_scenes 50
  on_terminal() { # on_terminal COMMAND: ends with the status 4
    status=0
    script -qec "$1" /dev/null </dev/null >terminal || status=$?
    [ $status -eq 4 ] || fail "status $status: $(cat terminal)"
  }
  on_terminal "'$program' sweep <scenes.csv >results.csv"
  grep -q 'thermoroll: 200 rows, 50 with an error, [0-9]* rows/s, [0-9]* MB' terminal || fail "$(cat terminal)"
  [ "$(tr '\r' '\n' <terminal | grep -c 'rows/s')" -ge 2 ] || fail "nothing before the end: $(cat terminal)"
  on_terminal "'$program' sweep scenes.csv --resume results.csv" # nothing is left to solve
  grep -q 'thermoroll: 200 rows, 50 with an error, 0 rows/s' terminal || fail "$(cat terminal)"
  on_terminal "'$program' sweep <scenes.csv"
  [ "$(tr '\r' '\n' <terminal | grep -c 'rows/s')" -eq 1 ] || fail "more than the end: $(cat terminal)"
  sweeps 4
  one_line "50 of 200 rows have an error"
}

# A sweep that fails, and one that tells of nothing, do not look like measurements, and a table stays as
# it was.
BenchmarkOfSweepsFailsWithThem() {
  local other
  echo kept >table
  for other in false true; do
    ! bash "$project/tests/sweep-bench.sh" $other table 10 >out 2>err || fail "$other was measured: $(cat out)"
    [ -s err ] && [ ! -s out ] || fail "said: $(cat out err)"
    [ "$(cat table)" = kept ] || fail "the table is another"
  done
}

# measured TABLE ROWS...: the table has a row for each method and tolerance and every number of rows; all has
# been measured, and memory does not grow with the rows: 30 bytes of each row, kept, would be 30 MB. To 1e-6 the
# hardest scene of more rows has more unknowns, and takes more.
measured() {
  local table=$1
  shift
  awk -F, -v sizes="$*" '
    BEGIN { numbers = split(sizes, size, " "); split("default,1e-6 default,1e-3 closed-form,", run, " ") }
    NR == 1 { wrong = $0 != "method,tolerance,rows,rows/s,ms/row,MB,machine,date"; next }
    { name = $1 "," $2; first[name] = first[name] ? first[name] : $6 }
    NF != 8 || !($4 > 0 && $5 > 0 && $6 > 0) || $6 > first[name] + ($2 == "1e-6" ? 50 : 10) { wrong = 1 }
    !$7 || $8 !~ /^20[0-9][0-9]-[0-9][0-9]-[0-9][0-9]$/ { wrong = 1 }
    name != run[(NR - 2) % 3 + 1] || $3 != size[int((NR + 1) / 3)] { wrong = 1 }
    END { exit wrong || NR != 3 * numbers + 1 }' "$table"
}

BenchmarkMakesTheTable() {
  bash "$project/tests/sweep-bench.sh" "$program" table 20 30 >out
  measured table 20 30 || fail "$(cat table)"
  cmp out table || fail "another table is printed"
}

MeasuredMemoryDoesNotGrow() {
  local sizes="10000 100000 1000000" change
  cp "$project/figures/measured/sweep.csv" table
  measured table $sizes || fail "$(cat table)"
  for change in '$d' '2s/,10000,/,1000,/' '2s/1e-6/1e-5/' '8s/,\([0-9]*\),\([^,]*,[^,]*\)$/,1\1,\2/' '9s/,\([0-9]*\),\([^,]*,[^,]*\)$/,3\1,\2/' \
    '4s/,10000,[^,]*/,10000,0/' '1s/MB/kB/' '4s/,[^,]*$/,/'; do
    sed "$change" table >other
    ! cmp -s table other || fail "not damaged: $change"
    ! measured other $sizes || fail "not seen: $change"
  done
}

# --- GNU parallel ---------------------------------------------------------------------------------

# The chapter's commands, as they stand there, with the blocks smaller and this machine in place of
# others.
prepare_parallel() {
  local bin="$scratch/bin" # PARALLEL_SSH is cut at blanks
  mkdir "$bin" home
  ln -s "$program" "$bin/thermoroll"
  cat >"$bin/other-machine" <<'END'
#!/bin/sh
# In place of ssh: HOST -- COMMAND..., with the SHELL that a login sets, whatever is set here.
echo "$1" >>hosts
shift 2
SHELL=/bin/sh exec sh -c "$*"
END
  chmod +x "$bin/other-machine"
  export PATH="$bin:$PATH" HOME="$PWD/home" PARALLEL_SSH="$bin/other-machine"
  write_scenes 40
  sweeps 4
  mv results.csv expected
  code sh D-sweeps-and-reliability.md >commands
}

WorksWithParallel() { # slow
  prepare_parallel
  sed -n '/^parallel --pipe/,/results.csv$/p' commands | sed 's/--block 1M/--block 1k/' >command
  [ "$(wc -l <command)" = 2 ] || fail "the chapter has other commands: $(cat commands)"
  bash command 2>err
  cmp results.csv expected || fail "other results: $(cat err)"
  [ "$(sort -u hosts | paste -sd' ')" = "far near" ] || fail "hosts: $(cat hosts)"
}

# The chapter's script of an array, each task twice, as if it had been stopped.
TasksOfAnArray() {
  prepare_parallel
  sed -n '/^#!\/bin\/sh/,/^# When/p' commands | sed 's|/100|/8|' >task
  [ "$(grep -c '^thermoroll sweep' task) $(wc -l <task)" = "1 5" ] || fail "the chapter has other commands: $(cat commands)"
  local task
  for task in 3 1 2 4 5 6 7 8; do
    status=0
    SLURM_ARRAY_TASK_ID=$task sh task 2>err || status=$?
    [ $status -eq 4 ] || fail "status $status: $(cat err)"
  done
  head -c 3000 part-003.csv >cut
  mv cut part-003.csv
  SLURM_ARRAY_TASK_ID=3 sh task 2>err || true
  sed -n 's/^# When all have ended: //p' task >join
  sh join
  cmp results.csv expected || fail "other results"
}

"$1"
