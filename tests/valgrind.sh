#!/usr/bin/env bash
# valgrind.sh PROGRAM: the program under memcheck, for a solve by each method, a profile, a refusal
# and a sweep; each command is named before it is run.
source tests/common.sh
program=$(realpath "$1")
cd "$work"

# checked STATUS ARGUMENT...: the program ends with this status, and nothing is found.
checked() {
  local expected=$1 status=0
  shift
  echo "thermoroll $*"
  valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,indirect \
    --show-leak-kinds=definite,indirect "$program" "$@" <scenes.csv >out 2>err || status=$?
  [ $status -eq "$expected" ] || fail "status $status: $(head -c 3000 err)"
}

paper_scene=(--friction 0.6 --traction 0.5 --peclet 4360 --heating 0.0175)
awk 'BEGIN {
  print "friction,traction,peclet,heating,method"
  for (i = 1; i <= 40; ++i) printf "%g,%g,%g,%g,\n", 0.6, 0.01 * i + 0.1, 10^(i % 5), i / 40
  print "0.6,0.5,100,0,closed-form"; print "0.6,0.7,100,0,"; print "0.6"
}' >scenes.csv
checked 0 solve "${paper_scene[@]}" --profile p.csv --format json
checked 0 solve "${paper_scene[@]}" --method closed-form
checked 0 solve "${paper_scene[@]}" --method first-order --tolerance 1e-2
checked 0 solve "${paper_scene[@]}" --method coupled
checked 0 solve "${paper_scene[@]}" --method gauss-chebyshev --nodes 50
checked 0 temperature "${paper_scene[@]}" --at -1:3:9
checked 2 solve "${paper_scene[@]}" --creep 1
checked 4 sweep --jobs 3
