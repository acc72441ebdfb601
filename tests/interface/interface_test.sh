#!/usr/bin/env bash
# interface_test.sh CASE BUILD: what the shared library shows, and the examples in C and Fortran, run in
# the project's folder. The cases are the functions below that begin with a capital.
source tests/common.sh
library="$2/libthermoroll_c.so"
project=$PWD

# code LANGUAGE FILE: the blocks of code in this language that are no chunks.
code() { awk -v begin="\`\`\` $1" '$0 == begin { on = 1; next } /^```/ { on = 0 } on' "$2"; }

needs_fortran() { command -v gfortran >/dev/null || { echo "gfortran is not installed"; exit 77; }; }

fortran() { # fortran PROGRAM FILE...
  local program=$1
  shift
  gfortran -std=f2018 -Wall -Werror -J "$work" "$project/src/include/thermoroll.f90" "$@" "$library" \
    -Wl,-rpath,"$(dirname "$library")" -o "$program" || fail "see above"
}

# The functions of the header and nothing else, under the soname of the interface.
ShowsItsFunctionsOnly() {
  nm -D --defined-only "$library" | awk '{ print $2, $3 }' | sort >"$work/shown"
  sed -nE 's/^THERMOROLL_EXPORT .*[ *](thermoroll_\w+)\(.*/T \1/p' src/include/thermoroll.h | sort >"$work/declared"
  diff "$work/declared" "$work/shown" || fail "other symbols are shown"
  [ "$(wc -l <"$work/shown")" = 8 ] || fail "not eight functions"
  readelf -d "$library" | grep -q 'SONAME.*\[libthermoroll_c\.so\.0\]' || fail "another soname"
}

# Members, types and numbers of words are the same in the three languages.
StructuresAreTheSame() {
  python3 tests/interface/structures.py c src/include/thermoroll.h >"$work/c"
  python3 tests/interface/structures.py fortran src/include/thermoroll.f90 | diff "$work/c" - || fail "Fortran differs"
  [ "$(grep -c '^scene ' "$work/c") $(grep -c '^values ' "$work/c") $(grep -c '^word ' "$work/c")" = '36 15 36' ] ||
    fail "not all were found: $(cut -d' ' -f1 "$work/c" | uniq -c)"
  grep -vE '^word .*(model|done|failed|refused|not_converged|no_contact)' "$work/c" | sort >"$work/of-python"
  python3 tests/interface/structures.py python src/python/thermoroll/__init__.py | sort | diff "$work/of-python" - ||
    fail "Python differs"

  sed 's/conductivity_ratio, heating_2/heating_2, conductivity_ratio/' src/include/thermoroll.f90 >"$work/swapped.f90"
  ! python3 tests/interface/structures.py fortran "$work/swapped.f90" | cmp -s "$work/c" - || fail "swapped members were not found"
}

# The README's program in C, without a warning, prints what the README says.
ReadmeInC() {
  code c README.md >"$work/example.c"
  ${CC:-cc} -std=c99 -Wall -Wextra -Wpedantic -Werror -Isrc/include "$work/example.c" "$library" \
    -Wl,-rpath,"$(dirname "$library")" -o "$work/example" || fail "see above"
  "$work/example" >"$work/printed"
  code out README.md | head -3 | diff - "$work/printed" || fail "the README prints something else"
}

# The chapter's program in Fortran prints the same, but for the form of an exponent.
FortranExample() {
  needs_fortran
  code fortran paper/K-from-other-languages.md >"$work/example.f90"
  fortran "$work/example" "$work/example.f90"
  "$work/example" | sed 's/\.E/e/' >"$work/printed"
  code out README.md | head -3 | diff - "$work/printed" || fail "Fortran prints something else"
}

