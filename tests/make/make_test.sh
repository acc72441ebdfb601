#!/usr/bin/env bash
# make_test.sh CASE: one promise of the Makefile, run in the project's folder. The cases are the
# functions below that begin with a capital.
source tests/common.sh
unset MAKEFLAGS MFLAGS MAKELEVEL THERMOROLL_STARTED
project=$PWD
copy="$project/build/make-test/a copy"
fakes="$work/fakes"
mkdir "$fakes"

# fake NAME: a command from stdin, found before the true one.
fake() {
  { echo '#!/bin/sh'; cat; } >"$fakes/$1"
  chmod +x "$fakes/$1"
}

with_fakes() { env PATH="$fakes:$PATH" "$@"; }

# hide NAME: a folder of all commands but this one, to be the PATH.
hide() {
  local folders folder
  mkdir "$work/bin"
  IFS=: read -ra folders <<<"$PATH"
  for folder in "${folders[@]}"; do ln -sf "$folder"/* "$work/bin/"; done
  rm -f "$work/bin/$1"
}

# The steps that a log tells of, without their numbers and times.
steps() { sed -n 's|^\[ *[0-9]*/[0-9]* *[0-9]* s\] ||p' "$1"; }

expect_steps() {
  local log=$1
  shift
  diff <(printf '%s\n' "$@" | sort) <(steps "$log" | sort) || fail "not the steps expected: $(cat "$log")"
}

# in_copy GOAL: the copy, with nothing left to do for this goal whatever case went before.
in_copy() {
  cd "$copy"
  make "$1" >"$work/log" 2>&1 || fail "$(cat "$work/log")"
}

