#!/usr/bin/env bash
# No typedef, and no name that begins with an underscore or holds two: such are for the compiler, which
# may be asked for one of its own by defined(...) and asks for __cxa_...
# clang-tidy takes long over these.
source tests/common.sh

# wrong FILE...: where such a name stands, outside of comments and texts.
wrong() {
  local file
  for file; do
    sed 's|//.*||; s/defined([A-Za-z0-9_]*)//g; s/__cxa_[a-z_]*(//g; s/"\([^"\\]\|\\.\)*"//g' "$file" |
      grep -nE '\<typedef\>|\<_[A-Za-z0-9]|__' | sed "s|^|$file:|" || true
  done
}

found=$(wrong src/*/*.?pp src/*/*/*.?pp)
[ -z "$found" ] || fail "$found"

printf '%s\n' 'typedef int Count;' 'int _count;' 'int a__b;' 'int __a;' 'int a_;' 'int b;  // typedef' >"$work/mistaken.cpp"
[ "$(wrong "$work/mistaken.cpp" | wc -l)" = 4 ] || fail "not found: $(wrong "$work/mistaken.cpp")"