# What the example does not call: the law, at a creep and beyond its end, the version and a message.
FortranCallsEveryFunction() {
  needs_fortran
  cat >"$work/all.f90" <<'END'
program all
  use thermoroll
  implicit none
  type(thermoroll_scene) :: scene
  type(thermoroll_result) :: result
  type(thermoroll_point) :: points(3)
  type(thermoroll_law_info) :: info
  type(thermoroll_law_value) :: values(2)
  character(kind=c_char), pointer :: text(:)
  type(c_ptr) :: law

  call thermoroll_scene_init(scene, c_sizeof(scene))
  scene%friction = 0.6d0
  scene%peclet = 4360
  scene%heating = 0.0175d0
  scene%tolerance = 1d-3
  info%size = int(c_sizeof(info))
  law = thermoroll_law_new(scene, 1d0, info)
  if (.not. c_associated(law) .or. info%status /= 0 .or. info%driving_end /= 1) stop 1
  values(1)%size = int(c_sizeof(values(1)))
  if (thermoroll_law_evaluate(law, [0.1d0, 5d0], values, 2_c_size_t) /= thermoroll_rows_failed) stop 2
  if (abs(values(1)%traction - 0.2733355075d0) > values(1)%traction_error .or. values(2)%status /= 2) stop 3
  call thermoroll_law_free(law)
  scene%quantity = thermoroll_creep
  scene%given = 0.1d0
  result%size = int(c_sizeof(result))
  points(1)%size = int(c_sizeof(points(1)))
  if (thermoroll_profile(scene, result, points, 3_c_size_t) /= 0 .or. points(3)%status /= 0) stop 6
  if (points(1)%s /= -1 .or. points(3)%s /= 1 .or. points(2)%traction <= 0) stop 7
  if (abs(result%value%traction - 0.273335d0) > 1d-3 .or. points(2)%friction /= 0.6d0) stop 8
  scene%places = thermoroll_as_given
  points%s = [0d0, 1.5d0, 1.5d0]
  points%depth = [0d0, 0d0, 0.01d0]
  if (thermoroll_profile(scene, result, points, 3_c_size_t) /= 0 .or. points(2)%s /= 1.5d0) stop 9
  if (points(2)%temperature <= points(3)%temperature .or. points(3)%temperature_error <= 0) stop 10
  call c_f_pointer(thermoroll_message(0), text, [4])
  if (text(1) // text(2) // text(3) // text(4) /= 'done') stop 4
  call c_f_pointer(thermoroll_version(), text, [2])
  if (text(2) /= '.') stop 5
end program all
END
  fortran "$work/all" "$work/all.f90"
  "$work/all" || fail "the check $? does not hold"
}

# A program that takes the decimals of its user's language gets the same numbers and words.
SameInEveryLocale() {
  localedef -i de_DE -f UTF-8 "$scratch/de_DE.UTF-8" >/dev/null 2>&1 ||
    { echo "skipped: locales cannot be made here"; exit 77; }
  cat >"$work/german.c" <<'END'
#include <locale.h>
#include <stdio.h>
#include <thermoroll.h>

int main(int count, char** arguments) {
  struct thermoroll_scene x[2];
  struct thermoroll_result y[2];
  if (count > 1 && !setlocale(LC_ALL, arguments[1])) return 2;
  fprintf(stderr, "%.1f", 0.5);
  for (int k = 0; k < 2; ++k) {
    thermoroll_scene_init(&x[k], sizeof x[k]);
    x[k].friction = 0.6;
    x[k].given = k == 0 ? 0.5 : 0.65;
    x[k].load = 1.2e7;
    x[k].speed = 22.5;
    x[k].half_width = 7.8e-3;
    x[k].shear_modulus = 2.1e9;
    x[k].poisson = 0.3;
    x[k].expansion = 1.1e-5;
    x[k].diffusivity = 1.4e-5;
    x[k].conductivity = 50;
  }
  y[0].size = sizeof y[0];
  thermoroll_solve(x, y, 2, 1);
  setlocale(LC_ALL, "C");
  for (int k = 0; k < 2; ++k)
    printf("%d %.17g %s / %s\n", y[k].status, y[k].value.creep, y[k].message, y[k].notes);
}
END
  ${CC:-cc} -Isrc/include "$work/german.c" "$library" -Wl,-rpath,"$(dirname "$library")" -o "$work/german" || fail "see above"
  "$work/german" >"$work/expected" 2>/dev/null
  grep -q '^0 .* / half_width_over_radius = 0\.[0-9]* is above 0\.1' "$work/expected" || fail "$(cat "$work/expected")"
  grep -q '^2 .*0\.65 is not allowed' "$work/expected" || fail "$(cat "$work/expected")"
  LOCPATH="$scratch" "$work/german" de_DE.UTF-8 >"$work/printed" 2>"$work/half" || fail "no German locale"
  [ "$(cat "$work/half")" = 0,5 ] || fail "German has $(cat "$work/half")"
  diff "$work/expected" "$work/printed" || fail "the locale makes a difference"
}

# The headers that are installed have printed numbers; an unknown reference ends the installation.
HeadersHavePrintedNumbers() {
  cmake -Dchapters=paper -Dfrom=src/include "-Dto=$work/to" -P paper/references.cmake
  ! grep -rnE '@(eq|sec|tbl|fig|lst):' "$work/to" || fail "references are left"
  [ "$(grep -rho ' of the report' "$work/to" | wc -l)" -gt 40 ] || fail "hardly any reference was there"
  diff <(cd src/include && find . -type f | sort) <(cd "$work/to" && find . -type f | sort) || fail "other files"
  diff -r src/include "$work/to" | grep '^[<>]' | sed -E 's/@(eq|sec|tbl):[A-Za-z0-9-]+|(\([0-9]+\)|(Section|Appendix|Table) [0-9A-Z.]+) of the report/#/g' |
    awk '/^</ { old = old substr($0, 2) "\n" } /^>/ { new = new substr($0, 2) "\n" } END { exit old != new }' ||
    fail "more than references was changed"

  mkdir "$work/paper" "$work/from"
  cat >"$work/paper/01-a.md" <<'END'
# One {#sec:one}
$$ a $$ {#eq:first}
## Under it {#sec:under}
``` sh
# no heading
```
## Next {#sec:next}
# No number {.unnumbered}
END
  cat >"$work/paper/A-b.md" <<'END'
# Appendix {#sec:appendix .appendix}
$$ a; [b] $$ {#eq:first-again paper=2}
: A table; of things. {#tbl:table}
## Its section {#sec:of-appendix}
END
  printf '%s\n' '@eq:first, @eq:first-again' '[a; "b\n"] (@sec:one): @sec:next.' '@sec:appendix; @sec:of-appendix @tbl:table' >"$work/from/a.hpp"
  cmake "-Dchapters=$work/paper" "-Dfrom=$work/from" "-Dto=$work/to" -P paper/references.cmake
  diff "$work/to/a.hpp" - <<'END' || fail "other numbers"
(1) of the report, (2) of the report
[a; "b\n"] (Section 1 of the report): Section 1.2 of the report.
Appendix A of the report; Appendix A.1 of the report Table 1 of the report
END
  echo '@eq:nowhere ' >"$work/from/a.hpp"
  ! cmake "-Dchapters=$work/paper" "-Dfrom=$work/from" "-Dto=$work/to" -P paper/references.cmake 2>"$work/log" || fail "worked"
  grep -q 'eq:nowhere' "$work/log" || fail "said: $(cat "$work/log")"
}

"$1"