# A copy of the project, configured from nothing. Data, figures, the report and most objects are taken over
# to save the time; of the library for C, the program and a benchmark something is compiled, and of the two texts the
# short one is woven. Headers that are compiled would be newer than the objects. A source that is compiled together
# with others is known to the build only as one of the files that an object was made of.
BuildsInFolderWithSpace() {
  rm -rf "$copy"
  mkdir -p "$copy"
  tar --exclude=./build --exclude=./.git -cf - . | tar -xf - -C "$copy"
  make -C "$copy" build/release/with-bench >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  cmake -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON "$copy/build/release" >"$work/configured" || fail "$(cat "$work/configured")"
  (cd build/release && find CMakeFiles -name '*.c*.o' ! -path '*-c.dir/*' ! -name main.cpp.o ! -name count.cpp.o \
    -exec cp --parents {} {}.d "$copy/build/release" \;)
  find "$copy/build/release" -name '*.o.d' -exec sed -i "s|${project// /\\\\ }/|${copy// /\\\\ }/|g" {} +
  cd "$copy"
  make all build/thermoroll-bench >>"$work/log" 2>&1 || fail "$(cat "$work/log")"
  expect_steps "$work/log" 'tangling the chapters' 'compiling the program' 'compiling the benchmarks'
  build/thermoroll --version
  cp -r "$project"/build/{data,figures,live.html,report.html,math.woff2,colours} "$project"/build/{colours,drawing}-* build/
  mkdir -p build/live && cp "$project/build/live/solver.wasm" build/live/
  touch "$work/now" # one time for all, that none is older than what it is made of
  find build/data build/figures build/live build/*.html build/math.woff2 build/colours -type f -exec touch -r "$work/now" {} +
  make reproduce >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  expect_steps "$work/log" 'writing build/paper.html'
  [ -s build/paper.html ] || fail "no text"
}

SecondRunDoesNothing() { # in the copy
  in_copy reproduce
  touch "$work/before"
  make reproduce >"$work/log"
  [ -z "$(steps "$work/log")" ] || fail "a second run worked: $(cat "$work/log")"
  [ -z "$(find . -newer "$work/before" -type f)" ] || fail "a second run wrote files"
  grep -q build/report.html "$work/log" || fail "the report is not named: $(cat "$work/log")"
}

ProseEditRewritesTheReportOnly() { # in the copy
  in_copy reproduce
  printf '\nOne sentence more.\n' >>paper/25-conclusions.md
  touch "$work/before"
  make reproduce >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  expect_steps "$work/log" 'tangling the chapters' 'compiling the program' 'colouring the code' \
    'compiling the benchmarks' 'writing build/report.html' 'writing build/paper.html'
  [ -z "$(find src build/release build/data build/figures -newer "$work/before" \
    \( -name '*.?pp' -o -name '*.o' -o -name '*.a' -o -name thermoroll -o -path 'build/data/*' \
    -o -path 'build/figures/*' \))" ] || fail "something was compiled, computed or drawn"
  grep -q 'One sentence more' build/report.html || fail "the report is not new"
}

DraftIsOneChapter() { # in the copy
  in_copy figures
  make draft CHAPTER=25 >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  [ -z "$(steps "$work/log")" ] || fail "more was made: $(cat "$work/log")"
  grep -q '<h2[^>]*sec:conclusions' build/draft.html || fail "the chapter is not there"
  [ "$(grep -c '<h2' build/draft.html)" -le 2 ] || fail "more than a chapter and its references"
  ! make draft CHAPTER=150 >"$work/log" 2>&1 || fail "drew up a chapter that is not there"
  grep -q 'draft: there is no paper/150-' "$work/log" || fail "said: $(cat "$work/log")"
}

# Of the two texts the short one is woven, which takes less time.
FigureScriptEditRedrawsOneFigure() { # in the copy
  in_copy build/paper.html
  echo '# a comment' >>figures/slip.gp
  make build/paper.html >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  expect_steps "$work/log" 'drawing build/figures/slip.svg' 'writing build/paper.html'
}

# The recipe of the appendix: no more is made than depends on the equation, and the curve is another.
# (What other cases start from is put back, with its times, so that they need not make it again.)
EquationEditChangesItsFigure() { # in the copy
  in_copy figures
  cp -a paper/05-closed-form.md src/model/carter.cpp build "$work"
  sh src/program/recipes/equation.sh >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  expect_steps "$work/log" 'tangling the chapters' 'compiling the program' 'computing build/data/slip.csv' \
    'drawing build/figures/slip.svg'
  ! cmp -s build/figures/slip.svg "$work/build/figures/slip.svg" || fail "the figure is the same"
  rm -r build
  mv "$work/build" .
  cp -a "$work/05-closed-form.md" paper/
  cp -a "$work/carter.cpp" src/model/
}

# The whole run is stopped when half a figure is written: no half figure stays, and the next run
# mends it.
InterruptedRunLeavesNothingHalfWritten() { # in the copy, for a release
  in_copy figures
  local signal before
  fake gnuplot <<'END'
for argument; do case $argument in *output=*) output=${argument##*output=\'}; output=${output%\'*};; esac; done
echo '<svg' >"$output"
kill -$SIGNAL 0
END
  before=$(cksum <build/figures/slip.svg)
  for signal in TERM INT KILL; do
    touch figures/slip.gp
    ! SIGNAL=$signal with_fakes setsid --wait make figures >"$work/log" 2>&1 ||
      fail "$signal went unnoticed"
    [ ! -e build/figures/slip.svg ] || [ "$(cksum <build/figures/slip.svg)" = "$before" ] ||
      fail "$signal left half a figure"
    make figures >"$work/log" 2>&1 || fail "$(cat "$work/log")"
    [ "$(cksum <build/figures/slip.svg)" = "$before" ] || fail "the next run did not mend it"
  done
}

# Figures drawn two at a time are the same figures.
TwoJobsDrawTheSameFigures() { # in the copy, for a release
  in_copy figures
  mv build/figures "$work/one-job"
  make -j2 figures >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  diff -r "$work/one-job" build/figures || fail "figures differ"
  rm -r build/figures
  mv "$work/one-job" build/figures # older than the report
}

# Two runs at once in one folder: the second says that it waits, and both end with all figures. The
# first draws until the second waits.
TwoRunsTakeTurns() { # in the copy, for a release
  in_copy figures
  local status=0 first
  ls build/figures >"$work/all"
  fake gnuplot <<END
until grep -q Waiting '$work/second' 2>/dev/null; do
  if [ -e '$work/ended' ] || [ ! -e '$work/log' ]; then exit 1; fi
  touch '$work/drawing'
  sleep 0.1
done
exec $(command -v gnuplot) "\$@"
END
  touch figures/slip.gp figures/creep.gp
  with_fakes make figures >"$work/first" 2>&1 &
  first=$!
  until [ -e "$work/drawing" ]; do kill -0 $first || fail "$(cat "$work/first")"; sleep 0.1; done
  make figures >"$work/second" 2>&1 &
  wait $! || fail "$(cat "$work/second")"
  touch "$work/ended"
  wait $first || status=$?
  [ $status -eq 0 ] || fail "$(cat "$work/first")"
  expect_steps "$work/first" 'drawing build/figures/creep.svg' 'drawing build/figures/slip.svg'
  [ -z "$(steps "$work/second")" ] || fail "both draw: $(cat "$work/second")"
  [ "$(grep -c 'Waiting for another make in this folder' "$work/second")" = 1 ] || fail "$(cat "$work/second")"
  ls build/figures | diff "$work/all" - || fail "figures are missing"
}

# A dry run and the help need no lock, and work where nothing may be written. The lock of a make that is
# killed, with all that it started, goes with it.
LockHindersNoOther() {
  mkdir "$work/project"
  cp -r Makefile CMakeLists.txt CMakePresets.json paper src figures "$work/project"
  cd "$work/project"
  fake pandoc <<<"touch '$work/tangling'; exec sleep 60"
  env PATH="$fakes:$PATH" setsid make build/tangle.stamp >"$work/first" 2>&1 &
  local first=$! as=()
  until [ -e "$work/tangling" ]; do kill -0 $first || fail "$(cat "$work/first")"; sleep 0.1; done
  timeout 30 make -n build/tangle.stamp >"$work/log" 2>&1 || fail "a dry run waits: $(cat "$work/log")"
  ! timeout 1 make build/tangle.stamp >"$work/log" 2>&1 || fail "no lock was held"
  grep -q 'Waiting for another make' "$work/log" || fail "said: $(cat "$work/log")"
  kill -KILL -- -$first
  wait $first 2>/dev/null || true
  timeout 60 make build/tangle.stamp >"$work/log" 2>&1 || fail "after a kill: $(cat "$work/log")"
  ! grep -q Waiting "$work/log" || fail "a lock was left: $(cat "$work/log")"
  rm -r build
  chmod 755 "$scratch" "$work"
  chmod -R a-w .
  [ "$(id -u)" != 0 ] || as=(setpriv --reuid 65534 --regid 65534 --clear-groups)
  "${as[@]}" make -n all >"$work/log" 2>&1 || fail "a dry run in a read-only folder: $(cat "$work/log")"
  "${as[@]}" make help >"$work/log" 2>&1 || fail "help in a read-only folder: $(cat "$work/log")"
  grep -q '^make check  ' "$work/log" && grep -q '^make build/figures/NAME.svg  ' "$work/log" || fail "$(cat "$work/log")"
  chmod -R u+w .
}

# Where there is no flock, nothing waits and nothing is said.
WorksWithoutFlock() {
  hide flock
  mkdir "$work/project"
  cp -r Makefile paper src figures "$work/project"
  cd "$work/project"
  PATH="$work/bin" make build/tangle.stamp >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  expect_steps "$work/log" 'tangling the chapters'
  [ "$(wc -l <"$work/log")" = 1 ] || fail "said: $(cat "$work/log")"
}

# Without gnuplot: nothing is begun, and the package and the command that installs it are named.
MissingCommand() {
  hide gnuplot
  mkdir "$work/project"
  cp -r Makefile CMakeLists.txt CMakePresets.json paper src figures "$work/project"
  cd "$work/project"
  ! PATH="$work/bin" make figures >"$work/log" 2>&1 || fail "worked without gnuplot"
  grep -q "gnuplot not found.*make setup figures.*apt-get install gnuplot-nox" "$work/log" ||
    fail "said: $(cat "$work/log")"
  [ "$(wc -l <"$work/log")" = 1 ] || fail "more than one line: $(cat "$work/log")"
  [ ! -e build ] || fail "something was begun"
  PATH="$work/bin" make -n all >/dev/null 2>&1 || fail "gnuplot is not needed to build"
}

# Whatever capitals the name of the folder has, the chapters are tangled for the debugger as well.
ConfiguresInFolderWithCapitals() {
  mkdir "$work/My Project"
  cp -r CMakeLists.txt paper src "$work/My Project"
  cmake -S "$work/My Project" -B "$work/build" -DTHERMOROLL_LINES=ON >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  [ -s "$work/build/tangled/src/program/sweep.cpp" ] || fail "nothing was tangled"
}

MissingLibrary() { # for a release
  local pair
  for pair in Eigen3:libeigen3-dev GSL:libgsl-dev CLI11:libcli11-dev \
    nlohmann_json:nlohmann-json3-dev GTest:libgtest-dev benchmark:libbenchmark-dev; do
    ! cmake -B "$work/build" -DTHERMOROLL_TESTS=ON -DTHERMOROLL_BENCH=ON \
      -DCMAKE_DISABLE_FIND_PACKAGE_"${pair%:*}"=ON >"$work/log" 2>&1 || fail "worked without $pair"
    tr -s '\n ' ' ' <"$work/log" | grep -q "${pair%:*} is missing.*apt-get install ${pair#*:} " ||
      fail "$pair: said: $(cat "$work/log")"
    rm -rf "$work/build"
  done
}

# A Debian on which nothing is installed yet, and an apt-get that only tells what it was asked for.
bare_debian() {
  fake dpkg-query <<<'exit 1'
  fake id <<<'echo 0'
  fake apt-get <<<"echo \"apt-get \$*\" >>'$work/asked'"
}

SetupInstallsWhatTheGoalsNeed() {
  bare_debian
  with_fakes make setup help >/dev/null
  [ ! -e "$work/asked" ] || fail "help needs nothing: $(cat "$work/asked")"
  with_fakes make setup >/dev/null
  grep -q ' update$' "$work/asked" || fail "no update: $(cat "$work/asked")"
  grep -q -- '--no-install-recommends.* gnuplot-nox' "$work/asked" || fail "$(cat "$work/asked")"
  ! grep -q 'chromium\|libgtest-dev' "$work/asked" ||
    fail "more than reproduce needs: $(cat "$work/asked")"
}

SetupIsQuietWhenAllIsThere() {
  fake dpkg-query <<<'printf installed'
  fake apt-get <<<"echo \"apt-get \$*\" >>'$work/asked'"
  with_fakes make setup >"$work/log"
  [ ! -e "$work/asked" ] || fail "apt-get ran: $(cat "$work/asked")"
  [ ! -s "$work/log" ] || fail "said: $(cat "$work/log")"
}

SetupComesFirst() { # in the copy, for a release
  in_copy figures
  bare_debian
  fake apt-get <<<"echo install >>'$work/order'; sleep 0.3"
  fake gnuplot <<<"echo draw >>'$work/order'; exec $(command -v gnuplot) \"\$@\""
  touch figures/slip.gp
  with_fakes make -j2 figures setup >/dev/null
  [ "$(uniq "$work/order" | tr '\n' ' ')" = "install draw " ] || fail "order: $(cat "$work/order")"
}

# A misspelt goal is found before anything is installed.
SetupRefusesUnknownGoal() {
  bare_debian
  ! with_fakes make setup reprodcue test >"$work/log" 2>&1 || fail "worked"
  grep -q "no goal reprodcue: 'make help'" "$work/log" || fail "said: $(cat "$work/log")"
  [ ! -e "$work/asked" ] || fail "apt-get ran: $(cat "$work/asked")"
}

SetupWithoutRootOrSudo() {
  bare_debian
  fake id <<<'echo 1000'
  hide sudo
  ! PATH="$fakes:$work/bin" make setup >"$work/log" 2>&1 || fail "worked without root"
  grep -q 'not root.*apt-get install --no-install-recommends cmake' "$work/log" ||
    fail "said: $(cat "$work/log")"
  [ ! -e "$work/asked" ] || fail "apt-get ran"
}

SetupWithoutDebian() {
  hide apt-get
  ! PATH="$work/bin" make setup >"$work/log" 2>&1 || fail "worked without apt-get"
  grep -q "no apt-get here.*pandoc" "$work/log" || fail "said: $(cat "$work/log")"
}

# The print has the text and the chunks of the chapters, each once. The program's plumbing in the
# appendices, what writes the data, the assembled files, the scripts and the index, which need the
# screen, stay folded.
PrintIsShort() { # in the copy, for a release
  in_copy report
  make pdf >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  local pages size
  pages=$(grep -ac '/Type /Page$' build/report.pdf)
  size=$(wc -c <build/report.pdf)
  [ "$pages" -gt 50 ] && [ "$pages" -lt 200 ] || fail "$pages pages"
  [ "$size" -lt 5000000 ] || fail "$size bytes"
  pdftotext -f 1 -l 1 build/report.pdf "$work/first.txt"
  grep -q 'Friction that falls with temperature' "$work/first.txt" && grep -q 'Certified results' "$work/first.txt" || fail "no contents on the first page"
  pages=$(grep -ac '/Type /Page$' build/paper.pdf)
  [ "$pages" -ge 10 ] && [ "$pages" -le 14 ] || fail "the short version has $pages pages"
  pdftotext -bbox build/report.pdf "$work/words.xml" # the pages end 11 mm above the edge of the paper
  awk -F'"' '/<page / { ++page; end = $4 - 11 / 25.4 * 72 }
    /<word / && $4 < end - 0.5 && $8 > end + 0.5 { print "page " page; exit 1 }' "$work/words.xml" >"$work/cut" ||
    fail "a line is cut at the end of $(cat "$work/cut")"
  has_running_head report "$(grep -ac '/Type /Page$' build/report.pdf)"
  has_running_head paper "$pages"
}

# has_running_head NAME PAGES: the printed pages have the title at their top, the first has none. The
# spaces are left out, as the print spaces letters.
has_running_head() {
  local title head page
  title=$(sed -nE 's/.*@top-center \{ content: "([^"]+)".*/\1/p' "build/$1.html" | tr -d ' ')
  [ "${#title}" -gt 20 ] || fail "no running head in $1.html"
  pdftotext -layout "build/$1.pdf" "$work/print.txt"
  for ((page = 1; page <= $2; ++page)); do
    head=$(awk -v RS='\f' -v page="$page" 'NR == page' "$work/print.txt" | grep -m 1 . | tr -d ' ')
    [ "$page" = 1 ] || [ "$head" = "$title" ] || fail "page $page of $1.pdf begins with $head"
    [ "$page" -gt 1 ] || [ "$head" != "$title" ] || fail "the first page of $1.pdf has a running head"
  done
}

