#!/usr/bin/env bash
# Read by `make golden` and by the test of the digests.

# The figures that are the same bytes whenever they are drawn: all that show no times.
same_whenever_drawn() {
  local script name
  for script in figures/*.gp; do
    name=$(basename "$script" .gp)
    case $name in style | cost | speed | speed-*) ;; *) echo "$name" ;; esac
  done
}

# digests FOLDER: of those figures as they are drawn there, below the gnuplot that draws them.
digests() {
  local name
  echo "# $(gnuplot --version)"
  for name in $(same_whenever_drawn); do
    printf '%s  %s.svg\n' "$(sha256sum <"$1/$name.svg" | cut -d' ' -f1)" "$name"
  done
}
