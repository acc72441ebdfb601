#!/usr/bin/env bash
# coverage.sh BUILD: of each chapter's lines of code, how many have run in BUILD so far. The #line
# directives make gcov count by chapter.
set -eu -o pipefail
find "$1"/CMakeFiles/thermoroll{,-studies,-program,-cli,-c}.dir -name '*.gcno' -exec gcov --stdout --relative-only --source-prefix "$PWD" {} + |
  awk -F: '
    $2 + 0 == 0 && $3 == "Source" { chapter = $4; next }
    chapter !~ /^paper\// || $1 ~ /^ *-$/ || NF < 3 { next }
    { place = chapter ":" ($2 + 0) }
    !(place in seen) { seen[place]; all[chapter]++ }
    $1 !~ /[#=]/ && !(place in run) { run[place]; covered[chapter]++ }
    END {
      for (chapter in all) {
        printf "%-40s %5d of %5d lines  %5.1f %%\n", chapter, covered[chapter], all[chapter],
               100 * covered[chapter] / all[chapter] | "sort"
        total += all[chapter]; total_covered += covered[chapter]
      }
      close("sort")
      if (!total) { print "no coverage data" > "/dev/stderr"; exit 1 }
      printf "%-40s %5d of %5d lines  %5.1f %%\n", "all", total_covered, total, 100 * total_covered / total
    }'