# readme LANGUAGE, chapter LANGUAGE: the blocks of code in this language that are no chunks, of the README
# and of the chapter on other languages.
code() { awk -v begin="\`\`\` $1" '$0 == begin { on = 1; next } /^```/ { on = 0 } on' "$2"; }
readme() { code "$1" "$project/README.md"; }
chapter() { code "$1" "$project/paper/K-from-other-languages.md"; }

# same_answers FILE FILE: the same words and errors, and numbers no further apart than the errors stated
# behind them and half a last digit.
same_answers() {
  awk -v other="$2" '
    function words(line) { gsub(/[0-9][-+.0-9e]*/, "#", line); return line }
    function half_digit(x) { sub(/^[0-9]*\.?/, "", x); return 0.5001 * 10 ^ -length(x) }
    {
      if ((getline line <other) != 1 || words($0) != words(line)) exit 1
      split(line, b)
      for (k = 1; k <= NF; ++k) {
        if ($k !~ /^[0-9]/) continue
        if ($(k - 1) == "+-" && $k != b[k]) exit 1
        bound = 2 * half_digit($k) + ($(k + 1) == "+-" ? $(k + 2) + b[k + 2] : 0)
        if ($k - b[k] > bound || b[k] - $k > bound) exit 1
      }
    }
    END { if ((getline line <other) == 1) exit 1 }' "$1"
}

