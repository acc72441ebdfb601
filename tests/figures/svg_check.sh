#!/usr/bin/env bash
# check_svg NAME FILE: is FILE the picture of figure NAME? One line on stderr for the first thing
# that is not, and a failure.

query() { xmllint --xpath "$2" "$1" 2>/dev/null; }

# The titles of the curves in the order in which they are drawn.
curves_of() {
  case $1 in
    geometry)
      printf '%s\n' half-space cylinder 'outline of the cylinder' 'surface of the half-space' \
        'stick zone' 'slip zone' ;;
    kernels) printf '%s\n' 'N1, downstream' 'N1, upstream' N2 M ;;
    traction | slip | temperature-load)
      for kind in converged 'published scheme'; do
        for traction in 0.2 0.4 0.5 0.59; do echo "Q* = $traction, $kind"; done
      done ;;
    temperature-?)
      for kind in converged 'published scheme'; do
        for peclet in 100 500 1000 5000; do echo "Pe = $peclet, $kind"; done
      done ;;
    subsurface) printf '%s\n' 'T*' isotherms ;;
    sliding)
      for traction in 0.5 0.2; do
        for kind in rolling sliding; do echo "Q* = $traction, $kind"; done
      done ;;
    creep) printf '%s\n' converged 'published scheme' ;;
    nodes)
      for what in 'T*' '1 − κ'; do
        for peclet in 100 4360; do echo "$what, Pe = $peclet"; done
      done ;;
    celsius) printf '%s\n' converged 'T ∝ √V' 'published scheme' paper ;;
    speed-*)
      for quantity in load temperature creep; do
        for method in label label label label label label 'published scheme' thriftily \
          'means for samples' coupled 'one linear correction' 'closed form'; do
          echo "$quantity: $method"
        done
      done ;;
    arithmetic)
      printf '%s\n' 'law of N1' 'law of N2 near zero' 'law of N2 at infinity'
      for formula in printed scaled; do
        for kernel in N1 N2 M; do echo "$kernel, $formula"; done
      done ;;
    seen) printf '%s\n' 'share seen' levels law 'range of the paper' ;;
    iteration-?)
      printf '%s\n' method 'the scheme ends at no contact' 'Picard contracts' 'half steps contract' ;;
    ends) printf '%s\n' 'from the fast limit' 'from the slow limit' ;;
    cycle) printf '%s\n' 'n = 90' steps 'n = 89' 'n = 91' ;;
    cost) # the ends of three curves and the curves, in both panels
      for heating in 0.0175 1; do
        for k in 1 2 3; do echo "cost_plot_$k$([ $heating = 1 ] && echo b || echo a)"; done
        for digits in 4 6 8; do echo "10−$digits, H = $heating"; done
      done ;;
    rungs) # the dashed curve of each tolerance has no entry in the key
      printf '%s\n' 10−2 rungs_plot_2 10−3 rungs_plot_4 10−6 rungs_plot_6 ;;
  esac
}

