#!/usr/bin/env bash
# live_test.sh CASE BUILD: the solver in build/report.html, in a headless browser, run in the project's folder.
source tests/common.sh
command -v chromium >/dev/null || fail "chromium is missing. On Debian: apt-get install chromium"
grep -q 'id="solver"' build/report.html || fail "no solver in build/report.html: apt-get install clang lld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32"

# Each is the function of this name in live_test.py.
run() { PYTHONDONTWRITEBYTECODE=1 timeout 300 python3 tests/live/live_test.py "$@" || fail "$1"; }
NumbersAreThoseOfTheProgram() { run "${FUNCNAME[0]}"; }
CurvesCarryTheHeat() { run "${FUNCNAME[0]}"; }
HandlesAndKeys() { run "${FUNCNAME[0]}"; }
Touch() { run "${FUNCNAME[0]}"; }
SlidersAndMarks() { run "${FUNCNAME[0]}"; }
NamesAndRoles() { run "${FUNCNAME[0]}"; }
LinksAndNonsense() { run "${FUNCNAME[0]}"; }
RefusalsAreSentences() { run "${FUNCNAME[0]}"; }
SlowSolvesAreCutOff() { run "${FUNCNAME[0]}"; }
PageStandsWithoutIt() { run "${FUNCNAME[0]}"; }
PolicyThatRefuses() { run "${FUNCNAME[0]}"; } # for a release
FitsAPhone() { run "${FUNCNAME[0]}"; }

"$1"