# What make install puts there can be found by CMake and used, as the README shows.
InstalledPackage() { # in the copy
  in_copy all
  local prefix="$work/prefix" user="$work/user" file
  make install PREFIX="$prefix" >/dev/null
  "$prefix/bin/thermoroll" --version
  for file in README.md CHANGELOG.md LICENSE CITATION.cff; do
    cmp $file "$prefix/share/doc/thermoroll/$file"
  done
  (cd "$prefix/share/doc/thermoroll/examples" && PATH="$prefix/bin:$PATH" sh curves.sh &&
    gnuplot -e "data = 'curves.csv'; output = 'curves.svg'" recipe-curves.gp && [ -s curves.svg ]) || fail "the examples do not run"
  "$prefix/bin/thermoroll" help --format man | cmp - "$prefix/share/man/man1/thermoroll.1"
  "$prefix/bin/thermoroll" help --format bash | cmp - "$prefix/share/bash-completion/completions/thermoroll"

  mkdir "$user"
  readme cpp >"$user/example.cpp"
  readme cmake >"$user/CMakeLists.txt"
  readme text >"$user/expected"
  cmake -S "$user" -B "$user/build" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
  cmake --build "$user/build" >/dev/null
  "$user/build/example" >"$user/printed"
  same_answers "$user/expected" "$user/printed" ||
    fail "the README says: $(cat "$user/expected"); printed was: $(cat "$user/printed")"

  sed 's/^\(creep[^.]*\.[0-9][0-9]\)[0-9]/\1_/' "$user/expected" >"$user/other"
  ! same_answers "$user/other" "$user/printed" || fail "another word was not found"
  sed '/^creep/s/\.[0-9]/.9/' "$user/expected" >"$user/other"
  ! same_answers "$user/other" "$user/printed" || fail "another number was not found"
  sed '/^traction/s/[0-9]e-/9e-/' "$user/expected" >"$user/other"
  ! same_answers "$user/other" "$user/printed" || fail "another error was not found"
  sed '$d' "$user/expected" >"$user/other"
  ! same_answers "$user/other" "$user/printed" || fail "a missing line was not found"

  if command -v pkg-config >/dev/null; then
    export PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name thermoroll.pc)")
    local command words='$(pkg-config --cflags --libs thermoroll)'
    command=$(chapter sh)
    command=${command/"$words"/"$(pkg-config --cflags --libs thermoroll)"}
    (cd "$user" && eval "$command")
    "$user/example" | cmp "$user/printed" || fail "other answers by pkg-config"
    if grep -qw avx2 /proc/cpuinfo; then # the program's matrices are aligned as the library's
      (cd "$user" && eval "$command -mavx2")
      "$user/example" | cmp "$user/printed" || fail "other answers with -mavx2"
    fi
  fi

  sed -i.kept 's/find_package(thermoroll /&0.0 /' "$user/CMakeLists.txt"
  ! cmake -S "$user" -B "$user/build" >/dev/null 2>&1 || fail "another version was taken for this one"
  sed 's/(thermoroll REQUIRED/& COMPONENTS fortran/' "$user/CMakeLists.txt.kept" >"$user/CMakeLists.txt"
  ! cmake -S "$user" -B "$user/build" >"$work/log" 2>&1 || fail "there is a component fortran"
  grep -q 'no component fortran: there are c and cpp' "$work/log" || fail "said: $(cat "$work/log")"
}

