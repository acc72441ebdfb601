#!/usr/bin/env bash
# Whatever the chapters refer to is somewhere in them. The weaver finds this, too, and more; but it needs
# the data and the figures.
source tests/common.sh

# unknown FILE...: the references to sections, equations, figures, tables and chunks that are nowhere.
unknown() {
  perl -ne '
    push @{$places{$1}}, "$ARGV:$." while /\@((?:sec|eq|fig|tbl|lst):\w+(?:[:.\/-]\w+)*)/g;
    $known{$1} = 1 while /#((?:sec|eq|fig|tbl):[\w:.\/-]+)/g;
    $known{"lst:$1"} = 1 if /^\s*[`~]{3,} *\{.*?#([\w:.\/-]+)/ || /^\s*[`~]{3,} *\{.*?file=([\w:.\/-]+)/;
    close ARGV if eof;
    END { for (sort keys %places) { print "@{$places{$_}}: unknown reference \@$_\n" unless $known{$_} } }' "$@"
}

found=$(unknown paper/*.md)
[ -z "$found" ] || fail "$found"

cat >"$work/one.md" <<'END'
# Title {#sec:one}
See @sec:one, [@eq:two; @sec:three], @lst:part.
``` {.cpp #part file=src/a.cpp}
int a;  // @eq:four
```
$$ a $$ {#eq:two}
END
[ "$(unknown "$work/one.md" | sed 's|.*/||' | tr '\n' ';')" = 'one.md:4: unknown reference @eq:four;one.md:2: unknown reference @sec:three;' ] ||
  fail "found: $(unknown "$work/one.md")"
