#!/usr/bin/env bash
# report_test.sh CASE BUILD: one promise of build/report.html, run in the project's folder. The cases
# are the functions below that begin with a capital.
source tests/common.sh
source tests/report/weave.sh
report="$PWD/build/report.html"
[ -s "$report" ] || fail "no $report: run make report"
build=$2

# xpath EXPRESSION: what it selects, one a line; nothing selected is no error.
xpath() { xmllint --xpath "$1" "$report" 2>"$work/errors" || grep -q 'set is empty' "$work/errors"; }

attributes() { xpath "$1" | sed -n 's/^ *[a-z:]*="\(.*\)"$/\1/p'; }

# The words of the page outside of code and the style sheet.
prose() {
  xpath "//text()[not(ancestor::*[local-name()='code' or
    local-name()='style' or local-name()='pre'])]"
}

expect_none() { [ -z "$1" ] || fail "$2: $1"; }

IsWellFormed() { xmllint --noout "$report"; }

IdsAreUnique() {
  attributes '//@id' >"$work/ids"
  [ -s "$work/ids" ] || fail "no ids found"
  expect_none "$(sort "$work/ids" | uniq -d)" "ids that stand twice"
}

LinksResolve() {
  attributes '//@id' | sort -u >"$work/ids"
  attributes "//@*[local-name()='href'][starts-with(., '#')]" | sed 's/^#//' | sort -u >"$work/links"
  [ -s "$work/links" ] || fail "no links found"
  expect_none "$(comm -13 "$work/ids" "$work/links")" "links to nothing"
}

