#!/usr/bin/env bash
# page_test.sh CASE: how a browser shows build/report.html, run in the project's folder. measure.html
# shows the report in a frame and writes what is wrong with it into itself.
source tests/common.sh
report="$PWD/build/report.html"
[ -s "$report" ] || fail "no $report: run make report"
browser=$(command -v chromium) || fail "chromium is missing. On Debian: apt-get install chromium"

# measure dark|light WIDTH: nothing is wrong in this colour scheme and at this width.
measure() {
  local scheme=1 found
  [ "$1" = light ] || scheme=0
  sed "s|REPORT|file://${report// /%20}|; s|WIDTH|$2|; s|SCHEME|$1|g" tests/report/measure.html \
    >"$work/measure.html"
  found=$(timeout 120 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$scratch/profile" --allow-file-access-from-files \
    --blink-settings=preferredColorScheme=$scheme \
    --dump-dom "file://${work// /%20}/measure.html" 2>"$work/errors") || fail "chromium: $(cat "$work/errors")"
  found=${found#*<pre id=\"found\">} found=${found%%</pre>*}
  [ "$found" = "nothing wrong" ] || fail "$1, $2 px: ${found:-the page was not measured}"
}

# No colour depends on the width and no width on the colours. A desk is measured with a larger window, too.
LightOnPhone() { measure light 360; }
DarkOnDesk() { measure dark 1400; }

"$1"
