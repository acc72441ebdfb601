#!/usr/bin/env bash
# src/ is what the chapters tangle to, file by file, with nothing left over.
source tests/common.sh
TANGLE_ROOT="$work" pandoc --preserve-tabs -f paper/tangle.lua -t plain -o /dev/null paper/*.md
diff -r "$work/src" src || fail "src/ is not what the chapters tangle to: run make"
