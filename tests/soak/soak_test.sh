#!/usr/bin/env bash
# soak_test.sh CASE SOAK: what the soak says of its scenes. The cases are the functions below that
# begin with a capital.
source tests/common.sh
soak=$(realpath "$2")
cd "$work"

CountsEveryScene() {
  "$soak" 1100 0 >out || fail "$(cat out)"
  grep -q '^1100 scenes of seed 1 in ' out || fail "$(cat out)"
  awk '/^largest/ { exit } NR > 1 && !/\(/ { sum += $1 } END { exit sum != 1100 }' out || fail "$(cat out)"
  "$soak" 10 0 2 >other
  grep -q '^10 scenes of seed 2' other || fail "$(cat other)"
}

# A process that dies costs one scene, which is named.
CrashIsOneScene() {
  "$soak" 0 4 >out &
  local pid=$! status=0
  until pgrep -P $pid >children; do kill -0 $pid || fail "$(cat out)"; done
  kill -SEGV "$(head -1 children)"
  wait $pid || status=$?
  [ $status -eq 1 ] || fail "status $status: $(cat out)"
  grep -q '^ *1 killed: Segmentation fault$' out || fail "$(cat out)"
  grep -q '^FAILED: not so: killed: Segmentation fault, in scene [0-9]*: --friction ' out || fail "$(cat out)"
}

"$1"