# in_c: the README's project for CMake, in C.
in_c() { readme cmake | sed 's/CXX)$/C)/; s/\.cpp/.c/; s/thermoroll::thermoroll/thermoroll::c/; s/(thermoroll REQUIRED/& COMPONENTS c/'; }

# The library for C and the Python module that make install puts there, by CMake and pkg-config, and by
# the folder on Python's path. In C neither Eigen nor GSL is looked for.
InstalledForOtherLanguages() { # in the copy
  in_copy all
  local prefix="$work/prefix" user="$work/user" python
  make install PREFIX="$prefix" >/dev/null
  ! grep -rnE '@(eq|sec|tbl|fig|lst):' "$prefix/include" || fail "an installed header has references"
  [ -e "$prefix/include/thermoroll.f90" ] || fail "no Fortran module"

  mkdir "$user"
  readme c >"$user/example.c"
  readme out | head -3 >"$user/expected"
  in_c >"$user/CMakeLists.txt"
  cmake --no-warn-unused-cli -S "$user" -B "$user/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_DISABLE_FIND_PACKAGE_{Eigen3,GSL}=ON >/dev/null ||
    fail "see above"
  cmake --build "$user/build" >/dev/null || fail "see above"
  "$user/build/example" | diff "$user/expected" - || fail "other answers by CMake"
  if command -v pkg-config >/dev/null; then
    export PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name thermoroll_c.pc)")
    (cd "$user" && eval "cc example.c $(pkg-config --cflags --libs thermoroll_c) -o example")
    LD_LIBRARY_PATH="$prefix/lib" "$user/example" | diff "$user/expected" - || fail "other answers by pkg-config"
  fi

  for python in python3 /usr/bin/python3; do
    ! "$python" -c 'import numpy' 2>/dev/null || break
  done
  ! "$python" -c 'import numpy' 2>/dev/null || PYTHONPATH="$prefix/lib/python3/dist-packages" "$python" -c '
