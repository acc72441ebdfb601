#!/usr/bin/env bash
# weave_test.sh CASE: one case of the weaver, run in the project's folder. The cases are the functions
# below that begin with a capital; each writes its own small chapter, figures and data.
source tests/common.sh
source tests/report/weave.sh
cd "$work"
mkdir -p figures build/data build/figures

# A chapter from stdin, below a title.
chapter() {
  printf -- '---\ntitle: Title\n---\n\n' >one.md
  cat >>one.md
}

# A figure's three files.
draw() {
  echo 'plot sin(x)' >"figures/$1.gp"
  printf 'x,y\n1,2\n' >"build/data/$1.csv"
  cat >"build/figures/$1.svg" <<'END'
<?xml version="1.0" encoding="utf-8"  standalone="no"?>
<svg
 viewBox="0 0 600 400"
 xmlns="http://www.w3.org/2000/svg"
>
<title>x</title>
<desc>Produced by GNUPLOT 5.4 patchlevel 4 </desc>
<g id="gnuplot_canvas">
<rect x="0" y="0" width="600" height="400" fill="#ffffff"/>
<g fill="none" color="black" stroke="currentColor" stroke-width="0.80" stroke-linecap="round" stroke-linejoin="round">
<path stroke='black' d='M0,0 L2,2'/></g>
<polygon fill = 'rgb(  0, 158, 115)' points = '0,0 2,0 2,2 '/>
<polygon fill = 'rgb(  0, 158, 115)' points = '4,0 6,0 6,2 '/>
<polygon fill = 'rgb(  0, 114, 178)' points = '0,4 2,4 2,6 '/>
<path id='gpPt0' stroke='black' d='M0,0 L1,1'/><use xlink:href='#gpPt0' color='rgb(  0, 114, 178)'/>
</g></svg>
END
}

# expect_error 'words': the weaver stops with exactly this message and writes nothing.
expect_error() {
  local status=0
  weave page.html one.md 2>errors || status=$?
  [ $status -ne 0 ] || fail "status 0, expected: $1"
  grep -qxF -- "$1" errors || fail "said: $(cat errors); expected: $1"
  [ ! -e page.html ] || fail "a page was written"
}

# expect 'words'...: the page is woven and its text holds each of the words.
expect() {
  weave page.html one.md
  xmllint --noout page.html
  local text words
  text=$(sed '1,/<article/d; s/<[^>]*>//g; s/\xc2\xa0/ /g' page.html |
    tr -s '\n ' ' ')
  for words in "$@"; do
    [[ $text == *"$words"* ]] || fail "not in the page: $words; the page: $text"
  done
}

# expect_html 'part'...: the page holds each of the parts.
expect_html() {
  local part
  for part in "$@"; do grep -qF -- "$part" page.html || fail "not in the page: $part"; done
}

UnknownReference() {
  chapter <<<'See @eq:nowhere.'
  expect_error 'one.md:5: unknown reference @eq:nowhere'
}

