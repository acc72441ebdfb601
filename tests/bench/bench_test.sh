#!/usr/bin/env bash
# bench_test.sh CASE BENCH PROGRAM STUDY COUNT: one promise of the benchmarks, run in the project's folder. The cases
# are the functions below that begin with a capital.
source tests/common.sh
bench=$2 program=$3 study=$4 count=$5

# The benchmarks have the names that the report speaks of, each once.
NamesAreThoseOfTheReport() {
  "$bench" --benchmark_list_tests | sed "s|/repeats:1$||" >"$work/names"
  local name
  for name in closed_form law/evaluate temperature_curve/points:400 \
    gauss_chebyshev{,_thrifty,_moments}/n:{25,200,800}/Pe:{100,4360}/H:0.0175 \
    gauss_chebyshev{,_thrifty,_moments}/n:200/Pe:100/H:1 \
    graded_panels/n:{25,200,400}/Pe:{100/H:0.0175,4360/H:0.0175,100/H:1} \
    coupled/tol:{0.01,1e-06,1e-08}/Pe:{100/H:0.0175,4360/H:0.0175,100/H:1} \
    {identical/tau:{0,-1},unlike/{share,bulk_difference}}/Pe:{100/H:1,4360/H:0.0175} \
    friction_law/{border,creep,traction,curve:100,curve_both:100}/Pe:{100/H:1,4360/H:0.0175}; do
    grep -qxF "$name" "$work/names" || fail "no benchmark $name"
  done
  [ -z "$(sort "$work/names" | uniq -d)" ] || fail "named twice: $(sort "$work/names" | uniq -d)"
}

# The study's program writes files like the committed ones, and of the same scenes.
StudyIsWritten() { # slow
  local file wrong measured=figures/measured/study
  mkdir "$work/study"
  "$study" 52 "$work/study" # of which number 50 is in the sample
  for file in "$measured"/*; do
    [ "$(head -1 "$file")" = "$(head -1 "$work/study/${file##*/}")" ] || fail "another header of $file"
  done
  [ "$(cut -d, -f1,2 "$work/study/sample.csv")" = "$(head -2 "$measured/sample.csv" | cut -d, -f1,2)" ] ||
    fail "other scenes: $(cat "$work/study/sample.csv")"
  for file in estimates study study-kinds; do
    cmp <(wc -l <"$work/study/$file.csv") <(wc -l <"$measured/$file.csv") || fail "$file.csv is not as long"
  done
  for wrong in "" 0 x "-1" "5 $work/study"; do
    ! "$study" $wrong "$work/study" || fail "'$wrong' was taken"
  done
  ! "$study" 5 "$work/nowhere" || fail "a folder that is not there was taken"
}

# The evaluations are counted alike by every build, and refused where they cannot be written.
CountIsTheGoldenOne() { # for a release
  mkdir "$work/counted"
  "$count" "$work/counted" || fail "status $?"
  cmp <(cut -d, -f1-3,5 "$work/counted/evaluations.csv") <(cut -d, -f1-3,5 figures/golden/evaluations.csv) ||
    fail "counted: $(cat "$work/counted/evaluations.csv")"
  [ "$(grep -c '": "[0-9.]*"' "$work/counted/evaluations.json")" = 4 ] || fail "$(cat "$work/counted/evaluations.json")"
  ! "$count" || fail "no folder was taken"
  ! "$count" "$work/nowhere" || fail "a folder that is not there was taken"
}

# The program reads what the benchmarks write.
TimesCanBeRead() {
  "$bench" --benchmark_filter='^closed_form$|n:25/Pe:4360' --benchmark_min_time=0.001 \
    --benchmark_format=json >"$work/times.json" 2>/dev/null
  "$program" figure-data times --times "$work/times.json" --output "$work/times.csv"
  [ "$(wc -l <"$work/times.csv")" = 6 ] || fail "$(cat "$work/times.csv")"
  awk -F, 'NR > 1 && !($2 > 0 && $2 < 10) { exit 1 }' "$work/times.csv" || fail "$(cat "$work/times.csv")"
}

# What extends a scene is timed against one body, and says how many times as long it takes.
RatiosToOneBody() {
  "$bench" --benchmark_filter='^(identical|unlike|friction_law)/' --benchmark_min_time=0 \
    --benchmark_format=json >"$work/times.json" 2>/dev/null
  local ratios
  ratios=$(sed -nE 's/^ *"label": "([0-9.]+) times the other",?$/\1/p' "$work/times.json")
  [ "$(wc -l <<<"$ratios")" = 18 ] || fail "ratios: $ratios"
  awk '!($1 > 0) { exit 1 }' <<<"$ratios" || fail "no times: $ratios"
}

# Each ratio has a line with its median, its bar and its spread; one that spreads more than 5 % is not judged.
RatiosAreJudged() {
  "$bench" --benchmark_filter='^(identical/.*H:0.0175|gauss_chebyshev/tol:)' --benchmark_min_time=0 \
    --benchmark_repetitions=5 >/dev/null 2>"$work/judged"
  grep -E '^(identical|gauss)' "$work/judged" >"$work/lines"
  [ "$(wc -l <"$work/lines")" = 5 ] || fail "$(cat "$work/judged")"
  awk '{ told = $9 == "not" ? "not judged" : $9
         met = $4 == ">=" ? $2 >= $5 : $2 <= $5
         if (told != ($7 > 5 ? "not judged" : met ? "met" : "missed") && ($7 > 5.05 || $7 < 4.95)) exit 1 }' \
    "$work/lines" || fail "$(cat "$work/lines")"
}

# Each but the longest runs, and reports no error but that the scheme does not settle in some scene.
EachRuns() {
  local choice='--benchmark_filter=-random|n:[248]00'
  "$bench" "$choice" --benchmark_min_time=0 --benchmark_format=csv >"$work/times" 2>"$work/log" || fail "$(cat "$work/log")"
  [ "$(grep -c '^"' "$work/times")" = "$("$bench" "$choice" --benchmark_list_tests | wc -l)" ] || fail "some are missing"
  ! grep ',true,' "$work/times" | grep -v '"does not settle"' || fail "not all could run"
}

"$1"