import thermoroll
print(thermoroll.solve(friction=0.6, traction=0.3, peclet=4360, heating=0.0175).creep)' | grep -q '^0.1117' ||
    fail "the Python module does not find its library"
}

# other_project HOW CMAKELISTS: a project that takes the sources in by add_subdirectory or FetchContent in
# place of find_package, configured.
other_project() {
  user="$work/user"
  rm -rf "$user"
  mkdir -p "$user"
  readme cpp >"$user/example.cpp"
  readme c >"$user/example.c"
  ln -s "$project" "$user/thermoroll"
  chapter cmake | if [ "$1" = FetchContent ]; then grep FetchContent; else grep '^add_subdirectory'; fi >"$work/lines"
  [ "$(wc -l <"$work/lines")" = "$([ "$1" = FetchContent ] && echo 3 || echo 1)" ] || fail "the chapter has other lines"
  sed -e "/^find_package/{r $work/lines" -e 'd}' "$2" >"$user/CMakeLists.txt"
  cmake -Wno-dev --no-warn-unused-cli -G 'Unix Makefiles' -S "$user" -B "$user/build" -DFETCHCONTENT_SOURCE_DIR_THERMOROLL="$project" \
    -DTHERMOROLL_TOGETHER=ON -DCMAKE_DISABLE_FIND_PACKAGE_{CLI11,nlohmann_json,GTest,benchmark}=ON >/dev/null || fail "$1: see above"
}

