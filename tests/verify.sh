#!/usr/bin/env bash
# The report is a function of the committed sources and of the times that were measured: it is made once
# more in another folder, locale and time zone, by one job at a time, from the times of this one, and
# must have the same bytes. Beside its checksum stand the packages that it was made with.
set -eu

[ -z "$(git status --porcelain)" ] || { echo "verify: there are changes that are not committed" >&2; exit 1; }
rm -f build/report.html build/paper.html # they may tell an earlier revision
make --no-print-directory report
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
git clone -q . "$folder/elsewhere with a blank"
cd "$folder/elsewhere with a blank"
mkdir -p build/data
cp -p "$OLDPWD/build/data/times.json" build/data/
env -u MAKEFLAGS -u MAKELEVEL -u THERMOROLL_STARTED THERMOROLL_LOCKED="$PWD" LC_ALL=C TZ=Pacific/Chatham \
  make --no-print-directory -j1 -o build/data/times.json report >make.log 2>&1 || { tail make.log >&2; exit 1; }
for page in report paper; do
  cmp "build/$page.html" "$OLDPWD/build/$page.html" || exit 1
done
cd "$OLDPWD"
{
  sha256sum build/report.html build/paper.html
  dpkg-query -W -f '# ${Package} ${Version}\n' "$@" 2>/dev/null || true
} >build/report.html.sha256
echo "The reports are the same bytes when made elsewhere: build/report.html.sha256"
