#!/usr/bin/env bash
# python_test.sh CASE BUILD: the Python module over the shared library in BUILD, run in the project's
# folder; skipped where Python has no NumPy. The cases are the functions below that begin with a capital.
source tests/common.sh
build=$2
export PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg MPLCONFIGDIR="$scratch"

# skip WORDS: end without having tested.
skip() { echo "$*"; exit 77; }

# Another Python than Debian's may stand before it on the PATH.
for python in python3 /usr/bin/python3; do
  ! "$python" -c 'import numpy' 2>/dev/null || break
done
"$python" -c 'import numpy' 2>/dev/null || skip "python3-numpy is not installed"

with_module() { THERMOROLL_LIBRARY="$build/libthermoroll_c.so" PYTHONPATH="$PWD/src/python" "$@"; }

# code FILE: its blocks in Python that are no chunks.
code() { awk '$0 == "``` python" { on = 1; next } /^```/ { on = 0 } on' "$1"; }

# Each is the function of this name in python_test.py.
run() { with_module "$python" tests/interface/python_test.py "$@" || fail "$1"; }
SameAsTheProgram() { run "${FUNCNAME[0]}" "$build/thermoroll"; }
SameAsTheProgramInSiUnits() { run "${FUNCNAME[0]}" "$build/thermoroll"; }
ProfileIsThatOfTheProgram() { run "${FUNCNAME[0]}" "$build/thermoroll"; }
ProfilesThatAreNot() { run "${FUNCNAME[0]}"; }
TemperaturesAreThoseOfTheProgram() { run "${FUNCNAME[0]}" "$build/thermoroll"; }
PlacesThatAreNot() { run "${FUNCNAME[0]}"; }
SiDataAreWhole() { run "${FUNCNAME[0]}"; }
ConductingRollersHaveTheirData() { run "${FUNCNAME[0]}"; }
RefusesWhatIsNoNumber() { run "${FUNCNAME[0]}"; }
LawInSiUnits() { run "${FUNCNAME[0]}"; }
Broadcasts() { run "${FUNCNAME[0]}"; }
Scalars() { run "${FUNCNAME[0]}"; }
RefusesWhatIsNoWord() { run "${FUNCNAME[0]}"; }
LawIsThatOfTheLibrary() { run "${FUNCNAME[0]}"; }
SameInEveryLocale() {
  local locale
  for locale in de_DE tr_TR; do
    localedef -i $locale -f UTF-8 "$scratch/$locale.UTF-8" >/dev/null 2>&1 || skip "locales cannot be made here"
  done
  export LOCPATH="$scratch"
  run "${FUNCNAME[0]}" de_DE.UTF-8 tr_TR.UTF-8
}
LawsThatAreNot() { run "${FUNCNAME[0]}"; }
LawsAreNotCopied() { run "${FUNCNAME[0]}"; }
MessagesEndWhereTheyEnd() { run "${FUNCNAME[0]}"; }
RefusesWhatDoesNotFit() { run "${FUNCNAME[0]}"; }
Throughput() { run "${FUNCNAME[0]}" "$build/tests/interface/throughput"; } # for a release

ReadmeExample() {
  code README.md >"$work/example.py"
  with_module "$python" "$work/example.py" >"$work/printed"
  awk '$0 == "``` out" { on = 1; next } /^```/ { on = 0 } on' README.md | diff - "$work/printed" ||
    fail "the README prints something else"
}

MatplotlibExample() { # slow
  "$python" -c 'import matplotlib' 2>/dev/null || skip "python3-matplotlib is not installed"
  code paper/K-from-other-languages.md >"$work/example.py"
  (cd "$work" && PYTHONPATH="$OLDPWD/src/python" THERMOROLL_LIBRARY="$build/libthermoroll_c.so" "$python" example.py) ||
    fail "see above"
  [ "$(head -c 4 "$work/map.png" | tail -c 3)" = PNG ] || fail "nothing was drawn"
}

# Below a prefix the library is four folders up, whatever else is there.
FindsTheLibrary() {
  mkdir -p "$work/lib/python3/dist-packages"
  cp -r src/python/thermoroll "$work/lib/python3/dist-packages"
  cp "$build/libthermoroll_c.so.0" "$work/lib"
  PYTHONPATH="$work/lib/python3/dist-packages" "$python" -c 'import thermoroll; print(thermoroll.version())' >"$work/out"
  [ "$(cat "$work/out")" = "$(sed -n 's/^project(thermoroll VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" ] || fail "$(cat "$work/out")"
}

# One line, which says what to do.
SaysThatTheLibraryIsMissing() {
  local place
  for place in '' "$work/nowhere.so" "$work"; do
    ! THERMOROLL_LIBRARY=$place PYTHONPATH="$PWD/src/python" LD_LIBRARY_PATH= "$python" -c 'import thermoroll' 2>"$work/err" ||
      fail "worked without its library"
    tail -1 "$work/err" | grep -q '^ImportError: thermoroll lacks its library: run make install, or set THERMOROLL_LIBRARY (' ||
      fail "said: $(cat "$work/err")"
  done
}

# By pip, without a network, into an environment that has NumPy from the system.
InstallsByPip() { # for a release
  "$python" -c 'import ensurepip, venv, wheel' 2>/dev/null || skip "python3-venv or python3-wheel is not installed"
  cp -r src/python "$work/package"
  "$python" -m venv --system-site-packages "$work/venv" || fail "no environment"
  "$work/venv/bin/python" -m pip install --quiet --no-index --no-build-isolation "$work/package" >"$work/log" 2>&1 ||
    fail "$(cat "$work/log")"
  cp "$build/libthermoroll_c.so.0" "$work/venv/lib"
  (cd "$work" && "$work/venv/bin/python" -c '
import pathlib, thermoroll
assert thermoroll.solve(friction=0.6, traction=0.5, peclet=10).status == 0
assert (pathlib.Path(thermoroll.__file__).parent / "py.typed").exists()') || fail "the installed module does not work"
}

"$1"
