#!/usr/bin/env bash
# src/ is what the chapters tangle to, file by file, with nothing left over. In a checkout the
# committed chapters are compared with the committed sources, as make has tangled the others before;
# elsewhere, the files that are there.
source tests/common.sh

# fresh: whether that holds of the project in this folder; the differences on stdout.
fresh() {
  local project=$PWD taken
  taken=$(mktemp -d -p "$work")
  if is_checkout; then
    project="$taken/commit"
    mkdir "$project"
    git archive HEAD paper src | tar -xf - -C "$project"
  fi
  # a relative name, as pandoc takes capitals out of that of a reader
  (cd "$project" && TANGLE_ROOT="$taken" pandoc --preserve-tabs -f paper/tangle.lua -t plain -o /dev/null paper/*.md)
  diff -r "$taken/src" "$project/src"
}

fresh || fail "src/ is not what the chapters tangle to: run make, and commit src/ with the chapters"

# A source that was not committed with its chapter, one that was changed by hand, and one that is no
# longer told are found; work that is not committed yet is not.
mkdir -p "$work/project/paper" "$work/project/src"
cp paper/tangle.lua "$work/project/paper"
cd "$work/project"
told() { printf '``` {.cpp file=src/a.cpp}\nint %s;\n```\n' "$1" >paper/one.md; }
written() { printf '// Tangled from paper/one.md; edit there.\nint %s;\n' "$1" >src/a.cpp; }
told a
written b
! fresh >"$work/log" || fail "a source that differs was not found"
written a
fresh || fail "the same source was found"

commit() {
  git add -A
  record -m "$1"
}
git init -q .
commit fresh
fresh || fail "the same committed source was found"
told b
written b
fresh || fail "work that is not committed yet was found"
git add paper
record -m stale
! fresh >"$work/log" || fail "a stale committed source was not found"
commit mended
echo 'int c;' >src/c.cpp
commit left
! fresh >"$work/log" || fail "a source that no chapter tells was not found"