UnknownReferenceInGroup() {
  chapter <<'END'
$$ a $$ {#eq:a}

See [@eq:a; @fig:nowhere].
END
  expect_error 'one.md:7: unknown reference @fig:nowhere'
}

UnknownReferenceInCode() {
  chapter <<'END'
``` {.cpp file=src/a.cpp}
int a;  // @eq:nowhere
```
END
  expect_error 'one.md:6: unknown reference @eq:nowhere'
}

UnknownChunk() {
  chapter <<<'See @lst:nowhere.'
  expect_error 'one.md:5: unknown reference @lst:nowhere'
}

TitleOfTwoChunks() {
  chapter <<'END'
``` {.cpp #first title="A title"}
int a;
```

``` {.cpp #second title="A title"}
int b;
```
END
  expect_error "one.md:9: the title 'A title' stands already at one.md:5"
}

UnknownCitation() {
  chapter <<<'See [@nobody1900].'
  expect_error '[WARNING] Citeproc: citation nobody1900 not found'
}

UnknownValue() {
  echo '{"known": "1.5"}' >build/data/values.json
  chapter <<<'It is `unknown`{.value}.'
  expect_error 'one.md:5: unknown value unknown'
}

UnknownValueInFormula() {
  echo '{"known": "1.5"}' >build/data/values.json
  chapter <<<'It is $\value{unknown}$.'
  expect_error 'one.md:5: unknown value unknown'
}

ValuesAreNotStrings() {
  echo '{"known": 1.5}' >build/data/values.json
  chapter <<<'It is `known`{.value}.'
  expect_error 'build/data/values.json: not one flat object of strings'
}

TexOutsideOfFormula() {
  chapter <<<'It is \nonsense{x} so.'
  expect_error 'one.md:5: \nonsense{x} stands outside of a formula'
}

BadFormula() {
  chapter <<<'It is $\nonsense$.'
  expect_error 'one.md:5: this formula cannot be written as MathML: \nonsense'
}

DuplicateId() {
  chapter <<'END'
$$ a $$ {#eq:a}

$$ b $$ {#eq:a}
END
  expect_error 'one.md:5: duplicate id eq:a'
}

NoAlternativeText() {
  draw f
  chapter <<<'![Caption.](figures/f.svg){#fig:f}'
  expect_error 'one.md:5: figure fig:f has no fig-alt text'
}

FigureWithoutId() {
  draw f
  chapter <<<'![Caption.](figures/f.svg){fig-alt="A curve"}'
  expect_error 'one.md:5: figure figures/f.svg is not written as ![...](figures/name.svg){#fig:id}'
}

MissingFigureFile() {
  local file
  chapter <<<'![Caption.](figures/f.svg){#fig:f fig-alt="A curve"}'
  for file in figures/f.gp build/figures/f.svg build/data/f.csv; do
    draw f
    rm "$file"
    expect_error "one.md:5: figure fig:f needs $file, which is missing"
  done
}

MissingTableData() {
  chapter <<'END'
::: {#tbl:t csv="t.csv"}
Caption.
:::
END
  expect_error 'one.md:5: table tbl:t needs build/data/t.csv, which is missing'
  sed -i 's|"t|"figures/measured/t|' one.md
  expect_error 'one.md:5: table tbl:t needs figures/measured/t.csv, which is missing'
}

AllMistakesAtOnce() {
  chapter <<<'See [@eq:first; @eq:second].'
  expect_error 'one.md:5: unknown reference @eq:first'
  expect_error 'one.md:5: unknown reference @eq:second'
}

NumbersAndReferences() {
  chapter <<'END'
# First {#sec:first}

## Inner {#sec:inner}

The formula
$$ a = b $$ {#eq:a paper=25}
and $$ c $$ {#eq:c paper="26–28"} are [@eq:a; @eq:c] in @sec:inner, [@sec:first; @sec:last; @eq:c].

# Last {#sec:last .appendix}

See @sec:last, @tbl:t.

| a |
|---|
| 1 |

: Some numbers {#tbl:t}
END
  expect '1 First' '1.1 Inner' '(1) [25]' '(2) [26–28]' 'are Eqs. (1) and (2) in Section 1.1,' \
    'Section 1, Appendix A and Eq. (2).' 'A Last' 'See Appendix A, Table 1.' 'Table 1. Some numbers'
  expect_html '<a href="#eq:a">(1)</a>' 'id="eq:a"' '<a href="#sec:last">' 'id="tbl:t"'
}

# A part has its name in the contents and before its first chapter, and no number goes by it.
PartsAreNamed() {
  chapter <<'END'
# First {#sec:first part="Part I. One"}

# Second {#sec:second}

# Third {#sec:third part="Part II. Two"}
END
  expect 'Part I. One 1 First 2 Second Part II. Two 3 Third'
  expect_html '<strong>Part I. One</strong>' '<div class="part-title">' '<strong>Part II. Two</strong>'
  ! grep -q 'data-part' page.html || fail "the attribute is left over"
}

# What browsers draw or break otherwise than it is meant is written so that they do not.
FormulasAreMended() {
  chapter <<'END'
By `--option`, `run --load 1`, `a-b`, 4 %, 5 m/s: $\sigma=+1$, $2\ell$, inline $\mathrm{Pe}\,f(x) = -\ln|x|$ and $\Bigl(\frac12\Bigr)^k$, and
$$ \begin{aligned} a &= \bigl[ b \bigr] \\ c &= (-1) + \left(\frac12\right) \end{aligned} $$
END
  weave page.html one.md
  expect_html '<code class="one">--option</code>' \
    '<code>run <span class="one">--load</span> 1</code>' '4 %, 5 m/s:' \
    '<mo>=</mo><mo form="prefix">+</mo><mn>1</mn>' '<mn>2</mn><mi>ℓ</mi>' '<code>a-b</code>' '<mi mathvariant="normal">Pe</mi>' \
    '<mo stretchy="false">(</mo><mi>x</mi><mo stretchy="false">)</mo>' \
    '<mo>=</mo><mo form="prefix">−</mo><mo lspace="0.167em" rspace="0">ln</mo>' \
    '<msup><mrow><mo minsize="1.8em"' '</math>,</span>' '<mtable class="aligned" displaystyle="true">' \
    '<mo mathsize="1.2em" stretchy="false" form="prefix">[</mo>' \
    '(</mo><mo form="prefix">−</mo><mn>1</mn>' '<mo stretchy="true">(</mo><mfrac>'
}

# Formulas that stand beside each other may stand below each other where there is less room.
FormulasBesideEachOther() {
  chapter <<'END'
$$ a = \{1\}, \qquad b = \left(\frac{1}{2}\right), \qquad \begin{aligned} c &= {d \qquad e} \\ &= f \qquad g \end{aligned} $$ {#eq:a}
END
  weave page.html one.md
  [ "$(grep -o '<math' page.html | wc -l)" = 3 ] || fail "not three formulas: $(grep -o '<math.*' page.html)"
  expect_html 'id="eq:a"'
}

# What Pandoc 3.10 writes for a formula becomes what is made of 2.17's, but for rows in rows.
FormulasOfLaterPandoc() {
  cat >later.lua <<'END'
local mathml = dofile(os.getenv("PAPER") .. "/mathml.lua")
local write, x, flat = pandoc.write, "<mi>x</mi>", '<mo stretchy="false" form="prefix">'
local later = {
  ["-x"] = "<mi>−</mi>" .. x,
  ["x=-x"] = x .. "<mo>=</mo><mi>−</mi>" .. x,
  ["|x|-x"] = flat .. "|</mo>" .. x .. flat .. "|</mo><mi>−</mi>" .. x,
  ["\\mathrm{Pe}x"] = '<mrow><mi mathvariant="normal">P</mi><mi mathvariant="normal">e</mi></mrow>' .. x,
  ["\\sin x"] = '<mrow><mi mathvariant="normal">sin</mi><mo>&#8289;</mo></mrow>' .. x,
  ["\\ln|x|"] = '<mi>ln</mi><mo>\u{2061}</mo>' .. flat .. "|</mo>" .. x .. flat .. "|</mo>",
  ["\\big[x\\big]"] = '<mo minsize="120%" maxsize="120%" stretchy="true" form="prefix">[</mo>' .. x ..
    '<mo minsize="120%" maxsize="120%" stretchy="true" form="postfix">]</mo>',
  ["\\Big[x\\Big]"] = '<mo minsize="180%" maxsize="180%" stretchy="true" form="prefix">[</mo>' .. x ..
    '<mo minsize="180%" maxsize="180%" stretchy="true" form="postfix">]</mo>',
}
local function without_rows(html)
  return (html:gsub("</?mrow>", ""))
end
function Pandoc()
  for tex, html in pairs(later) do
    pandoc.write = write
    local today = without_rows(mathml(tex, "InlineMath"))
    pandoc.write = function() return today:match("^<math.->") .. html .. "</math>" end
    local mended = without_rows(mathml(tex, "InlineMath"))
    if mended ~= today then io.stderr:write(tex, ": ", mended, " is not ", today, "\n") os.exit(1) end
  end
end
END
  PAPER=$paper pandoc -t plain -o /dev/null --lua-filter later.lua </dev/null || fail "see above"
}

# From Pandoc 3.8.2 on a table has its identifier before the filter sees it.
TablesOfLaterPandoc() {
  cat >later.lua <<'END'
function Table(t)
  if t.identifier ~= "" then return end
  local words = t.caption.long[1].content
  t.identifier = words[#words].text:match("^{#(.*)}$")
  words:remove()
  t.caption = { long = { pandoc.Plain(words) } }
  return t
end
END
  chapter <<'END'
| a | b |
|:--|--:|
| 1 | 2 |

: Some numbers. {#tbl:t}

See @tbl:t.
END
  weave today.html one.md
  weave later.html one.md --lua-filter later.lua
  cmp later.html today.html || fail "another page"
  grep -q 'id="tbl:t"' today.html || fail "the table has no identifier"
}

ValuesAreInjected() {
  echo '{"a": "1.5", "b": "-2", "c": "3\\cdot10^{-4}", "d": "say \"so\""}' >build/data/values.json
  chapter <<<'It is `a`{.value}, `b`{.value}, `c`{.value}, `d`{.value}, \value{a}, $x = \value{a}$.'
  expect 'It is 1.5, −2, 3⋅10−4, say "so", 1.5, x=1.5.'
}

# A number leads to the chunk that writes it, by its key or by the beginning or end of it.
ValuesLeadToTheirChunks() {
  echo '{"load": "1.5", "speed_6": "2", "steel_border": "3", "other": "4"}' >build/data/values.json
  chapter <<'END'
It is `load`{.value}, `speed_6`{.value}, \value{steel_border}, `other`{.value}.
A formula: $x=\value{load}$.

``` {.cpp #numbers title="Numbers"}
v["load"] = "other";
v["speed_" + key] = name;
```

These are the rest:

``` {.cpp #numbers title="More numbers"}
v[name + "_border"] = x;
```

``` {.cpp file=src/a.cpp title="A file"}
<<numbers>>
```
END
  expect 'It is 1.5, 2, 3, 4.'
  expect_html '<a title="load" href="#lst:numbers">1.5</a>' \
    '<a title="speed_6" href="#lst:numbers">2</a>' \
    '<a title="steel_border" href="#lst:numbers:2">3</a>, 4.' \
    'A formula: <span class="one"><a title="load" href="#lst:numbers"><math' '</math></a>.</span>'
  rm page.html
  chapter <<<'Two at a time, $x = \value{load} + \value{other}$.'
  expect_error 'one.md:5: a formula has two computed numbers, or stands alone: it can lead to neither chunk'
}

TableFromData() {
  printf 'Name $n$,Number\n"a, ""b"" and `c`, see @eq:e",-1\nplain,2e-3\nnone,–\np. 7,–\n' >build/data/t.csv
  chapter <<'END'
$$ e $$ {#eq:e}

::: {#tbl:t csv="t.csv"}
The *caption*.
:::
END
  expect 'Table 1. The caption.' 'Name n' 'a, “b” and c, see Eq. (1)' '−1' 'plain' '2·10−3' 'p. 7'
  expect_html '<td class="r">−1</td>' '<td class="r">–</td>' '<code>c</code>' '2·10<sup>−3</sup>'
  mkdir -p figures/measured
  sed 's/plain/other/' build/data/t.csv >figures/measured/t.csv
  sed -i 's|"t|"figures/measured/t|' one.md
  expect 'Table 1. The caption.' 'other'
  # What all rows of measured data share is told once.
  printf 'n,error,machine,date\n1,1e-8 to 1e-7,big,2026-11-23\n2,1.5e-09,big,2026-11-23\n' >figures/measured/t.csv
  expect 'Table 1. The caption. Machine big, date 2026‑11‑23.' '10−8 to 10−7' '1.5·10−9'
  if grep -E '>(big|machine)<' page.html; then fail 'columns that are the same in all rows'; fi
}

# Where rows are cards, each value has its column's name; one that is a number at the head of a card, too.
RowsMayBeCards() {
  printf 'a,b $x$,verdict\n1,2,holds\n' >build/data/t.csv
  chapter <<'END'
::: {#tbl:t .cards csv="t.csv"}
The caption.
:::

| symbol | value |
|:--|--:|
| a | 1 |

: Written. {#tbl:w .cards}
END
  expect 'Table 2. Written.'
  printf 'a $\\mathrm{Pe}$,$T^*_{\\max}$,tolerance\nx,2,1e-8 to 1e-7\n' >build/data/t.csv
  expect '10−8 to 10−7'
  expect_html '[id="tbl:t"] td:nth-child(1) { --column: "a Pe"; }' '[id="tbl:t"] td:nth-child(2) { --column: "Tmax*"; }' '<figure class="table cards" id="tbl:t">'
  printf 'a,b $x$,verdict\n1,2,holds\n' >build/data/t.csv
  expect 'Table 2. Written.'
  expect_html '<figure class="table cards" id="tbl:w">' '[id="tbl:w"] td:nth-child(2) { --column: "value"; }' \
    '<figure class="table cards by-number" id="tbl:t">' '[id="tbl:t"] td:nth-child(2) { --column: "b x"; }'
}

# A path keeps its corners and its ends, and no point that lies on the line; a label is one text; marks stand in
# groups; gnuplot's own name of a curve is left out.
DrawingsAreShort() {
  draw one
  sed -i "s|d='M0,0 L2,2'|d='M0,0 L1,1.02 L2,2 L3,0.5 L4,0.5 M7,7 L8,7 L9,7'|
    s|</g></svg>|<g transform=\"translate(1.04,1.96)\" stroke=\"none\" fill=\"currentColor\"  text-anchor=\"end\"><text><tspan> 5</tspan></text></g></g></svg>|
    s|<g fill=\"none\"|<title>one_plot_2a</title><title>curve</title>&|" build/figures/one.svg
  local mark="<use xlink:href='#gpPt0' transform='translate(10,5) scale(2.50)'"
  local green="$mark color='rgb(  0, 158, 115)'/>"
  sed -i "s|<polygon fill = 'rgb(  0, 114, 178)'|$mark/>\n${mark/10/20}/>$green$mark/>&|" build/figures/one.svg
  chapter <<'END'
![C.](figures/one.svg){#fig:one fig-alt="A"}
END
  expect 'Figure 1. C.'
  expect_html "d='m0 0 2 2 1-1.5 1 0m3 6.5 2 0'" '<text transform="translate(1.0,2.0)" text-anchor="end">5</text>' '<title>curve</title>'
  # marks of one scale and colour are one group, in the places where they were
  expect_html "<g transform='scale(2.50)'><use href='#one-p0' x='4.00' y='2.00'/><use href='#one-p0' x='8.00' y='2.00'/></g>" \
    "</g><g transform='scale(2.50)' color='var(--ink-009e73)'><use href='#one-p0' x='4.00' y='2.00'/></g><g transform='scale(2.50)'><use"
  ! grep -q one_plot_2a page.html || fail "gnuplot's name of a curve is in the page"
}

# The table of the paper's equations: by their numbers, with what became of them, their chunks and tests.
EquationsOfThePaper() {
  mkdir -p tests/a
  printf '\nTEST(%s) {\n}\n' 'A, B' 'A, C' 'D, E' >tests/a/test_a.cpp
  chapter <<'END'
# One {#sec:one}

::: {#tbl:e .equations}
All of them.
:::

$$ b $$ {#eq:b paper="2, 4–5" status=sign chunk="The second" tests="A.B, A.C"}

$$ a $$ {#eq:a paper=1}

$$ own $$ {#eq:own}

``` {.cpp #first title="The first"}
int a;
```

*Checked by* `D.E`, `A.B`, `A.C`.

# Two {#sec:two}

$$ c $$ {#eq:c paper=3}

``` {.cpp #second title="The second"}
int b;  // @eq:c
```
END
  expect '1(2)as printed⟨The first 1⟩D.E, A.B' '2, 4–5(1)sign corrected⟨The second 2⟩A.B, A.C' '3(4)as printed⟨The second 2⟩–'
  sed -i 's/status=sign/status=odd/' one.md
  rm page.html
  expect_error 'one.md:11: unknown status odd'
  sed -i 's/status=odd/status=sign/; s/"The second" tests/"The third" tests/' one.md
  expect_error 'one.md:11: no chunk has the title The third'
}

# A formula says what its symbols mean, as the table of symbols has it; a symbol of more meanings than one,
# or of one section, says nothing.
SymbolsSayWhatTheyMean() {
  chapter <<'END'
# One {#sec:one}

A $c_0$, a $\hat p$, $Q^*_1$, $n$, $z$ and $R + 1$.

$$ c_0 = R\,Q^* + n + z $$ {#eq:a}

| symbol | meaning |
|:--|:--|
| $c_0$ | border over $a$, @eq:a |
| $Q^*$, $R$ | load; radius "R" |
| $\hat p$ | factor |
| $n$ | nodes |
| $n$ | unknowns |
| $z$ | in @sec:one, distance |

: Symbols. {#tbl:nomenclature}
END
  weave page.html one.md
  xmllint --noout page.html
  expect_html '<span title="border over a"><math' '<span title="factor"><math' '<span title="load"><math' \
    '<span title="c₀ border over a; R radius “R”; Q* load"><math display="block"'
  [ "$(sed '/<table/,$d' page.html | grep -o '<span title=' | wc -l)" = 5 ] || fail "other titles: $(grep -o '<span title="[^"]*"' page.html)"
}

# What a cell or a title holds is read as text and formulas, never as HTML.
CellsBringNoHtml() {
  cat >build/data/t.csv <<'END'
<b>Name</b>,Text
<script>alert(1)</script>,<img src=x onerror=alert(1)>
<div>,`<i>x</i>`{=html}
[x]{onclick="alert(1)"},a < b & c > d
<span onclick="alert(1)">y</span>,<div onclick="alert(1)">z</div>
END
  chapter <<'END'
::: {#tbl:t csv="t.csv"}
The caption.
:::

``` {.cpp #part title="A <b>bold</b> title"}
int a;
```
END
  expect '&lt;b&gt;Name&lt;/b&gt;' '&lt;script&gt;alert(1)&lt;/script&gt;' '&lt;img src=x onerror=alert(1)&gt;' \
    '&lt;div&gt;' 'a &lt; b &amp; c &gt; d' 'A &lt;b&gt;bold&lt;/b&gt; title'
  local part
  for part in '<script' '<img' '<b>' '<i>x' 'onclick="'; do
    if sed '1,/<article/d' page.html | grep -F -- "$part"; then fail "HTML from the data: $part"; fi
  done
}

# In attributes every character of HTML's own is written out.
AttributesAreEscaped() {
  draw f
  chapter <<'END'
![One.](figures/f.svg){#fig:f fig-alt="p < 2 & \"q\" > 1"}

$$ a $$ {#eq:a paper=2<3&4}

``` {.cpp file="src/a<b&.cpp"}
int a;
```
END
  weave page.html one.md
  xmllint --noout page.html
  expect_html 'aria-label="p &lt; 2 &amp; &quot;q&quot; &gt; 1"' 'title="Equation (2&lt;3&amp;4) of the paper">[2&lt;3&amp;4]<' \
    'id="file:src/a&lt;b&amp;.cpp"' 'href="#file:src/a&lt;b&amp;.cpp"><code>src/a&lt;b&amp;.cpp</code>' \
    'id="lst:src/a&lt;b&amp;.cpp"'
  # A file of one chunk stands once, in its chunk.
  expect_html '<p class="file" id="file:src/a&lt;b&amp;.cpp">' '>whole in '
  [ "$(grep -c 'a;$' page.html)" -eq 1 ] || fail "the file stands twice"
}

FiguresKeepTheirIdsApart() {
  draw f
  draw g
  chapter <<'END'
![One.](figures/f.svg){#fig:f fig-alt="A curve & more"}

![Two.](figures/g.svg){#fig:g fig-alt="Another"}
END
  expect 'Figure 1. One. script data' 'Figure 2. Two. script data' 'plot sin(x)'
  expect_html 'aria-label="A curve &amp; more"' "id='f-p0'" "href='#f-p0'" "id='g-p0'" \
    "stroke='currentColor'" "color='var(--ink-0072b2)'" "<g><path d='m0 0 2 2'/></g>" \
    "<path fill = 'var(--ink-009e73)' d='m0 0 2 0 0 2m2-2 2 0 0 2'/><path fill = 'var(--ink-0072b2)' d='m0 4 2 0 0 2'/>" \
    'viewBox="0 0 600 400" fill="none" stroke="currentColor" stroke-width="0.8" stroke-linecap="round"' 'id="script:f"' \
    'download="f.csv.xz"'
  if grep -q 'fill="#ffffff"' page.html; then fail "the white ground is still there"; fi
}

# A figure's data unpack to the file itself, whatever its bytes and their number, and are packed to the
# same bytes another time, under another name.
DataUnpackToTheFile() {
  local bytes link
  draw f
  chapter <<<'![One.](figures/f.svg){#fig:f fig-alt="A curve"}'
  for bytes in 0 1 2 3000; do
    { printf 'x,y\n'; head -c "$bytes" /dev/urandom; } >build/data/f.csv
    weave page.html one.md
    link=$(grep -o 'data:application/x-xz;base64,[^"]*' page.html)
    base64 -d <<<"${link#*,}" | xz -d | cmp - build/data/f.csv || fail "$bytes bytes are others"
    cp build/data/f.csv other.csv
    touch -d 2001-02-03 other.csv
    [ "$(xz -9e -T1 -c other.csv | base64 -w0)" = "${link#*,}" ] || fail "a name or a time is packed"
  done
}

# Keywords, types and comments have tags of one letter; what HTML can read as it is stays as it is.
CodeHasShortTags() {
  chapter <<'END'
``` {.cpp #part}
int a;  // one
if (a > 1) return "two";
b[c[0]]>d;
```
END
  weave page.html one.md
  xmllint --noout page.html
  expect_html '<u>int</u> a;  <i>// one</i>' '<b>if</b> (a > 1) <b>return</b> "two";' 'b[c[0]]&gt;d;'
  if grep -q '<span class="..">' page.html; then fail "a span of Pandoc's is left"; fi
}

ChunksAreLinked() {
  chapter <<'END'
$$ e $$ {#eq:e}

``` {.cpp file=src/a.cpp title="The file"}
int a;
  <<part>>
```

``` {.cpp #part title="A part of $x$"}
int b;  // @eq:e
```

``` {.cpp #part}
int c;
  <<inner>>
  <<next>>
```

``` {.cpp #next title="Next"}
int e;
```

``` {.cpp #inner title="Within"}
int d;
```

See @lst:part.
END
  expect '⟨A part of x 2⟩part 1 of 2 ↓' '⟨A part of x 2⟩part 2 of 2 ↑' 'used in ⟨The file 1⟩' \
    'file src/a.cpp · in one.md:8' 'int b; // Eq. (1)' 'See ⟨A part of x 2⟩.' \
    'src/a.cpp 5 lines from one.md'
  expect_html 'id="lst:part"' '  <a href="#lst:next">' 'id="lst:part:2"' 'href="#lst:part:2"' 'id="file:src/a.cpp"' \
    '<details class="expand" style="--indent:2"><summary><a href="#lst:inner">' '  <a href="#lst:part">'
}

# Each test stands once, folded, with what is said above it, whether it is in C++, a script or Python.
TestsAreFolded() {
  mkdir -p tests/a
  printf 'int x;\n\n// It is so.\nTEST(A, One) {\n  EXPECT_LT(1, 2);\n}\n\nTEST(A, Two) {\n}\n' >tests/a/test_a.cpp
  printf '  thermoroll_script_tests(B label b_test.sh)\nthermoroll_script_test(C.Whole label whole.sh)\nadd_test(NAME Dd.Command\n         COMMAND true)\n' >tests/a/CMakeLists.txt
  printf '#!/bin/sh\nShell() {\n  true\n}\nPython() { run "${FUNCNAME[0]}" x; } # slow\n' >tests/a/b_test.sh
  printf 'def Python(x):\n    assert x\n\n    assert not False\n\n\ndef Other():\n    pass\n' >tests/a/b_test.py
  printf '#!/bin/sh\n# All of it.\ntrue\n' >tests/a/whole.sh
  printf '// Any bytes.\nint LLVMFuzzerTestOneInput() {}\n' >tests/a/bytes.cpp
  chapter <<'END'
# First {#sec:first}

*Checked by* `A.One`, `A.None`.

*Checked by* `A.One`.

| a |
|---|
| `A.Two` |

# Second {#sec:second}

*Checked by* `A.One`, `A.Two`, `B.Shell`, `B.Python`, `C.Whole`, `Dd.Command`, `Fuzz.Bytes`.
END
  expect 'Checked by A.One, A.None. // tests/a/test_a.cpp: ctest --test-dir build/release -R A.One // It is so. TEST(A, One) { EXPECT_LT(1, 2); } Checked by A.One.' \
    'Dd.Command, Fuzz.Bytes. // tests/a/test_a.cpp: ctest --test-dir build/release -R A.Two TEST(A, Two) { } # tests/a/b_test.sh:' \
    '-R B.Shell Shell() { true } # tests/a/b_test.py:' '-R B.Python def Python(x): assert x assert not False # tests/a/whole.sh:' \
    '-R C.Whole # All of it. true # tests/a/CMakeLists.txt:' '-R Dd.Command add_test(NAME Dd.Command COMMAND true) // tests/a/bytes.cpp:' \
    '-R Fuzz.Bytes // Any bytes. int LLVMFuzzerTestOneInput() {}'
  expect_html 'href="#test:A.One"><code>A.One</code></a>' 'href="#test:A.Two"><code>A.<wbr/>Two</code></a>' 'id="test:A.One"' 'EXPECT_LT(1, 2);'
  [ "$(grep -o 'id="test:[^"]*"' page.html | sort | uniq -d | wc -l)" = 0 ] || fail "a test is folded twice"
}

# A cell of data leads to a part of a chunk by its title, and to a test that is folded.
CellsLeadToChunksAndTests() {
  mkdir -p tests/a
  printf 'int x;\n\nTEST(Suite, Name) {\n}\n' >tests/a/test_a.cpp
  chapter <<'END'
# First {#sec:first}

::: {#tbl:t csv="t.csv"}
Caption.
:::

``` {.cpp #parts title="The first part"}
int a;
```

``` {.cpp #parts title="The second part"}
int b;
```

*Checked by* `Suite.Name`.
END
  printf 'a,evidence\n1,[code](<#chunk:The second part>) [test](#test:Suite.Name)\n' >build/data/t.csv
  weave page.html one.md
  expect_html '<span class="sources"><a href="#lst:parts:2">code</a></span>' \
    '<span class="sources">, <a href="#test:Suite.Name">test</a></span>'
  rm page.html
  sed -i 's/The second part/The third part/' build/data/t.csv
  expect_error 'no chunk has the title The third part'
  sed -i 's/The third part/The second part/; s/Suite.Name/Suite.Other/' build/data/t.csv
  expect_error 'the test Suite.Other is led to, but not folded into a chapter'
}

# A chunk is folded to its title, unless it is the first behind a numbered equation of its section or
# says that it is open.
ChunksAreFolded() {
  chapter <<'END'
# One {#sec:one}

$$ e $$ {#eq:e}

Words and $$ f $$ without a number.

``` {.cpp #equation title="Is the equation"}
int a;
```

``` {.cpp #second title="Follows it"}
int b;
```

$$ g $$ {#eq:g}

# Two {#sec:two}

``` {.cpp #elsewhere title="Another section"}
int c;
```

``` {.cpp #wanted .open title="Is open"}
int d;
```
END
  weave page.html one.md
  expect_html '<details id="lst:equation" open="">' '<details id="lst:second">' \
    '<details id="lst:elsewhere">' '<details id="lst:wanted" open="">'
}

PartsHaveTheirTitles() {
  chapter <<'END'
``` {.cpp file=src/a.cpp title="The file"}
<<both>>
```

``` {.cpp #both title="The first"}
int a;
<<inner>>
```

``` {.cpp #both title="The second"}
int b;
```

``` {.cpp #inner title="Inner"}
int c;
```

See @lst:both.
END
  expect '⟨The first 2.1⟩⟨both 2⟩ += part 1 of 2 ↓' '⟨The second 2.2⟩⟨both 2⟩ += part 2 of 2 ↑' \
    'used in ⟨The first 2.1⟩' 'See ⟨both 2⟩.' '⟨The first 2.1⟩, ⟨The second 2.2⟩'
  expect_html '<details id="lst:both:2"'
}

# A draft is one chapter with the numbers that it has in the whole. It tells of its own mistakes only,
# and is written with them.
DraftIsOneChapter() {
  cat >two.md <<'END'
# Second {#sec:second}

$$ b $$ {#eq:b}

See @eq:a, @eq:b and @eq:nowhere in @sec:second after @sec:first.

``` {.cpp #part}
int b;
<<nowhere>>
```
END
  chapter <<'END'
# First {#sec:first}

$$ a $$ {#eq:a}

![Not drawn.](figures/f.svg){#fig:f fig-alt="A curve"}

``` {.cpp file=src/a.cpp}
int a;
<<part>>
```
END
  weave page.html one.md two.md -M draft=two.md 2>errors || fail "stopped: $(cat errors)"
  printf 'two.md:%s\n' '9: missing chunk <<nowhere>>' '5: unknown reference @eq:nowhere' | diff - errors || fail "other mistakes"
  local text
  text=$(sed '1,/<article/d; s/<[^>]*>//g; s/\xc2\xa0/ /g' page.html | tr -s '\n ' ' ')
  [ "$text" = ' 2 Second b (2) See Eq. (1), Eq. (2) and in Section 2 after Section 1. ⟨part 2⟩ int b; &lt;&lt;nowhere>> used in ⟨src/a.cpp 1⟩ · in two.md:8 ' ] ||
    fail "the page: $text"
}

# The short version has what is marked, under its headings, without chunks and what leads to them; its
# numbers are its own, and links to the rest lead into the report.
ShortVersion() {
  chapter <<'END'
# First {#sec:first}

Left out. $$ a $$ {#eq:a}

# Second {#sec:second part="Part II. Two"}

## Inner {#sec:inner .paper}

See @eq:a, @eq:b, [@eq:a; @eq:b], @sec:first and @lst:part. $$ b $$ {#eq:b}

This is the chunk:

``` {.cpp #part title="A part"}
int a;
```

*Checked by* `A.B`.

::: {.report}
Report only.
:::

::: {.paper-only .brief}
Paper only.
:::

## Other {#sec:other}

Left out as well.

::: {.paper}
In both.
:::
END
  sed -i 's/^title: Title/title: Title\nabstract: All of it\nabstract-short: Part of it/' one.md
  expect '1 First Left out. a (1)' 'Part II. Two 2 Second 2.1 Inner See Eq. (1), Eq. (2), Eqs. (1) and (2), Section 1 and ⟨A part 1⟩.' \
    'Report only.' 'In both.'
  if grep -q 'Paper only\|Part of it' page.html; then fail "what is for the short version is in the report"; fi
  expect_html 'All of it'
  weave page.html one.md -M paper=yes
  xmllint --noout page.html
  local text
  text=$(sed '1,/<article/d; s/<[^>]*>//g; s/\xc2\xa0/ /g' page.html | tr -s '\n ' ' ')
  text=${text%% Colophon*}
  [ "$text" = ' 1 Second 1.1 Inner See Eq. (1) of the report, Eq. (1), Eq. (1) of the report and Eq. (1), Section 1 of the report and ⟨A part 1⟩. b (1) Paper only. 1.2 Other In both.' ] ||
    fail "the page: $text"
  if grep -q 'All of it' page.html; then fail "the abstract of the report is in the short version"; fi
  [ "$(xmllint --xpath "count(//*[@id='text']/*[local-name()='section'][*[local-name()='h2']])" page.html)" = 2 ] ||
    fail "chapter and colophon are no sections of their own"
  expect_html 'Part of it' '<div class="brief">' 'href="report.html#eq:a"' 'href="#eq:b"' 'href="report.html#lst:part"'
}

WovenTwiceAlike() {
  draw f
  chapter <<'END'
![One.](figures/f.svg){#fig:f fig-alt="A curve"}

``` {.cpp file=src/a.cpp}
<<one>>
<<two>>
```

``` {.cpp #one}
int b;
```

``` {.cpp #two}
int c;
```
END
  weave page.html one.md
  weave again.html one.md
  cmp page.html again.html
}

# Colours are kept from one report to the next, and made anew where the code is another.
ColoursAreKept() {
  chapter <<'END'
# Code {#sec:code}

The code:

``` {.cpp file=src/a.cpp title="All"}
int first;
```
END
  weave page.html one.md
  local kept=build/colours-cpp
  [ -s $kept ] || fail "nothing is kept"
  mv page.html before.html
  weave page.html one.md
  cmp page.html before.html || fail "the colours that were kept make another page"
  sed -i 's/first/other/' $kept
  weave page.html one.md
  grep -q 'other' page.html || fail "what was kept is not used"
  sed -i 's/int first;/int third;/' one.md
  weave page.html one.md
  grep -q 'third' page.html && ! grep -q 'other' page.html || fail "another code has the colours of the first"
}

# So are drawings, until their lines or their text are others. A draft makes none of another chapter's.
DrawingsAreKept() {
  draw f
  chapter <<<$'# One {#sec:one}\n\n![One.](figures/f.svg){#fig:f fig-alt="A curve"}'
  weave page.html one.md
  local kept=build/drawing-f
  [ -s $kept ] || fail "nothing is kept"
  mv page.html before.html
  weave page.html one.md
  cmp page.html before.html || fail "the drawing that was kept makes another page"
  sed -i 's/<path/<path class="kept"/' $kept
  weave page.html one.md
  grep -q 'class="kept"' page.html || fail "what was kept is not used"
  sed -i 's/L2,2/L2,3/' build/figures/f.svg
  weave page.html one.md
  ! grep -q 'class="kept"' page.html || fail "another drawing is shown as the first"
  sed -i 's/A curve/A line/' one.md
  weave page.html one.md
  expect_html 'aria-label="A line"'
  rm $kept
  printf '# Two {#sec:two}\n\nAs in @fig:f.\n' >two.md
  weave page.html one.md two.md -M draft=two.md
  expect_html '<a href="#fig:f">Figure 1</a>'
  [ ! -e $kept ] || fail "a draft makes the drawing of another chapter"
}

# A browser looks for what :has() names again whenever it may have come or gone. In all of the page that is a
# third of a second at each stroke of a live drawing.
StyleLooksThroughNoWholePage() {
  ! grep -nE '(^|[ ,}])(:root|html|body|main|article|#text|\*)[^ ,{>]*:has\(' "$OLDPWD/paper/style.css" ||
    fail "a selector that looks through the whole page"
}

SolverHasItsPlacesOrASentence() {
  chapter <<'END'
# Page {#sec:page}

::: {.screen}
Drag it here:
:::

::: {.live views="contact"}
A small place.
:::

::: {.live large="yes" views="contact time"}
The large place.
:::
END
  weave page.html one.md
  grep -q 'This page was made without the solver' page.html || fail "nothing says that there is none"
  ! grep -qE 'Drag it here|A small place|The large place' page.html || fail "a place is left"
  weave page.html one.md -M live=yes
  local part
  for part in 'Drag it here' 'data-views="contact"' 'data-large="yes"' 'wasm-unsafe-eval'; do
    grep -q "$part" page.html || fail "not in the page: $part"
  done
}

"$1"