# targets: those that its default goal still compiles something of. (What is linked is not there yet, hence -k.)
targets() { { make -C "$user/build" -nk 2>/dev/null || true; } | grep -oE '[a-z-]+\.dir/[^ ]*\.o ' | cut -d. -f1 | sort -u | paste -sd' '; }

# Within another project the targets and the include path are those of the installed package. What only
# the program needs is not looked for, and the libraries are all there is to build, that for C if it is linked.
UsedInAnotherProject() {
  local how user
  readme cmake >"$work/cpp"
  in_c >"$work/c"
  for how in add_subdirectory FetchContent; do
    other_project $how "$work/c"
    cmake --build "$user/build" --target example.c.o >/dev/null || fail "$how: thermoroll.h is not found"
    [ "$(targets)" = 'thermoroll thermoroll-c' ] || fail "$how builds $(targets)"
    other_project $how "$work/cpp"
    cmake --build "$user/build" --target example.cpp.o >/dev/null || fail "$how: the header is not found"
    [ "$(targets)" = thermoroll ] || fail "$how builds $(targets)"
  done
}

# The README's program in C and that in C++ answer there as it says.
AnswersInAnotherProject() { # for a release
  local user
  in_c | sed '$a add_executable(in_cpp example.cpp)\ntarget_link_libraries(in_cpp PRIVATE thermoroll::thermoroll)' |
    sed 's/ C)$/ C CXX)/' >"$work/both"
  other_project add_subdirectory "$work/both"
  cmake --build "$user/build" >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  "$user/build/example" | diff <(readme out | head -3) - || fail "other answers in C"
  "$user/build/in_cpp" >"$user/printed"
  readme text >"$user/expected"
  same_answers "$user/expected" "$user/printed" || fail "other answers in C++: $(cat "$user/printed")"
}

