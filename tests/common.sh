# Read by the shell tests: a scratch folder with a space in its name, removed at the end, and `fail`.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
work="$scratch/a folder"
mkdir "$work"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
