#!/usr/bin/env bash
# mutants_test.sh CASE: one thing that make mutants relies on or promises, run in the project's folder.
# The cases are the functions below that begin with a capital.
source tests/common.sh

# Every mutant stands in the sources once, and every source with code has at least two, but for the
# benchmarks, the certificates, which carry their own proof, and the interface of the page.
ListFitsTheSources() {
  perl tests/mutants/inject.pl tests/mutants/list src || fail "see above"
  cp -r src "$work/new"
  perl tests/mutants/inject.pl tests/mutants/list src "$work/new" >"$work/table"
  local file
  for file in src/*/*.cpp src/solver/nested_iteration.hpp src/solver/nodes.hpp src/program/live/special_functions.hpp; do
    [[ $file = src/bench/* ]] ||
      [ "$(cut -f2 "$work/table" | grep -cxF "${file#src/}")" -ge 2 ] || fail "fewer than two are of $file"
  done
}

# All mutants are compiled into one program, so one that is no C++ would stop them all.
EveryMutantCompiles() { # for a release
  cp -r src "$work/new"
  perl tests/mutants/inject.pl tests/mutants/list src "$work/new" >"$work/table"
  cd "$work/new"
  cut -f2 "$work/table" | tr ';' '\n' | grep '\.cpp$' | sort -u |
    xargs -P "$(nproc)" -I{} g++ -std=c++20 -w -fsyntax-only -include filesystem -I. -Iinclude -I/usr/include/eigen3 {} \
      2>"$work/errors" || { grep error "$work/errors" >&2; fail "see above"; }
}

# A project of one program, one test and the mutants that are in a list.
small_project() {
  cp --parents tests/mutants/run.sh tests/mutants/inject.pl "$work"
  cd "$work"
  mkdir src
  cat >src/main.cpp <<'END'
int main(int count, char**) {
  int sum = 0;
  for (int i = 1; i <= 8;
       ++i)
    sum += i;
  if (sum < 0) sum = 0;
  return count == 1 && sum != 36;
}
END
  cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.21)
project(small CXX)
enable_testing()
add_executable(thermoroll-cli src/main.cpp)
set_target_properties(thermoroll-cli PROPERTIES OUTPUT_NAME thermoroll)
add_custom_target(unit-tests)
add_custom_target(figures-test)
add_test(NAME Sum.IsRight COMMAND thermoroll-cli)
END
  printf 'file main.cpp\ntests Sum.\n' >tests/mutants/list
}

# mutant NAME CONTEXT REPLACEMENT [REASON]
mutant() {
  printf '\nmutant %s\n- %s\n+ %s\n' "$1" "$2" "$3"
  [ $# = 3 ] || echo "equivalent $4"
}

run() {
  status=0
  bash tests/mutants/run.sh "$@" >out 2>&1 || status=$?
}

TellsWhichSurvive() { # for a release
  small_project
  {
    mutant 'wrong start' 'int sum = «0»;' 1
    mutant 'no sum' '«sum += i;»' ''
    mutant 'for ever' 'i <= 8; «++i»' i
    mutant 'another comparison' 'if («sum < 0») sum' 'sum <= 0'
  } >>tests/mutants/list
  run
  [ $status = 1 ] || fail "three in four are enough: $(cat out)"
  grep -qxF '4 main.cpp: another comparison: survives' out || fail "not told: $(cat out)"
  grep -q '^4 mutants: 3 killed, 1 survived, 0 marked equivalent; 75.0 %' out || fail "said: $(cat out)"
  run 1-2
  [ $status = 0 ] && grep -q '^2 mutants: 2 killed' out || fail "of a range: $(cat out)"
  echo 'equivalent sum is then 0 already' >>tests/mutants/list
  run main.cpp
  [ $status = 0 ] && grep -q '1 marked equivalent; 100.0 %' out || fail "of a file: $(cat out)"
  sed -i 's/^mutant wrong start/&\nequivalent not at all/' tests/mutants/list
  run 1
  [ $status = 1 ] && grep -qF 'wrong start: is marked equivalent, but Sum.IsRight fails' out || fail "said: $(cat out)"
  run other.cpp
  [ $status = 2 ] && grep -q "no mutant is of 'other.cpp'" out || fail "said: $(cat out)"
}

# A list that no longer fits, tests that are not there and tests that fail without a mutant stop a run
# before it begins.
StopsAtMistakes() { # slow
  small_project
  local name
  cp tests/mutants/list list
  for name in 'gone|int product = «0»;|1|0 times' 'often|«sum»|i|5 times' \
    'half|sum < 0|1|needs its tests'; do
    IFS='|' read -r name context replacement words <<<"$name"
    { cat list; mutant "$name" "$context" "$replacement"; } >tests/mutants/list
    run
    [ $status != 0 ] && grep -q "tests/mutants/list:4: .*$words" out || fail "$name: $(cat out)"
  done
  { cat list; mutant 'all' 'if («sum < 0») sum' 'true'; mutant 'part' 'if («sum» < 0) sum' 'i'; } >tests/mutants/list
  run
  [ $status != 0 ] && grep -q 'overlaps another' out || fail "overlapping: $(cat out)"
  { sed 's/^tests.*/tests Product./' list; mutant 'wrong start' 'int sum = «0»;' 1; } >tests/mutants/list
  run
  [ $status = 2 ] && grep -q 'no test is Product.' out || fail "said: $(cat out)"
  { cat list; mutant 'wrong start' 'int sum = «0»;' 1; } >tests/mutants/list
  sed -i 's/36/37/' src/main.cpp
  run
  [ $status = 2 ] && grep -q 'Sum.IsRight' out || fail "a test that always fails: $(cat out)"
}

"$1"
