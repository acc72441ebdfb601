#!/usr/bin/env bash
# Read by the shell tests: a scratch folder with a space in its name, removed at the end, and `fail`.
# Not pipefail: a reader that has seen enough, as `head` or `grep -q`, would fail its writer.
set -eu
export LC_ALL=C.UTF-8 # whatever letters and decimals the caller's locale has
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
work="$scratch/a folder"
mkdir "$work"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# Whether this folder is the top of a checkout.
is_checkout() { [ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ]; }

# record OPTION...: a commit in a scratch repository, whoever runs the tests.
record() { git -c user.name=tests -c user.email=tests@example.org -c commit.gpgsign=false commit -q "$@"; }
