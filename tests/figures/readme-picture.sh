#!/usr/bin/env bash
# The README's picture, on stdout: a figure with its ground painted white, as it is shown on dark
# pages too.
set -euo pipefail
sed 's/fill="none"/fill="white"/;ta;b;:a;n;ba' build/figures/temperature-load.svg