# The builds that look for mistakes stop at a warning, and so does the program that is compiled for the
# tests; what a user builds goes on, by whatever compiler.
WarningsAreErrorsInTheTests() { # for a release
  strict() { grep -q -- '-Werror' "$work/build/compile_commands.json"; }
  cmake -B "$work/build" >/dev/null
  grep -q -- '-Wconversion' "$work/build/compile_commands.json" || fail "a plain build does not warn"
  ! strict || fail "a plain build stops at warnings"
  cmake --preset release -B "$work/build" >/dev/null
  ! strict || fail "the program stops at warnings"
  local preset
  for preset in dev debug asan-ubsan tsan coverage; do
    rm -r "$work/build"
    cmake --preset $preset -B "$work/build" >/dev/null
    strict || fail "$preset goes on"
  done
  mkdir -p "$work/project"
  cp -r Makefile CMakeLists.txt CMakePresets.json paper src figures "$work/project"
  cd "$work/project"
  local switch='-DTHERMOROLL_TESTS=ON -DTHERMOROLL_WERROR=ON'
  make -n test >"$work/log" 2>&1
  grep -q -- "$switch" "$work/log" || fail "the tests are built without: $(head "$work/log")"
  ! make -n reproduce | grep -q WERROR || fail "reproduce stops at warnings"
  mkdir -p build
  touch build/built
  make -n test >"$work/log" 2>&1
  ! grep -q WERROR "$work/log" || fail "a program that is there is compiled again"
}

# Where there is ccache, it is asked before the compiler, unless another launcher is chosen or none.
CompilesThroughCcache() {
  unset CMAKE_CXX_COMPILER_LAUNCHER
  fake ccache <<<'exec "$@"'
  launched() { grep -rqF "$1" "$work/build" --include=build.make; }
  with_fakes cmake -B "$work/build" >/dev/null
  launched /fakes/ccache || fail "ccache is not used"
  with_fakes cmake -B "$work/build" -DCMAKE_CXX_COMPILER_LAUNCHER=env >/dev/null
  ! launched /ccache || fail "ccache is used in place of another launcher"
}

# Any line of a source is found in its chapter.
WhereNamesTheChaptersLine() { # of the text
  local file=src/solver/coupled.cpp number place
  for number in 2 50 100 200; do
    while [ -z "$(sed -n "${number}p" $file)" ]; do number=$((number + 1)); done # no line of a chunk
    place=$(make where AT=$file:$number)
    diff <(sed -n "${number}s/^ *//p" $file) <(sed -n "${place##*:}s/^ *//p" "${place%:*}") || fail "$number: $place"
  done
  [ "$(make where AT=$file)" = "$(make where AT=$file:2)" ] || fail "without a line: $(make where AT=$file)"
}

# The extracts in the chapter on the build stand in the Makefile, line by line.
ChapterQuotesTheFiles() { # of the text
  awk '/^``` make$/ { inside = 1; next } /^```$/ { inside = 0 } inside' paper/H-build.md >"$work/quoted"
  [ -s "$work/quoted" ] || fail "the chapter quotes nothing"
  local line
  while IFS= read -r line; do
    grep -qxF -- "$line" Makefile || fail "not in the Makefile: $line"
  done <"$work/quoted"
}

# Every package of the Makefile has its reason in the chapter and in the README, and no other has.
PackagesAreExplained() { # of the text
  sed -n 's/^[a-z]*_\?packages[a-z_]* := //p' Makefile | tr ' ' '\n' |
    grep -x '[a-z0-9+-]\+' | sort -u >"$work/listed"
  [ -s "$work/listed" ] || fail "no packages found in the Makefile"
  local text
  for text in paper/H-build.md README.md; do
    awk '/\| *package *\|| Debian package \|/ { inside = 1; next } !/^\|/ { inside = 0 } inside' $text |
      cut -d'|' -f2 | grep -o '`[^`]*`' | tr -d '`' | sort | diff "$work/listed" - ||
      fail "$text explains other packages than the Makefile lists"
  done
}

"$1"
