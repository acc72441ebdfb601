#!/usr/bin/env bash
# lint.sh NAME BUILD SOURCE...: clang-tidy reads these sources put together, which takes a third of the
# time, as they include the same headers. They are put into one file, not included by one: some
# checks look only at the file that is named.
source tests/common.sh
build=$2
together="$build/lint/$1.cpp"
shift 2
mkdir -p "$build/lint"
cat "$@" >"$together"
# Headers that GCC has compiled are not for clang.
sed 's/ -Winvalid-pch -include [^ ]*//' "$build/compile_commands.json" >"$build/lint/compile_commands.json"

# lint FILE: what is found, with its place in the sources.
lint() {
  clang-tidy --quiet --checks=-readability-duplicate-include --extra-arg=-Wno-unknown-warning-option -p "$build/lint" "$1" >"$work/found" 2>"$work/errors" &&
    return
  awk -v together="$1:" '
    NR == FNR { first[++n] = lines + 1; lines += $1; file[n] = $2; next }
    index($0, together) == 1 {
      rest = substr($0, length(together) + 1)
      for (k = n; k > 1 && first[k] > rest + 0; --k);
      sub(/^[0-9]+/, rest - first[k] + 1, rest)
      $0 = file[k] ":" rest
    }
    { print }' <(for file in "${sources[@]}"; do echo "$(wc -l <"$file") $file"; done) "$work/found"
  cat "$work/errors"
  return 1
}

sources=("$@")
lint "$together" || fail "see above"
for file; do # what cannot be seen in files put together
  sed -n 's/^using [A-Za-z_:]*::\([A-Za-z_0-9]*\);$/\1/p' "$file" | while read -r name; do
    [ "$(grep -cw "$name" "$file")" -gt 1 ] || fail "$file does not use $name"
  done
  [ -z "$(grep '^#include' "$file" | sort | uniq -d)" ] || fail "$file includes a header twice"
done
