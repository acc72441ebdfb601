#!/usr/bin/env bash
# Read by the tests of the report: `weave OUTPUT CHAPTER...`, the Makefile's command.
paper="$PWD/paper"

weave() {
  local output=$1
  shift
  pandoc "$@" -f markdown-implicit_figures -t html5 --wrap=none --mathml --fail-if-warnings \
    --lua-filter "$paper/weave.lua" --citeproc --bibliography "$paper/references.bib" \
    --template "$paper/template.html" -o "$output"
}