# What must be written in the picture: axes and the labels of the curves.
labels_of() {
  case $1 in
    geometry) printf '%s\n' P Q R x y V 'V / R' −a c a stick slip 'heat f V v p' half-space ;;
    kernels) printf '%s\n' ζ M N1 N2 upstream downstream ;;
    traction) printf '%s\n' s 'q*' 0.2 0.4 0.5 'Q* = 0.59' 'converged, H = 0' 'published scheme, n = 200' ;;
    slip) printf '%s\n' s 'v*' 0.2 0.4 0.5 'Q* = 0.59' 'converged, H = 0' 'published scheme, n = 200' ;;
    temperature-load)
      printf '%s\n' s 'T*' 0.2 0.4 0.5 'Q* = 0.59' 'converged, H = 0' 'published scheme, n = 200' ;;
    temperature-?)
      printf '%s\n' s 'T*' 'Pe = 100' 500 1000 5000 'converged, H = 0' 'published scheme, n = 200' ;;
    subsurface) printf '%s\n' s y 'T*' stick slip 0.0005 0.002 0.004 0.006 0.009 ;;
    sliding) printf '%s\n' s 'T*' 'rolling, Q* = 0.5' 'rolling, Q* = 0.2' sliding ;;
    creep) printf '%s\n' 'ξ*' 'Q*' 'full sliding, Q* = f' 'converged, H = 0' 'published scheme, n = 200' ;;
    nodes)
      printf '%s\n' n '% found' 'largest temperature,' 'Pe = 100' 'Pe = 4360' '1 − κ, Pe = 100' '1 − κ, Pe = 4360' ;;
    celsius)
      printf '%s\n' '°C' 'V, m/s' converged 'the paper' 'published scheme, n = 200' ;;
    speed-*)
      printf '%s\n' 'relative error' 'a. Thermal correction of the load, κ − 1' \
        'b. Largest temperature' 'c. Creep' '1 %' '1 ms' coupled thriftily 'means for samples' 'first order' 'closed form' ;;
    seen) printf '%s\n' 'the paper' Pe n '99.9 %' '99 %' '90 %' '50 %' '10 %' 'share seen' ;;
    iteration-?)
      printf '%s\n' Picard 'Picard, half steps' Anderson Newton 'Newton, led' 'not reached' \
        'scheme: no contact' 'ρ = 1' Pe 'f Pe H' ;;
    ends) printf '%s\n' 'relative distance' Pe 'slow limit' 'fast limit' ;;
    cost) printf '%s\n' Pe '0.1 ms' '10 ms' 'a. H = 0.0175' 'b. H = 1' 10−4 10−6 10−8 ;;
    rungs) printf '%s\n' Pe H paper 10−2 10−3 10−6 ;;
    cycle) printf '%s\n' 'inner step' c0 'a node of n = 90' 'n = 90: no end' 'n = 89 and 91: settled' ;;
    arithmetic) printf '%s\n' 'digits lost, of 16' '|ζ|' N1 N2 M 'as printed' 'with scaled functions' ;;
  esac
}

# The height of the picture; all are 560 wide.
height_of() { case $1 in speed-*) echo 900 ;; cost) echo 640 ;; *) echo 380 ;; esac; }

# All that is a word, a number or true is asked for at once, as each question reads the file.
check_svg() {
  local name=$1 file=$2 id=${1//-/_}
  wrong() { echo "$name: $*" >&2; return 1; }
  local plots="//*[starts-with(@id, '${id}_plot_')]"
  local empty="[not(.//*[local-name()='path' or local-name()='polygon'][string-length(concat(@d, @points)) > 9]
    or .//*[local-name()='use'] or .//*[local-name()='image'] or .//*[local-name()='text'])]"
  local external="//@*[local-name()='href'][not(starts-with(., '#') or starts-with(., 'data:'))]"
  # What gnuplot puts into a group of colour white would vanish on a light page.
  local white="//*[@color='white']//*"
  local question="/*/@viewBox, '|', /*/*[local-name()='title'], '|',
    count($plots$empty), '|', count($external), '|', count($white)"
  local labels label answer
  mapfile -t labels < <(labels_of "$name")
  for label in "${labels[@]}"; do
    question+=", '|', boolean(//*[local-name()='text'][normalize-space(.) = '$label'])"
  done
  IFS='|' read -ra answer < <(query "$file" "concat($question)") || wrong "not XML" || return

  [ "${answer[0]}" = "0 0 560 $(height_of "$name")" ] || wrong "viewBox" || return
  [ "${answer[1]}" = "$id" ] || wrong "title" || return
  [ "$(wc -c <"$file")" -lt 300000 ] || wrong "too large" || return

  local titles
  titles=$(query "$file" "$plots/*[local-name()='title']/text()")
  [ -n "$titles" ] && [ "$titles" = "$(curves_of "$name")" ] || wrong "curves: $titles" || return
  [ "${answer[2]}" = 0 ] || wrong "an empty curve" || return

  # No NaN or infinity among the coordinates, and none far outside of the picture.
  query "$file" '//@d | //@points | //@transform | //@x | //@y' | tr -c '0-9a-zA-Z.+\n-' ' ' | awk '
    tolower($0) ~ /nan|inf/ { exit 1 }
    { gsub(/[A-Za-z]/, " "); for (i = 1; i <= NF; ++i) if ($i < -40 || $i > 1000) exit 1 }' ||
    wrong "a coordinate that is none" || return

  [ "${answer[3]}" = 0 ] || wrong "something external" || return
  [ "${answer[4]}" = 0 ] || wrong "something white" || return
  local k
  for k in "${!labels[@]}"; do
    [ "${answer[k + 5]}" = true ] || wrong "label ${labels[k]}" || return
  done
}
