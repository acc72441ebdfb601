#!/usr/bin/env bash
# Read by the tests of the command line, in the project's folder: `program`, the scratch folder as
# the current one, and functions that run the program and look at its answers.
source tests/common.sh
program=$(realpath "$2")
project=$PWD
chapters=$(realpath paper)
cd "$work"

# run ARGUMENT...: leaves the status in $status, the output in `out` and the messages in `err`.
run() {
  status=0
  "$program" "$@" >out 2>err || status=$?
}

# answers ARGUMENT...: succeeds, and says nothing beside the answer, but for a note on the scheme.
answers() {
  run "$@"
  [ $status -eq 0 ] || fail "$* gave status $status: $(cat err)"
  case "$*" in
  *gauss-chebyshev*) sed -i '/^thermoroll: note: /d' err ;;
  esac
  [ ! -s err ] || fail "$* said: $(cat err)"
  [ -s out ] || fail "$* answered nothing"
}

one_line() { # one_line WORDS: exactly one line was said, with these words in it
  [ "$(wc -l <err)" -eq 1 ] && grep -q '^thermoroll: .' err || fail "not one line: $(cat err)"
  grep -qF -- "$1" err || fail "said: $(cat err); expected: $1"
}

# refuses STATUS WORDS ARGUMENT...: this status, one line with these words, no output.
refuses() {
  local expected=$1 words=$2
  shift 2
  run "$@"
  [ $status -eq "$expected" ] || fail "$* gave status $status, not $expected: $(cat err)"
  [ ! -s out ] || fail "$* wrote: $(cat out)"
  one_line "$words"
}

# code LANGUAGE CHAPTER: the blocks of code in this language that stand in a chapter.
code() {
  awk -v start="^\`\`\` $1\$" '$0 ~ start { inside = 1; next } /^```$/ { inside = 0 } inside' "$chapters/$2"
}

# interrupt SIGNAL BYTES COMMAND...: runs the command and sends it the signal when it waits for signals,
# which is its second thread, and has written so many bytes. (With job control, as otherwise a command
# in the background ignores an interrupt. The thread sanitizer writes half a megabyte before main().)
interrupt() {
  local signal=$1 bytes=$2 pid
  shift 2
  set -m
  "$@" <&0 2>err &
  set +m
  pid=$! status=0
  ready() { [ "$(find "/proc/$pid/task" -mindepth 1 -maxdepth 1 | wc -l)" -ge 2 ]; }
  written() { sed -n 's/^wchar: //p' "/proc/$pid/io"; }
  until ready && [ "$(written)" -ge "$bytes" ]; do
    grep -qa . "/proc/$pid/cmdline" || fail "ended before it could be interrupted: $(cat err)"
    sleep 0.05
  done
  kill -"$signal" $pid
  wait $pid || status=$?
}

# Turkish and German locales, as tr_TR.UTF-8 and de_DE.UTF-8; skipped where they cannot be made.
make_locales() {
  export LOCPATH="$scratch/locales"
  mkdir "$LOCPATH"
  localedef -i tr_TR -f UTF-8 "$LOCPATH/tr_TR.UTF-8" >/dev/null 2>&1 &&
    localedef -i de_DE -f UTF-8 "$LOCPATH/de_DE.UTF-8" >/dev/null 2>&1 ||
    { echo "skipped: locales cannot be made here"; exit 77; }
  [ "$(LC_ALL=de_DE.UTF-8 locale decimal_point)" = , ] || fail "no German locale"
}

# As an unprivileged user, who may run but not write here.
powerless() {
  if [ "$(id -u)" != 0 ]; then "$@"; else setpriv --reuid 65534 --regid 65534 --clear-groups "$@"; fi
}
