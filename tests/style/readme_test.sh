#!/usr/bin/env bash
# readme_test.sh CASE: one promise of the README, run in the project's folder. The cases are the
# functions below that begin with a capital.
source tests/common.sh

# The relative addresses in a Markdown file.
addresses() { grep -oE '\]\([^)#]+\)' "$1" | sed 's/^](//; s/)$//' | grep -v '://'; }

# tracked: whatever ./README.md leads to is there, and in a checkout it is in the repository.
tracked() {
  local address
  addresses README.md >"$scratch/addresses"
  [ -s "$scratch/addresses" ] || { echo "no links at all"; return 1; }
  while read -r address; do
    [ -e "$address" ] || { echo "$address is not there"; return 1; }
    ! is_checkout || git ls-files --error-unmatch -- "$address" >/dev/null 2>&1 ||
      { echo "$address is not tracked"; return 1; }
  done <"$scratch/addresses"
}

LinksAreTracked() {
  tracked || fail "see above"

  cd "$work"
  git init -q .
  echo '![A picture](a.svg)' >README.md
  [ "$(tracked)" = 'a.svg is not there' ] || fail "a missing picture was not found"
  touch a.svg
  [ "$(tracked)" = 'a.svg is not tracked' ] || fail "an untracked picture was not found"
  git add a.svg
  tracked || fail "a tracked picture was refused"
}

# The map names the folders that are there.
MapNamesEachFolder() {
  sed -n '/^    src/,/^    figures/s/^      \([a-z]*\)\/ .*/\1/p' README.md | sort >"$work/named"
  find src -mindepth 1 -maxdepth 1 -type d -printf '%f\n' | sort | diff - "$work/named" || fail "src/ has other folders"
  local folder
  for folder in paper src figures tests; do grep -q "^    $folder/ " README.md || fail "$folder/ is not in the map"; done
}

# The version has its changes told, and is the same where it is built and cited.
VersionIsTold() {
  local version
  version=$(sed -n 's/^project(thermoroll VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
  [ -n "$version" ] || fail "no version in CMakeLists.txt"
  [ "$(sed -n 's/^version: //p' CITATION.cff)" = "$version" ] || fail "CITATION.cff has another version"
  [ "$(sed -n 's/^version = "\(.*\)"/\1/p' src/python/pyproject.toml)" = "$version" ] || fail "pyproject.toml has another version"
  [ "$(sed -n 's/^## \([0-9.]*\).*/\1/p' CHANGELOG.md | head -1)" = "$version" ] || fail "CHANGELOG.md does not begin with $version"
}

# same_picture FILE FILE: the same drawing, but for a fifth of a pixel (another machine rounds
# otherwise), and the same words.
same_picture() {
  awk -v other="$2" '
    function numbers(line) { gsub(/[^-0-9.]+/, " ", line); return line }
    function rest(line) { gsub(/[-0-9.]+/, "#", line); return line }
    {
      if ((getline line <other) != 1 || rest($0) != rest(line) || (/<t/ && $0 != line)) exit 1
      count = split(numbers($0), a, " "); split(numbers(line), b, " ")
      for (k = 1; k <= count; ++k) if (a[k] - b[k] > 0.2 || b[k] - a[k] > 0.2) exit 1
    }
    END { if ((getline line <other) == 1) exit 1 }' "$1"
}

PictureIsCurrent() { # slow
  local picture=figures/golden/temperature-load.svg
  bash tests/figures/readme-picture.sh >"$work/today.svg"
  same_picture "$work/today.svg" "$picture" || fail "$picture is out of date: run make golden"

  sed '0,/M[0-9]/s//M5/' "$picture" >"$work/moved.svg"
  ! same_picture "$work/moved.svg" "$picture" || fail "a moved curve was not found"
  sed '$d' "$picture" >"$work/short.svg"
  ! same_picture "$work/short.svg" "$picture" || fail "a missing line was not found"
  ! same_picture "$picture" "$work/short.svg" || fail "a surplus line was not found"
  sed 's/coupled/other/' "$picture" >"$work/renamed.svg"
  ! same_picture "$work/renamed.svg" "$picture" || fail "another label was not found"
  sed "s/>0.2</>0.21</" "$picture" >"$work/renamed.svg"
  ! same_picture "$work/renamed.svg" "$picture" || fail "another number was not found"
}

# Nothing else stands at the top of a checkout: what a program leaves behind is easily added.
surplus() {
  git ls-files | cut -d/ -f1 | sort -u | grep -vxE 'CMakeLists\.txt|CMakePresets\.json|Makefile|README\.md|CHANGELOG\.md|CONTRIBUTING\.md|CITATION\.cff|LICENSE|codecheck\.yml|paper|src|figures|tests|\.ci|\.github|\.git[a-z]+|\.clang-[a-z]+|\.editorconfig' || true
}

TopLevelIsTidy() {
  ! is_checkout || [ -z "$(surplus)" ] || fail "$(surplus)"

  cd "$work"
  git init -q .
  touch README.md slow-unit-1
  git add .
  [ "$(surplus)" = slow-unit-1 ] || fail "not found: $(surplus)"
}

"$1"
