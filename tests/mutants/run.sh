#!/usr/bin/env bash
# run.sh [FILE | NUMBER | FIRST-LAST]: how many of the mutants of tests/mutants/list the tests kill, in
# the project's folder. All of them are compiled into one program, and MUTANT chooses one. Prints those
# that survive; status 1 where less than 95 % of those not marked equivalent are killed.
set -eu
only=${1:-}
jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export folder=$PWD/build/mutants
export project=$folder/project table=$folder/table results=$folder/results limit=0 long= slow=
unset MUTANT

# A copy of the project in which src/ has the mutants; what did not change is not compiled again.
copy_project() {
  local name
  rm -rf "$folder/new" "$results"
  mkdir -p "$folder/new" "$project/src" "$results"
  for name in *; do
    [ "$name" = src ] || [ "$name" = build ] || ln -sfn "$PWD/$name" "$project/$name"
  done
  cp -r src/. "$folder/new"
  perl tests/mutants/inject.pl tests/mutants/list src "$folder/new" >"$folder/all"
  (cd "$folder/new" && find . -type d -exec mkdir -p "$project/src/{}" ';')
  (cd "$folder/new" && find . -type f) | while read -r name; do
    cmp -s "$folder/new/$name" "$project/src/$name" || cp "$folder/new/$name" "$project/src/$name"
  done
  (cd "$project/src" && find . -type f) | while read -r name; do
    [ -e "$folder/new/$name" ] || rm "$project/src/$name"
  done
}

choose() {
  awk -F '\t' -v only="$only" '
    BEGIN { numbers = split(only, at, "-"); ranged = only ~ /^[0-9]+(-[0-9]+)?$/ }
    only == "" || index("/" $2 ";", "/" only ";") || (ranged && at[1] <= $1 + 0 && $1 + 0 <= at[numbers])' "$folder/all" >"$table"
  [ -s "$table" ] || { echo "no mutant is of '$only'" >&2; exit 2; }
}

# run_tests FOLDER OPTION...: CTest with a folder of its own, as several run at a time. Data.NAME
# computes the data NAME there and sets them against the golden ones.
run_tests() {
  local own=$1 name file test
  shift
  mkdir -p "$own/build/data"
  ln -sfn "$project/figures" "$own/figures"
  echo "subdirs(\"$folder/build\")" >"$own/CTestTestfile.cmake"
  for name in $data; do
    file=build/data/$name.csv test="*Tolerance/${name//-/_}"
    [ "$name" != values ] || file=build/data/values.json test=Values.AreWithinTheirTolerance
    echo "add_test(Data.$name bash -c [=[$folder/build/thermoroll figure-data $name --output $file && \
      $folder/build/tests/figures/figures-test --gtest_filter='$test']=])" >>"$own/CTestTestfile.cmake"
  done
  ctest --test-dir "$own" -E "SameWithSanitizers${slow:+|^($slow)$}" "$@"
}
export -f run_tests

# A word behind `tests` as an expression for the names of tests that begin so.
expression() { echo "^${1//./\\.}"; }

# Without a mutant every test passes; none is given more than ten times the time of the longest, so
# that one that hangs comes to an end.
try_without() {
  local word own=$results/0 log=$results/0.log
  for word in $(cut -f3 "$table" | tr ' ' '\n' | sort -u); do
    run_tests "$own" --no-tests=error -j "$jobs" -R "$(expression "$word")" --output-on-failure \
      >"$own.now" 2>&1 ||
      { sed -n '/^The following tests FAILED/,$p; s/^No tests were found.*/no test is '"$word/p" "$own.now" >&2; exit 2; }
    cat "$own.now" >>"$log"
  done
  limit=$(awk '$NF == "sec" && $(NF - 1) > most { most = $(NF - 1) } END { print int(5 + 10 * most) }' "$log")
  long=$(sed -nE 's/.*Test +#[0-9]+: ([^ ]+) .* Passed +([0-9.]+) sec.*/\2 \1/p' "$log" |
    awk '$1 > 1 { print $2 }' | sort -u)
}

# fails OPTION...: whether a test of the mutant $number fails; $killer is its name.
fails() {
  MUTANT=$number run_tests "$own" --stop-on-failure --timeout "$limit" "$@" >"$own.log" 2>&1 && return 1
  killer=$(sed -n 's/^\t *[0-9]* - \(.*\) (.*)$/\1/p' "$own.log" | head -1)
  killer=${killer:-one}
}

# try NUMBER: the tests of a mutant in turn, until one fails; those that take longer than a second last.
try() {
  local number file tests equivalent name word test slow own=$results/$1 killer=
  IFS=$'\t' read -r number file tests equivalent name < <(awk -v number="$1" '$1 == number' "$table")
  slow=$(paste -sd'|' <<<"$long")
  for word in $tests; do
    fails -R "$(expression "$word")" && break
  done
  slow=
  for test in $long; do
    for word in $tests; do
      [ -n "$killer" ] || ! [[ $test =~ $(expression "$word") ]] || fails -R "$(expression "$test")\$" || true
    done
  done
  rm -rf "$own"
  if [ "$equivalent" != - ]; then
    echo "equivalent $killer" >"$own.result"
    [ -z "$killer" ] || echo "$number $file: $name: is marked equivalent, but $killer fails"
  elif [ -n "$killer" ]; then
    echo "killed $killer" >"$own.result"
  else
    echo survived >"$own.result"
    echo "$number $file: $name: survives"
  fi
}
export -f try fails expression

copy_project
choose
cmake -S "$project" -B "$folder/build" -DTHERMOROLL_TESTS=ON -DTHERMOROLL_ROOT=. \
  -DCMAKE_CXX_FLAGS=-w >"$folder/build.log" 2>&1 &&
  cmake --build "$folder/build" --target unit-tests figures-test thermoroll-cli \
    >>"$folder/build.log" 2>&1 || { tail -40 "$folder/build.log" >&2; exit 2; }
data=$("$folder/build/thermoroll" figure-data --list)
export data
try_without
export long
cut -f1 "$table" | xargs -P "$jobs" -I{} bash -c 'try {}'
awk '
  { ++count[$1]; wrong += $1 == "equivalent" && NF > 1 }
  END {
    share = count["killed"] + count["survived"] ? 100 * count["killed"] / (count["killed"] + count["survived"]) : 100
    printf "%d mutants: %d killed, %d survived, %d marked equivalent; %.1f %% killed of those not equivalent\n",
      NR, count["killed"], count["survived"], count["equivalent"], share
    exit wrong > 0 || share < 95
  }' "$results"/*.result
