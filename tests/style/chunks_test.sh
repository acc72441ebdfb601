#!/usr/bin/env bash
# chunks_test.sh CASE: how the chapters of the paper tell their code, by tests/style/chunks.pl. The
# cases are the functions below that begin with a capital.
source tests/common.sh

# The chapters of the body that have code.
chapters() { ls paper/0[2-9]-*.md paper/[12]?-*.md; }

# measure CHAPTER...: silent (per cent without a word before them), median, p90, most.
measure() {
  perl tests/style/chunks.pl "$@" >"$work/report"
  read -r silent median p90 most < <(sed -nE '1s/^.* chunks, ([0-9]+)\.[0-9] %.* median ([0-9]+), p90 ([0-9]+), most ([0-9]+)$/\1 \2 \3 \4/p' "$work/report")
  [ -n "$most" ] || fail "no numbers: $(cat "$work/report")"
}

# Fewer than 5 % of the chunks follow another without a sentence, and they are short.
EveryChunkIsIntroduced() {
  mapfile -t files < <(chapters)
  measure "${files[@]}"
  [ "$silent" -lt 5 ] && [ "$median" -le 8 ] && [ "$p90" -le 18 ] && [ "$most" -le 30 ] ||
    fail "$(cat "$work/report")"
}

# lines TEXT N: the text on as many lines.
lines() { yes "$1" | head -n "$2"; }

# Titles, captions and lists of tests are no sentences; a file is not measured, but introduced.
SilenceIsFound() {
  cat >"$work/chapter.md" <<END
# Title

$(printf '``` {.cpp #first title="Under a title"}')
int a;
$(printf '```')
*Checked by* \`A.B\`.

A sentence.

![A caption.](figures/f.svg){#fig:f}

$(printf '``` {.cpp #second}')
int b;

int c;
$(printf '```')

![A caption.](figures/f.svg){#fig:f}

::: {#tbl:t csv="t.csv"}
A caption.
:::

$(printf '``` {.cpp file=src/a.cpp}')
$(lines 'int x;' 50)
$(printf '```')

$(printf '``` {.sh}')
no chunk
$(printf '```')

And a long one:

$(printf '``` {.cpp #third}')
$(lines 'int x;' 31)
$(printf '```')
END
  (cd "$work" && perl "$OLDPWD/tests/style/chunks.pl" chapter.md) >"$work/report"
  diff "$work/report" - <<'END' || fail "what is found"
4 chunks, 50.0 % without a word before them; lines: median 2, p90 31, most 31
chapter.md:3: first stands without a word before it
chapter.md:24: src/a.cpp stands without a word before it
chapter.md:83: third has 31 lines
END
}

# long FILE...: the functions of more than forty lines, by what stands at the left margin.
long() {
  awk '/^[A-Za-z]/ { from = /;$/ ? 0 : FNR; name = $0 }
    /^}/ { if (from && name ~ /\(/ && FNR - from + 1 > 40) print FILENAME ":" from ": " name; from = 0 }' "$@"
}

FunctionsAreShort() {
  local named found
  named=$(chapters | paste -sd '|')
  mapfile -t files < <(head -qn 1 $(find src -name '*.?pp') |
    paste - <(find src -name '*.?pp') | sed -E "s#($named),?##g" | awk -F'\t' '$1 !~ /paper/ { print $2 }')
  [ "${#files[@]}" -gt 15 ] || fail "hardly any file found"
  found=$(long "${files[@]}")
  [ -z "$found" ] || fail "$found"

  cat >"$work/long.cpp" <<END
namespace a {
int f(int x,
      int y) {
$(lines '  ++x;' 38)
}

int g() {
$(lines '  ++x;' 38)
}

using b;
}
END
  [ "$(long "$work/long.cpp")" = "$work/long.cpp:2: int f(int x," ] || fail "found: $(long "$work/long.cpp")"
}

"$1"
