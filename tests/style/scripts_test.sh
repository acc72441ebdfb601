#!/usr/bin/env bash
# Every shell script says in its first line what runs it, and that can read it.
source tests/common.sh

# unreadable FILE...: those of the scripts that do not, one a line.
unreadable() {
  local file shell
  for file; do
    shell=$(sed -n '1s|^#!/usr/bin/env bash$|bash|p; 1s|^#!/bin/sh$|sh|p' "$file")
    [ -n "$shell" ] && "$shell" -n "$file" 2>/dev/null || echo "$file"
  done
}

found=$(unreadable .ci/run tests/*.sh tests/*/*.sh)
[ -z "$found" ] || fail "without a first line that names bash or sh, or with a mistake: $found"

echo 'echo fine' >"$work/without.sh"
printf '#!/bin/sh\nif\n' >"$work/mistaken.sh"
[ "$(unreadable "$work/without.sh" "$work/mistaken.sh" | wc -l)" = 2 ] || fail "mistakes were not found"

# The tests do not depend on who runs them: LC_ALL goes before all else of the locale.
[ "$(LC_ALL=tr_TR.UTF-8 bash -c 'source tests/common.sh; echo $LC_ALL' 2>/dev/null)" = C.UTF-8 ] || fail "in the caller's locale"
