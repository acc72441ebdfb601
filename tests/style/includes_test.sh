#!/usr/bin/env bash
# Files include what stands beside or below them: the public headers, support, model, solver, studies,
# and at the top the program, the benchmarks and the certificates. The page's solver needs no study.
# The headers that are installed include each other only.
source tests/common.sh

# upward FOLDER...: the includes in these folders that point up, by the list of floors from the lowest.
upward() {
  grep -rnE '^#include "' "$@" | awk -F'[:"]' '
    function room(path) {
      if (match(path, /(live|certify)\/[^\/]*$/)) return path ~ /live/ ? "live" : "certify"
      return substr(path, 1, index(path, "/") - 1)
    }
    BEGIN { split("thermoroll support model solver studies program bench", names, " "); for (k in names) floor[names[k]] = k + 0
            floor["certify"] = floor["program"] = floor["bench"]; floor["live"] = floor["c"] = floor["studies"] }
    {
      from = $1
      sub(/^src\/(include\/)?/, "", from)
      own = room(from)
      to = room($4)
      known = own in floor && to in floor
      if (!known || floor[to] > floor[own] || own != to && floor[to] == floor[own]) print $1 ": " $4
    }'
}

found=$(upward src)
[ -z "$found" ] || fail "$found"
! grep -nE '^#include <(nlohmann|CLI|benchmark|thread|future)' -r src/include src/support src/model src/solver |
  grep -v '^src/solver/creep_law_by_speed.cpp:[0-9]*:#include <future>$' ||
  fail "the library needs Eigen and GSL, and starts threads for laws at several speeds only"

cd "$work"
mkdir -p src/{model,solver,include/thermoroll}
echo '#include "solver/a.hpp"' >src/model/a.cpp
echo '#include "model/a.hpp"' >src/include/thermoroll/a.hpp
echo '#include "a.hpp"' >src/solver/a.cpp
printf '#include "%s"\n' model/a.hpp thermoroll/a.hpp solver/b.hpp >src/solver/b.cpp
[ "$(upward src | wc -l)" = 3 ] || fail "found: $(upward src)"