FetchesNothing() {
  expect_none "$(xpath "//*[local-name()='script'][@src] | //*[local-name()='link' or local-name()='img' or
    local-name()='iframe' or local-name()='object']")" "elements that fetch"
  expect_none "$(xpath "//*[local-name()='meta'][@http-equiv='Content-Security-Policy']" | grep -v "default-src 'none'")" \
    "a policy that lets the page fetch"
  [ "$(xpath "count(//*[local-name()='meta'][@http-equiv='Content-Security-Policy'])")" = 1 ] || fail "no policy"
  expect_none "$(xpath "//@*[local-name()='href'][not(parent::*[local-name()='a'])]
    [not(starts-with(., '#') or starts-with(., 'data:'))]")" "pictures that are fetched"
  expect_none "$(attributes '//@src | //@srcset | //@poster | //@action')" "attributes that fetch"
  expect_none "$(xpath "//@*[contains(., '://')][not(starts-with(., 'data:'))][not(local-name()='href' and parent::*[local-name()='a'])]")" \
    "addresses outside of links"
  expect_none "$(grep -noP '@import|url\((?!.?(data:|#))[^)]{0,80}' "$report" | head)" "style that fetches"
}

NothingIsLeftOver() {
  prose >"$work/prose"
  [ "$(wc -w <"$work/prose")" -gt 2000 ] || fail "hardly any prose found"
  expect_none "$(grep -nF -e '??' -e '{#' -e '$$' -e '\value' -e '{.' -e ':::' "$work/prose")" "left over"
  expect_none "$(grep -nE '@(eq|fig|tbl|sec|lst):' "$work/prose")" "unresolved references"
  expect_none "$(grep -nF '\value' "$report")" "values not injected"
}

DrawingsAreDescribed() {
  local drawn described script
  drawn=$(xpath "count(//*[local-name()='svg'])")
  described=$(xpath "count(//*[local-name()='svg'][@role='img'][string-length(@aria-label) > 20])")
  [ "$drawn" -gt 0 ] && [ "$drawn" = "$described" ] || fail "$drawn drawings, $described described"
  attributes '//@id' >"$work/ids"
  for script in figures/*.gp; do
    grep -qxF "script:$(basename "$script" .gp)" "$work/ids" || fail "$script is not listed"
    [ "$(basename "$script")" = style.gp ] || grep -qF "make build/figures/$(basename "$script" .gp).svg" "$report" || fail "nothing tells how $script is drawn"
  done
}

# A mouse over a curve shows its name, in words and not as a key of the data.
CurvesAreNamedInWords() {
  xpath "//*[local-name()='svg']//*[local-name()='title']/text()" >"$work/names"
  [ -s "$work/names" ] || fail "no names found"
  expect_none "$(grep _ "$work/names")" "names that are no words"
}

# The numbers that installed headers print are those of the report, for all equations, tables and sections.
NumbersOfInstalledHeaders() {
  perl -0777 -ne '
    print "$1 ($2)\n" while /id="(eq:[^"]*)" class="equation".*?class="number">\((\d+)\)/gs;
    print "$1 Table $2\n" while /<figure[^>]* id="(tbl:[^"]*)".*?<strong>Table.(\d+)/gs;
    while (/<h\d[^>]*id="(sec:[^"]*)"[^>]*><span class="no">([^<]*)/g) {
      my ($id, $number) = ($1, $2);
      print "$id ", ($number =~ /^\d/ ? "Section" : "Appendix"), " $number\n";
    }' "$report" | sort >"$work/expected"
  [ "$(wc -l <"$work/expected")" -gt 400 ] || fail "hardly any numbers found"
  mkdir "$work/from"
  cut -d' ' -f1 "$work/expected" | sed 's/.*/& @& /' >"$work/from/all.hpp"
  cmake -Dchapters=paper "-Dfrom=$work/from" "-Dto=$work/to" -P paper/references.cmake
  sed 's/ of the report $//' "$work/to/all.hpp" | diff "$work/expected" - || fail "the report has other numbers"
}

# The table of the paper's equations has all of them, 1 to 51, and most have a chunk and a test.
EveryEquationOfThePaperIsListed() {
  local rows="//*[@id='tbl:equations']//*[local-name()='tr'][*[local-name()='td']]" number
  xpath "$rows/*[1]/text()" | tr -d ' ' | tr ',' '\n' | awk -F– '{ for (k = $1; k <= ($2 ? $2 : $1); ++k) print k }' |
    sort -nu >"$work/numbers"
  seq 51 | diff - "$work/numbers" || fail "not the equations 1 to 51"
  for number in 4 5; do
    [ "$(xpath "count($rows[*[$number] != '–'])")" -gt 15 ] || fail "hardly any evidence in column $number"
  done
}

FormulasAreMathML() {
  [ "$(xpath "count(//*[local-name()='math'])")" -gt 200 ] || fail "hardly any formula found"
  expect_none "$(xpath "//*[contains(@class, 'math inline') or contains(@class, 'math display')]")" \
    "formulas left as TeX"
}

# Each character of a formula is one that the font keeps.
FontHasEveryCharacter() {
  xpath "//*[local-name()='math']//text()" |
    perl -CS -e '
      my %kept;
      open my $list, "<", "paper/math-characters.txt" or die;
      while (<$list>) {
        next if /^#/;
        chomp;
        for (split /,/) {
          my ($from, $to) = split /-/;
          $kept{$_} = 1 for hex($from) .. hex($to // $from);
        }
      }
      my %lacking;
      while (<STDIN>) { chomp; for (split //) { $lacking{$_} = 1 unless $kept{ord $_} } }
      printf "%s (%04X)\n", $_, ord $_ for sort keys %lacking;' >"$work/lacking"
  expect_none "$(cat "$work/lacking")" "characters that the font lacks"
  [ "$(grep -c 'font/woff2;base64,[A-Za-z0-9]' "$report")" = 1 ] || fail "the font is not in the page"
  [ "$(wc -c <build/math.woff2)" -lt 185000 ] || fail "the font takes more than 250 kB of the page"
}

# Formulas say what their symbols mean, and take little room for it.
SymbolsSayWhatTheyMean() {
  attributes "//*[local-name()='span'][*[local-name()='math']]/@title" >"$work/titles"
  [ "$(wc -l <"$work/titles")" -gt 500 ] || fail "hardly any formula says what its symbols mean"
  [ "$(wc -c <"$work/titles")" -lt 150000 ] || fail "the meanings take $(wc -c <"$work/titles") bytes"
  grep -q 'load ratio' "$work/titles" || fail "nothing says what the load ratio is"
}

SizeIsBounded() {
  local size
  size=$(wc -c <"$report")
  [ "$size" -lt 6300000 ] || fail "the report has $size bytes"
}

# The short version: no code, about ten figures, and each link leads into it or into the report.
ShortVersionLeadsIntoTheReport() {
  attributes '//@id' | sort -u >"$work/report-ids"
  report="$PWD/build/paper.html"
  xmllint --noout "$report"
  attributes '//@id' | sort >"$work/ids"
  expect_none "$(uniq -d "$work/ids")" "ids that stand twice"
  attributes "//@*[local-name()='href'][starts-with(., '#')]" | sed 's/^#//' | sort -u >"$work/links"
  expect_none "$(comm -13 "$work/ids" "$work/links")" "links to nothing"
  attributes "//@*[local-name()='href'][starts-with(., 'report.html#')]" | sed 's/^[^#]*#//' | sort -u >"$work/links"
  [ "$(wc -l <"$work/links")" -gt 10 ] || fail "hardly any link into the report"
  expect_none "$(comm -13 "$work/report-ids" "$work/links")" "links to what the report has not"
  expect_none "$(xpath "//*[starts-with(@id, 'lst:') or @class='checked']")" "chunks or tests"
  local figures
  figures=$(xpath "count(//*[local-name()='svg'])")
  [ "$figures" -ge 8 ] && [ "$figures" -le 12 ] || fail "$figures figures"
}

# Every command of the reviewers' table prints what stands beside it.
ReviewersCommandsPrintThis() {
  count=0
  while IFS=$'\t' read -r command expected; do
    status=0
    bash -c "$command" >"$work/out" 2>&1 || status=$?
    [ "$status" = "$(grep -F -- "$command\`" paper/08-results.md | grep -q 'status 2' && echo 2 || echo 0)" ] || fail "'$command' ends with status $status"
    grep -qF -- "$expected" "$work/out" || fail "'$command' does not print '$expected': $(cat "$work/out")"
    count=$((count + 1))
  done < <(awk -F'`' '/^### For reviewers/ { on = 1 } /#tbl:reviewers/ { on = 0 }
    on && /^\| / && NF == 5 { print $2 "\t" $4 }' paper/08-results.md)
  [ "$count" -eq 9 ] || fail "$count commands in the table"
}

NamedTestsExist() {
  xpath "//*[@class='checked']//*[local-name()='code'][not(ancestor::*[local-name()='pre'])]" | sed 's/<[^>]*>/\n/; s/<wbr *\/>//g; s/<[^>]*>/\n/g' | grep . | sort -u >"$work/named"
  [ "$(wc -l <"$work/named")" -gt 10 ] || fail "hardly any test is named"
  ctest --test-dir "$build" -N | sed -n 's/^ *Test *#[0-9]*: //p' | sort -u >"$work/tests"
  expect_none "$(comm -23 "$work/named" "$work/tests")" "tests that do not exist"
}

# words FILE: the text of a page.
words() { sed 's/<[^>]*>//g' "$1"; }

# named: the values that the chapters name for the report, KEY once for each time.
named() { sed '/^abstract-short:/,/^[^ ]/{/^abstract-short:/d;/^ /d}; /^::: {\.paper-only/,/^:::$/d' paper/*.md | grep -oE '\\value\{[a-z0-9_]+\}|`[a-z0-9_]+`\{\.value\}' | grep -oE '[a-z0-9_]{2,}' | grep -vx value; }

# Each value in turn is given a number that is nowhere else, with its sign and with what stands about
# it kept. The page must show that number, to the last digit, as often as the chapters name the value.
ValuesStandAsWritten() {
  local key sign number times
  local -A shown
  mkdir -p "$work/project/build"
  cp -r paper figures tests "$work/project/"
  cp -r build/data build/figures build/colours-* build/drawing-* "$work/project/build/" # the code is that of the report
  for file in values speed study-values evaluations; do
    awk -F'"' -v OFS='"' -v first=$(case $file in values) echo 71001 ;; speed) echo 81001 ;; evaluations) echo 61001 ;; *) echo 91001 ;; esac) '
      NF > 4 {
        number = first + NR ".6543"
        if (!sub(/[0-9]+([.][0-9]+)?/, number, $4)) $4 = $4 " " number
        print $2, ($4 ~ /^[$]?-/ ? "−" : ""), number >"/dev/stderr"
      }
      { print }' "build/data/$file.json" >"$work/project/build/data/$file.json" 2>>"$work/numbers"
  done
  (cd "$work/project" && weave ../page.html paper/*.md)
  # Each number of the page, and each with a minus also without it.
  while read -r times number; do shown[$number]=$times; done < <(words "$work/page.html" | grep -oE '−?[0-9]{5,}[.]6543' |
    awk '{ ++count[$0] } sub(/^−/, "") { ++count[$0] } END { for (number in count) print count[number], number }')
  named | sort | uniq -c >"$work/named"
  [ "$(wc -l <"$work/named")" -gt 50 ] || fail "hardly any value is named"
  while read -r times key; do
    IFS='"' read -r _ sign number < <(grep "^$key\"" "$work/numbers") || fail "no value $key"
    [ "${shown[$sign$number]:-0}" = "$times" ] ||
      fail "$key is named $times times, and $sign$number shown ${shown[$sign$number]:-0} times"
  done <"$work/named"
}

# Each of them leads to the chunk that writes it, whether it stands in a formula or not.
NumbersLeadToTheirChunks() {
  local times key found
  named | sort | uniq -c >"$work/named"
  [ "$(wc -l <"$work/named")" -gt 50 ] || fail "hardly any value is named"
  while read -r times key; do
    found=$(grep -oF "<a title=\"$key\" href=\"#lst:" "$report" | wc -l)
    [ "$found" = "$times" ] || fail "$key is named $times times, and leads to a chunk $found times"
  done <"$work/named"
}

# told WORD: what the colophon tells behind it.
told() { sed -n 's|<[^>]*>||g; s|.*Woven by Pandoc.* '"$1"' \([^ ]*\)\..*|\1|p' "$report"; }

# The first screen tells day and revision as the colophon does, and leads to all else there is.
FrontLeadsOn() {
  local front revision=$(told Revision) date=$(told Date) target
  front=$(sed -n '/<header id="top">/,/<article/p' "$report")
  [ -z "$revision" ] || [[ $(sed 's/<[^>]*>//g' <<<"$front") == *" · $date · revision $revision"* && $date =~ ^20..-..-..$ ]] || fail "neither date nor revision: $front"
  for target in paper.html report.pdf paper.pdf '#tbl:claims' '#tbl:reference-values' '#index-of-files'; do
    [[ $front == *"href=\"$target\""* ]] || fail "no link to $target"
  done
  local abstract=${front#*aria-label=\"Abstract\"}
  [ "$(sed 's/<[^>]*>//g' <<<"${abstract%%</section>*}" | wc -w)" -lt 110 ] || fail "the abstract is long"
}

# Of the three paragraphs on what was found each leads to a section, to code and to a test.
FindingsLeadToTheirEvidence() {
  local kind link
  for kind in What\ {holds,does\ not,is\ new}; do
    for link in "starts-with(@href, '#sec:')" "starts-with(@href, '#lst:') and . = 'code'" "starts-with(@href, '#test:') and . = 'test'"; do
      [ "$(xpath "count(//*[@class='brief']/*[starts-with(., '$kind.')]//*[local-name()='a'][$link])")" -gt 0 ] ||
        fail "'$kind' has no link that $link"
    done
  done
}

# Each row of the table of claims leads to a section, a chunk and a test that are in the page, and to a
# figure, or says by a dash that there is none; three of four have one. The chunk of most rows is no other's.
ClaimsLeadToTheirEvidence() {
  local row="//*[@id='tbl:claims']//*[local-name()='tr'][*[local-name()='td']]" cell="*[last()]//*[local-name()='a']"
  local rows=$(xpath "count($row)") kind
  [ "$rows" -eq $(($(wc -l <build/data/claims.csv) - 1)) ] && [ "$rows" -gt 25 ] || fail "$rows rows"
  for kind in "starts-with(@href, '#sec:')" "starts-with(@href, '#lst:') and . = 'code'" "starts-with(@href, '#test:') and . = 'test'"; do
    expect_none "$(xpath "$row[not($cell[$kind])]/*[1]")" "a claim without a link that $kind"
  done
  expect_none "$(xpath "$row[boolean($cell[starts-with(@href, '#fig:')]) = contains(*[last()], '–')]/*[1]")" "neither a figure nor a dash"
  [ "$(xpath "count($row[$cell[starts-with(@href, '#fig:')]])")" -ge $((rows * 3 / 4)) ] || fail "too few claims lead to a figure"
  xpath "$row/$cell/@href" | sed 's/.*"#\(.*\)"/\1/' | sort -u >"$work/links"
  attributes '//@id' | sort -u >"$work/ids"
  expect_none "$(comm -13 "$work/ids" "$work/links")" "evidence that is not in the page"
  [ "$(grep -c '^lst:' "$work/links")" -gt $((rows / 2)) ] || fail "claims share their chunks"
}

# Below each drawing: its script, its data, the command that draws it and the test of it.
DrawingsHaveFourLinks() {
  local name figures
  figures=$(xpath "//*[@class='drawing']/following-sibling::*/*[@class='sources']/*[1]/@href" | sed 's/.*"#script:\(.*\)"/\1/')
  [ "$(wc -w <<<"$figures")" -gt 30 ] || fail "hardly any drawing"
  for name in $figures; do
    for target in "href=\"#command:$name\"" "href=\"#check:$name\"" "download=\"$name.csv.xz\"" \
      "id=\"command:$name\">make build/figures/$name.svg<" "id=\"check:$name\">ctest"; do
      grep -qF "$target" "$report" || fail "the drawing $name lacks $target"
    done
  done
}

# The outputs that are listed for a check of the computation are there.
ListedOutputsAreThere() {
  local file files=$(sed -n 's/^  - file: //p' codecheck.yml)
  [[ $files == *build/report.html* ]] || fail "the report is not listed"
  for file in $files; do [ -s "$file" ] || fail "$file is not there"; done
}

# Every test that is named, in the text or in a table, is in the page with its command, and each link to one arrives.
NamedTestsAreFolded() {
  local name
  xpath "//*[starts-with(@id, 'test:')]/@id" | sed 's/.*"test:\(.*\)"/\1/' | sort >"$work/folded"
  expect_none "$(uniq -d "$work/folded")" "tests that are folded twice"
  ctest --test-dir "$build" -N | sed -n 's/^ *Test *#[0-9]*: //p' | sort -u >"$work/tests"
  xpath "//*[local-name()='article']//*[local-name()='code'][not(ancestor::*[local-name()='pre'])]" | sed 's/<wbr *\/>//g; s/<[^>]*>/\n/g' |
    sort -u | comm -12 - "$work/tests" >"$work/named"
  [ "$(wc -l <"$work/named")" -gt 500 ] || fail "hardly any test is named"
  expect_none "$(comm -23 "$work/named" "$work/folded")" "tests that are named and not folded"
  while read -r name; do
    grep -qE -- "ctest --test-dir build/release -R $name<" "$report" || fail "no command runs $name"
  done <"$work/folded"
  expect_none "$(attributes '//@href' | sed -n 's/^#test://p' | sort -u | comm -23 - "$work/folded")" "links to tests that are not there"
}

# The identifier is git's hash of the tree of the revision, where this is a checkout that has it.
TellsItsTree() {
  local revision=$(told Revision) tree=$(told 'Source tree')
  [[ -n $revision && $revision != *-dirty ]] || { [ -z "$tree" ] || fail "$tree of changed sources"; return 0; }
  [[ $tree =~ ^swh:1:dir:[0-9a-f]{40}$ ]] || fail "the tree is '$tree'"
  ! git cat-file -e "$revision" 2>/dev/null || [ "swh:1:dir:$(git rev-parse "$revision^{tree}")" = "$tree" ] ||
    fail "$tree is not the tree of $revision"
}

# The first time by make, which tells revision, date and tree.
WovenTwiceAlike() { # for a release
  local revision=$(told Revision) date=$(told Date) tree=$(told 'Source tree')
  weave "$work/again.html" paper/*.md ${revision:+-M "revision=$revision"} ${date:+-M "date=$date"} ${tree:+-M "tree=$tree"} $(grep -q 'id="solver"' "$report" && echo -M live=yes --include-after-body=build/live.html)
  sed -zi -f paper/report.sed "$work/again.html"
  cmp "$work/again.html" "$report"
}

"$1"
