#!/usr/bin/env bash
# command_test.sh CASE PROGRAM: one thing that the program's users rely on, run in the project's
# folder. The cases are the functions below that begin with a capital.
source tests/program/program.sh

paper_scene=(--friction 0.6 --traction 0.5 --peclet 5000 --heating 0.0175)
steel=(--friction 0.6 --traction 0.5 --load 1.2e7 --speed 22.2 --shear-modulus 8.1e10 --poisson 0.3
  --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50)
published=(--method gauss-chebyshev --nodes 200 --formulation printed)
methods="closed-form gauss-chebyshev coupled"

# value KEY: what the JSON in `out` has for this key, at its first place.
value() { sed -n "s/^ *\"$1\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}$/\1/p" out | head -1; }

# near A B TOLERANCE: |A - B| <= TOLERANCE, in double precision.
near() {
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; exit !(d <= t && -d <= t && a != "") }' ||
    fail "$1 is not $2 within $3"
}

calculate() { awk "BEGIN { pi = atan2(0, -1); printf \"%.17g\", $1 }"; }

# --- Results --------------------------------------------------------------------------------------

SchemeGivesThePapersTemperature() {
  answers solve "${paper_scene[@]}" "${published[@]}" --format json
  near "$(value max_temperature)" 0.001998 5e-7 # all digits of the published value
  near "$(value load_ratio)" 0.99981 5e-6
  [ "$(value converged) $(value error_estimate)" = "true null" ] || fail "$(cat out)"
  near "$(value eccentricity)" "$(calculate "pi * $(value gamma0) / 2 / $(value load_ratio)")" 1e-15
}

# Heat bulges the surface: with the right sign the contact carries more than Hertz's share.
AutoIsTheDefault() {
  answers solve "${paper_scene[@]}" --method auto --formulation corrected --tolerance 1e-6 --format json
  cp out explicit
  answers solve "${paper_scene[@]}" --format json
  cmp out explicit || fail "these are not the defaults"
  [ "$(value traction) $(value nodes) $(value converged)" = "0.5 null true" ] || fail "$(cat out)"
  [ "$(value unknowns)" -ge 16 ] && [ "$(value newton_iterations)" -ge 1 ] || fail "$(cat out)"
  near "$(value eccentricity)" "$(calculate "pi * $(value gamma0) / 2 / $(value load_ratio)")" 1e-15
  near "$(value creep)" "$(calculate "$(value creep_constant) - 0.6 * $(value gamma0)")" 1e-6
  near "$(value load_ratio)" 1.00146355893 1e-7 # with a tolerance of 1e-9
}

# The answer names the method that was asked for, and the model that it stands for.
MethodIsTheOneAskedFor() {
  local method
  for method in auto closed-form first-order coupled gauss-chebyshev; do
    answers solve "${paper_scene[@]}" --method $method --format json
    [ "$(value method)" = $method ] || fail "$method: $(cat out)"
    case $method in auto | gauss-chebyshev) continue ;; esac
    [ "$(value model), $(value reason)" = "$method, asked for" ] || fail "$method: $(cat out)"
  done
}

# Each error is within the tolerance (absolute, or relative for creep, heat and temperature), none
# but that of the given traction is zero, and a finer solution differs by at most ten errors.
CoupledErrorsKeepTheTolerance() {
  local key scale tolerance unknowns=0
  errors() { sed -n '/"error_estimate"/,/}/s/^ *"\([a-z0-9_]*\)": \([0-9][^,{]*\),\{0,1\}$/\1 \2/p' out | grep -v '^heat_[12] '; }
  answers solve "${paper_scene[@]}" --tolerance 1e-9 --format json
  cp out fine
  for tolerance in 1e-2 1e-4 1e-6; do
    answers solve "${paper_scene[@]}" --tolerance $tolerance --format json
    [ "$(value unknowns)" -ge "$unknowns" ] || fail "fewer unknowns for $tolerance"
    unknowns=$(value unknowns)
    [ "$(errors | sed -n 1p)" = "traction 0.0" ] || fail "the given traction: $(errors)"
    [ "$(errors | wc -l)" -eq 10 ] || fail "$(errors)"
    errors | sed 1d >errors
    while read -r key error; do
      case $key in
      creep | creep_constant | heat_integral | max_temperature) scale=$(value "$key") ;;
      eccentricity) scale=3.2 ;; # pi/2 of gamma0's, and a little of kappa's
      max_temperature_at) scale=$(calculate "(1 - $(value stick_slip_border)) / sqrt($tolerance)") ;;
      *) scale=1 ;;
      esac
      awk -v e="$error" -v s="$scale" -v t=$tolerance 'BEGIN { exit !(e > 0 && e <= s * t) }' ||
        fail "$key has the error $error at $tolerance"
      near "$(value "$key")" "$(sed -n "s/^  \"$key\": \(.*\),/\1/p" fine)" "$(calculate "10 * $error")"
    done <errors
  done
}

# Given the creep or the border that a traction leads to, the traction is found again.
CreepOrBorderInPlaceOfTraction() {
  local method rest=(--friction 0.6 --peclet 100 --heating 1 --tolerance 1e-8 --format json)
  for method in coupled closed-form; do
    answers solve --traction 0.4 "${rest[@]}" --method $method
    cp out by-traction
    local creep border
    creep=$(value creep) border=$(value stick_slip_border)
    answers solve --creep "$creep" "${rest[@]}" --method $method
    near "$(value traction)" 0.4 1e-7
    [ "$(value creep)" = "$creep" ] || fail "the creep is not as given"
    sed -n '/"error_estimate"/,$p' out | grep -q '^ *"creep": 0.0,$' || fail "its error is not zero"
    answers solve --stick-slip-border "$border" "${rest[@]}" --method $method
    near "$(value traction)" 0.4 1e-7
    [ "$(value stick_slip_border)" = "$border" ] || fail "the border is not as given"
  done
  answers temperature --friction 0.6 --creep 0.1 --peclet 100 --at 0.5
  answers solve "${steel[@]:0:2}" --creep 0.1 "${steel[@]:4}" --half-width 5.5e-3 --format json
  near "$(value creep_ratio)" "$(calculate '0.1 * 1.4 * 1.2e7 / (8.1e10 * 5.5e-3)')" 1e-17
  refuses 2 "gauss-chebyshev needs the traction" \
    solve --friction 0.6 --creep 0.1 --peclet 100 --method gauss-chebyshev
  refuses 2 "creep = 0 is not allowed: it must be positive" \
    solve --friction 0.6 --creep 0 --peclet 100 --method gauss-chebyshev
  refuses 2 "creep = 0.5 is not allowed: it must be below 2 f / pi" \
    solve --friction 0.6 --creep 0.5 --peclet 100 --method closed-form
  refuses 2 "creep = -0.5 is not allowed: it must be above -2 f / pi" \
    solve --friction 0.6 --creep -0.5 --peclet 100 --method first-order
  answers solve --friction 0.6 --creep 0.5 --peclet 100 --format json
  [ "$(value traction) $(value full_slip)" = "0.6 true" ] || fail "not in full slip: $(cat out)"
  refuses 2 "stick-slip-border = -1 is not allowed: it must be between -1 and 1" \
    solve --friction 0.6 --stick-slip-border -1 --peclet 100
  refuses 2 "stick-slip-border = -0.9999999999999999 is not allowed: it must be between -1 and 1" \
    solve --friction 0.6 --stick-slip-border -0.9999999999999999 --peclet 100
  local one="exactly one of --traction, --creep and --stick-slip-border"
  refuses 2 "$one" solve --friction 0.6 --peclet 100
  refuses 2 "$one" solve --friction 0.6 --peclet 100 --traction 0.5 --creep 0.1
  refuses 2 "$one" solve --friction 0.6 --peclet 100 --creep 0.1 --stick-slip-border 0
}

# A creep as a fraction of the speed: the scaled creep mu a xi / (2 (1 - nu) P) of the half-width, which
# may follow from a radius; as an option, in a scene file and as a column.
CreepRatio() {
  local data=("${steel[@]:0:2}" "${steel[@]:4}") scaled half
  answers solve "${data[@]}" --half-width 5.5e-3 --creep-ratio 0.005 --format json
  near "$(value creep)" "$(calculate '0.005 * 8.1e10 * 5.5e-3 / (1.4 * 1.2e7)')" 1e-15
  near "$(value creep_ratio)" 0.005 1e-17
  grep -q '^ *"creep_ratio": 0.0,$' out || fail "an error of what is given: $(cat out)"
  cp out by-ratio
  scaled=$(value creep)
  answers solve "${data[@]}" --half-width 5.5e-3 --creep "$scaled" --format json
  diff <(sed '/"creep_ratio"/d' by-ratio) <(sed '/"creep_ratio"/d' out) || fail "the same creep is another scene"
  answers solve "${data[@]}" --radius 0.46 --creep-ratio -0.003 --format json
  half=$(value half_width)
  near "$(value creep)" "$(calculate "-0.003 * 8.1e10 * $half / (1.4 * 1.2e7)")" 1e-15
  near "$(value creep_ratio)" -0.003 1e-17
  near "$(value radius)" 0.46 1e-6
  [ "$(value direction)" = braking ] || fail "$(cat out)"
  cp out by-radius
  write_wheel
  sed -i '/^traction/d; /^half-width/d' wheel.toml
  printf 'creep_ratio = -0.003\nradius = 0.46\n' >>wheel.toml
  answers solve --config wheel.toml --format json
  cmp out by-radius || fail "the file is another scene"
  printf '%s\n' "friction,load,speed,shear-modulus,poisson,expansion,diffusivity,conductivity,radius,creep-ratio" \
    "0.6,1.2e7,22.2,8.1e10,0.3,1.1e-5,1.4e-5,50,0.46,-0.003" >scenes.csv
  "$program" sweep <scenes.csv >results.csv || fail "$(cat results.csv)"
  column() { awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) at = i } END { print $at }' results.csv; }
  [ "$(column traction) $(column physical.tangential_load) $(column physical.max_temperature_at_m)" = \
    "$(value traction) $(value tangential_load) $(value max_temperature_at_m)" ] || fail "$(cat results.csv)"
  refuses 2 "for data in SI units only: --creep-ratio" solve --friction 0.6 --peclet 100 --creep-ratio 0.01
  refuses 2 "creep-ratio = 0.02: creep = " solve "${data[@]}" --radius 0.46 --creep-ratio 0.02 --method closed-form
  one_line "is not allowed: it must be below 2 f / pi"
  refuses 2 "--direction driving contradicts --creep-ratio -0.01" \
    solve "${data[@]}" --radius 0.46 --creep-ratio -0.01 --direction driving
  refuses 2 "exactly one of --traction, --creep, --stick-slip-border, --creep-ratio and --tangential-load is needed" \
    solve "${data[@]}" --radius 0.46 --creep-ratio 0.01 --creep 0.1
  refuses 2 "unexpected --creep-ratio" law --friction 0.6 --peclet 100 --creep-ratio 0.01
}

# A tangential load in N/m is the traction times the load, with its sign.
TangentialLoad() {
  local data=("${steel[@]:0:2}" "${steel[@]:4}" --radius 0.46) load
  for load in 6e6 -6e6; do
    answers solve "${data[@]}" --traction "$(calculate "$load / 1.2e7")" --format json
    cp out by-traction
    [ "$(value tangential_load)" = "$(calculate "$load").0" ] || fail "$(cat out)"
    [ "$(sed -n 's/^ *"tangential_load": \(.*\),$/\1/p' out | tail -1)" = 0.0 ] || fail "an error of what is given: $(cat out)"
    answers solve "${data[@]}" --tangential-load $load --format json
    cmp out by-traction || fail "the same load is another scene"
  done
  answers solve "${data[@]}" --creep 0.2 --format json
  near "$(value tangential_load)" "$(calculate "1.2e7 * $(value traction)")" 1e-8
  near "$(value max_temperature_at_m)" "$(calculate "$(value half_width) * $(value max_temperature_at)")" 1e-17
  answers solve "${data[@]}" --tangential-load -6e6
  grep -q '^tangential_load  *Q  *-6e+06  *N/m$' out || fail "$(cat out)"
  grep -q '^max_temperature_at_m  *x  *0.006[0-9]*  *[0-9.e-]*  *m$' out || fail "$(cat out)"
  for load in 9e6 -9e6; do
    refuses 2 "is not allowed: it must be between -7200000 and 7200000 N/m, friction times load" \
      solve "${data[@]}" --tangential-load $load
  done
  refuses 2 "tangential-load = 6e+06 over load = 1.2e+07: traction = 0.5 is not allowed: it must be at most 0." \
    solve "${data[@]}" --tangential-load 6e6 --friction-law linear --friction-temperature 200
  grep -q ' (467[0-9]* N/m, at the creep-ratio 0.0[0-9]*)$' err || fail "$(cat err)"
  # The largest is that of an answer, with the sign of the force.
  local falls=("${steel[@]:0:2}" "${steel[@]:4}" --half-width 5.5e-3 --friction-law linear --friction-temperature 200) sign
  for sign in "" -; do
    answers solve "${falls[@]}" --tangential-load ${sign}1e6 --format json
    local most=$(value tangential_load_limit) at=$(value creep_ratio_at_limit)
    refuses 2 "tangential-load = ${sign}6e+06 over load" solve "${falls[@]}" --tangential-load ${sign}6e6
    near "$(sed -n 's/.* (\(.*\) N\/m, at the creep-ratio .*)$/\1/p' err)" "$most" 10
    near "$(sed -n 's/.* N\/m, at the creep-ratio \(.*\))$/\1/p' err)" "$at" 1e-6
    refuses 2 "traction = ${sign}0.5 is not allowed: it must be at " solve "${falls[@]}" --traction ${sign}0.5
    near "$(sed -n 's/.* (\(.*\) N\/m, at the creep-ratio .*)$/\1/p' err)" "$most" 10
  done
  # The unit of a creep that is refused, here of one at which all slips, is that of the scene.
  answers solve "${data[@]}" --creep-ratio 0.005 --format json
  local creep=$(value creep)
  refuses 2 "the creep is not determined" solve "${data[@]}" --traction 0.6
  near "$(sed -n 's/.*creep-ratio \(.*\))$/\1/p' err)" "$(calculate "0.005 / $creep")" 1e-5
  answers solve "${data[@]}" --tangential-load 1e6 --friction-law linear --friction-temperature 200 \
    --branch falling --format json
  [ "$(value branch) $(value tangential_load)" = "falling 1000000.0" ] || fail "$(cat out)"
  refuses 2 "for data in SI units only: --tangential-load" solve --friction 0.6 --peclet 100 --tangential-load 1
  refuses 2 "data in SI units lack --load" solve --friction 0.6 --radius 0.46 --tangential-load 1
}

# Which notes there are, and that they are no part of the answer.
NotesOnStandardError() {
  local grid="the nodes are 78.5 kernel widths apart: load_ratio, gamma0 and max_temperature are not"
  local sign="thermal slope with the sign as printed (see --formulation corrected)"
  notes() { # notes COUNT ARGUMENT...
    local count=$1
    shift
    run "$@"
    [ $status -eq 0 ] || fail "$* gave status $status: $(cat err)"
    [ "$(grep -c '^thermoroll: note: ' err)" -eq "$count" ] && [ "$(wc -l <err)" -eq "$count" ] ||
      fail "$* said: $(cat err)"
    ! grep -q note out || fail "a note in the answer: $(cat out)"
  }
  notes 2 solve "${paper_scene[@]}" "${published[@]}" --format json
  grep -qF "$grid" err && grep -qF "$sign" err || fail "$(cat err)"
  notes 1 solve "${paper_scene[@]}" --method gauss-chebyshev
  grep -qF "$grid" err || fail "$(cat err)"
  notes 1 solve "${paper_scene[@]}" --formulation printed
  grep -qF "$sign" err || fail "$(cat err)"
  notes 2 temperature "${paper_scene[@]}" "${published[@]}" --at 0.5
  notes 0 solve "${paper_scene[@]}"
  notes 0 solve "${paper_scene[@]}" --method closed-form --formulation printed
  notes 0 solve --friction 0.6 --traction 0.5 --peclet 5000 "${published[@]}"
  notes 1 solve --friction 0.6 --traction 0.5 --peclet 60 --heating 0.0175 "${published[@]}"
  notes 1 solve "${paper_scene[@]}" --nodes 200
  grep -qF -- "--nodes makes no difference to --method auto" err || fail "$(cat err)"
  notes 1 temperature "${paper_scene[@]}" --nodes 200 --method closed-form --at 0
  notes 1 solve --friction 0.6 --traction 0.5 --peclet 60 "${published[@]}" --tolerance 1e-6
  grep -qF -- "--tolerance makes no difference to --method gauss-chebyshev" err || fail "$(cat err)"
  # A temperature in K beside dimensionless data.
  local scene=(solve --friction 0.3 --creep 0.1 --peclet 1000 --heating 0.01 --friction-law linear)
  notes 1 "${scene[@]}" --friction-temperature 1600
  grep -q 'the law changes friction by less than 1e-4: max_temperature is 0.00[0-9]* and --friction-temperature .* 1.6e+03$' err || fail "$(cat err)"
  notes 0 "${scene[@]}" --friction-temperature 9
  # Traction and creep beside the state without slip, on either side of it.
  scene=(solve --friction 0.6 --peclet 10 --heating 0.01 --roller identical --bulk-difference 0.001 --tolerance 1e-3)
  notes 0 "${scene[@]}" --traction 0.1
  notes 0 "${scene[@]}" --traction -0.1
  notes 1 "${scene[@]}" --traction 1e-6
  grep -q "note: braking is relative to the state without slip (see no_slip_traction and no_slip_creep)" err || fail "$(cat err)"
  # Friction with two bulk temperatures and no reference refers to one of both.
  scene=(--friction 0.6 --peclet 10 --heating 0.01 --roller identical --tolerance 1e-2 --friction-law linear
    --friction-temperature 0.3)
  local about="--friction holds at the half-space's bulk temperature"
  for command in "solve --creep 0.1" "law --format json" "creep-curve --points 3"; do
    notes 1 $command "${scene[@]}" --bulk-difference 0.001
    grep -qF -- "$about" err || fail "$(cat err)"
    notes 0 $command "${scene[@]}" --bulk-difference 0
    notes 0 $command "${scene[@]}" --bulk-difference 0.001 --friction-reference-temperature 0
  done
}

# --- Profiles -------------------------------------------------------------------------------------

of_errors=,error_estimate.pressure,error_estimate.traction,error_estimate.slip,error_estimate.heat_flux,error_estimate.temperature

ProfileHasAllColumns() {
  local method header=s,pressure,traction,slip,heat_flux,temperature$of_errors
  for method in coupled closed-form; do
    answers solve "${paper_scene[@]}" --method $method
    cp out expected
    answers solve "${paper_scene[@]}" --method $method --profile p.csv
    cmp out expected || fail "the profile changes the answer"
    [ "$(head -1 p.csv)" = $header ] || fail "$(head -1 p.csv)"
    # s ascends; stick carries less than f p and has no slip, slip carries f p; v p is the heat flux
    awk -F, 'function off(a, b) { return a - b > 1e-12 || b - a > 1e-12 }
      NR == 1 { next } NF != 11 || $1 <= before && NR > 2 || $2 < 0 || $4 < 0 { exit 1 }
      $4 == 0 && $3 > 0.6 * $2 || $4 > 0 && off($3, 0.6 * $2) || off($5, $2 * $4) { exit 1 }
      { before = $1; slips += $4 > 0; hot = $6 > hot ? $6 : hot }
      END { exit !(NR > 30 && slips > 10 && hot > 0.002045 && hot < 0.002053) }' p.csv ||
      fail "$method: $(cat p.csv)"
  done
  answers solve "${steel[@]}" --half-width 5.5e-3 --format json --profile p.csv
  header=s,x_m,pressure,pressure_pa,traction,traction_pa,slip,slip_m_per_s,heat_flux,heat_flux_w_per_m2
  [ "$(head -1 p.csv | sed 's/,error.*//')" = $header,temperature,temperature_celsius ] || fail "$(head -1 p.csv)"
  local unit
  unit=$(calculate "$(value max_temperature_celsius) / $(value max_temperature)")
  awk -F, -v unit="$unit" 'function same(a, b) { return (a - b)^2 <= (1e-9 * b)^2 }
    NR > 1 && !(same($2, $1 * 5.5e-3) && same($4, $3 * 1.2e7 / 5.5e-3) && same($6, $5 * 1.2e7 / 5.5e-3) &&
      same($10, 0.6 * $4 * $8) && same($12, $11 * unit)) { exit 1 }' p.csv || fail "$(cat p.csv)"
}

# So many points, dense at both edges and at the border, which is one of them: half of the points lie
# within an eighth of a zone's length from an end of it, where a third is with t = sin^2 of an angle.
ProfileAtPoints() {
  local points method border
  for method in coupled closed-form; do
    answers solve "${paper_scene[@]}" --method $method --format json
    cp out expected
    border=$(value stick_slip_border)
    for points in 2 3 4 101 2500; do
      answers solve "${paper_scene[@]}" --method $method --format json --profile p.csv --profile-points $points
      cmp out expected || fail "the profile changes the answer"
      awk -F, -v n=$points -v border="$border" '
        NR == 1 { if ($6 != "temperature") exit 1; next }
        NR == 2 && $1 != -1 || NR > 2 && $1 <= before { exit 1 }
        { before = $1; near = $1 < border ? ($1 + 1) / (border + 1) : ($1 - border) / (1 - border) }
        { ends += near < 1 / 8 || near > 7 / 8; found += near < 1e-12 || near > 1 - 1e-12 }
        END { exit !(NR == n + 1 && $1 == 1 && (n < 5 || ends > 0.4 * n) && (n < 3 || found == 3)) }' p.csv ||
        fail "$method $points: $(head p.csv)"
    done
  done
  refuses 2 "--profile-points needs --profile" solve "${paper_scene[@]}" --profile-points 100
  for points in 1 100001; do
    refuses 2 "profile-points = $points is not allowed: it must be from 2 to 100000" \
      solve "${paper_scene[@]}" --profile p.csv --profile-points $points
  done
  refuses 2 "profile-points = 2.5 is not allowed: it must be a whole number" \
    solve "${paper_scene[@]}" --profile p.csv --profile-points 2.5
}

# The flux into each body stands in columns of its own, where both conduct: together they are the
# heat of friction, and behind a hot wheel's leading edge they are opposite.
# The same errors in every row; with SI data those in units, too.
ProfileHasItsErrors() {
  answers solve "${steel[@]}" --half-width 5.5e-3 --tolerance 1e-4 --profile p.csv --profile-points 5
  [ "$(head -1 p.csv | cut -d, -f 13-)" = error_estimate.pressure,error_estimate.pressure_pa,error_estimate.traction,error_estimate.traction_pa,error_estimate.slip,error_estimate.slip_m_per_s,error_estimate.heat_flux,error_estimate.heat_flux_w_per_m2,error_estimate.temperature,error_estimate.temperature_celsius ] ||
    fail "$(head -1 p.csv)"
  [ "$(tail -n +2 p.csv | cut -d, -f 13- | sort -u | wc -l)" = 1 ] || fail "$(cat p.csv)"
  awk -F, 'NR == 4 { for (k = 13; k < 23; k += 2)
      if ($k < 1e-9 || $k > 1e-3 || ($(k + 1) / $k / ($(k - 9) / $(k - 10)) - 1)^2 > 1e-20) exit 1 }
    END { exit NR != 6 }' p.csv || fail "$(cat p.csv)"
}

ProfileOfTwoBodies() {
  local header=s,pressure,traction,slip,heat_flux,temperature,heat_flux_1,heat_flux_2$of_errors
  local scene=(--friction 0.6 --traction 0.4 --peclet 100 --heating 0.1) warm
  for warm in 0 0.01; do
    answers solve "${scene[@]}" --roller conducting --conductivity-ratio 2 --heating-2 0.1 --peclet-2 50 \
      --bulk-difference $warm --profile p.csv
    [ "$(head -1 p.csv)" = $header ] || fail "$(head -1 p.csv)"
    awk -F, -v warm=$warm 'NR == 1 { next } NF != 13 || ($7 + $8 - $5)^2 > 1e-30 { exit 1 }
      $1 < -0.5 && (warm > 0 ? $7 < 0.01 || $8 > -0.01 : $7^2 > 1e-14) { exit 1 }
      END { exit !(NR > 30) }' p.csv || fail "$(cat p.csv)"
  done
  answers solve "${steel[@]}" --half-width 5.5e-3 --roller identical --profile p.csv
  head -1 p.csv | grep -q ',heat_flux_1,heat_flux_1_w_per_m2,heat_flux_2,heat_flux_2_w_per_m2,error' ||
    fail "$(head -1 p.csv)"
  awk -F, 'NR > 1 && (($13 - $9 / 2)^2 > 1e-30 || ($14 - $10 / 2)^2 > (1e-12 * $10)^2 || $16 != $14) { exit 1 }' p.csv ||
    fail "$(cat p.csv)"
}

# A law of friction has its local coefficient behind the other columns, before their errors.
ProfileOfALawOfFriction() {
  local law=(--friction-law linear --friction-temperature)
  answers solve --friction 0.6 --creep 0.1 --peclet 100 "${law[@]}" 0.02 --profile p.csv
  [ "$(head -1 p.csv)" = s,pressure,traction,slip,heat_flux,temperature,friction$of_errors ] || fail "$(head -1 p.csv)"
  awk -F, 'NR > 1 && ($7 - 0.6 * (1 - $6 / 0.02))^2 > 1e-30 { exit 1 } { least = NR == 2 || $7 < least ? $7 : least }
    END { exit !(NR > 30 && least < 0.5) }' p.csv || fail "$(cat p.csv)"
  answers solve "${steel[@]}" --half-width 5.5e-3 --bulk-temperature 20 "${law[@]}" 1600 --profile p.csv --profile-points 9
  head -1 p.csv | grep -q ',temperature,temperature_celsius,absolute_temperature_celsius,friction,error' || fail "$(head -1 p.csv)"
  awk -F, 'NR > 1 && ($14 - 0.6 * (1 - $12 / 1600))^2 > 1e-24 { exit 1 }' p.csv || fail "$(cat p.csv)"
}

ProfileAndResultOrNeither() {
  local profile=(--profile p.csv)
  refuses 2 "gauss-chebyshev has no profile" solve "${paper_scene[@]}" --method gauss-chebyshev "${profile[@]}"
  refuses 2 "is not allowed" solve --friction 0.6 --traction 0.7 --peclet 100 "${profile[@]}"
  refuses 1 "coupled: no solution found" \
    solve --friction 0.6 --traction 0.5 --peclet 100 --heating 1e6 "${profile[@]}"
  refuses 1 "cannot write nowhere/file" solve "${paper_scene[@]}" --output nowhere/file "${profile[@]}"
  refuses 1 "cannot write nowhere/p.csv" \
    solve "${paper_scene[@]}" --output result --profile nowhere/p.csv
  refuses 1 "cannot write nowhere/p.csv" solve "${paper_scene[@]}" --profile nowhere/p.csv
  refuses 2 "--profile and --output are the same file, one" \
    solve "${paper_scene[@]}" --output one --profile one
  refuses 2 "--profile and --output are the same file, ./one" \
    solve "${paper_scene[@]}" --output ./one --profile one
  status=0
  "$program" solve "${paper_scene[@]}" "${profile[@]}" >/dev/full 2>err || status=$?
  [ $status -eq 1 ] || fail "status $status on a full device"
  [ "$(ls)" = "$(printf '%s\n' err out)" ] || fail "left behind: $(ls)"
  run solve "${paper_scene[@]}" --output result "${profile[@]}"
  [ "$(ls)" = "$(printf '%s\n' err out p.csv result)" ] || fail "written: $(ls)"
}

# --- Results, continued ---------------------------------------------------------------------------

ClosedFormGivesTheConvergedMaximum() {
  answers solve "${paper_scene[@]}" --method closed-form --format json
  near "$(value max_temperature)" 0.0020527 5e-8
  near "$(value stick_slip_border)" "$(calculate '2 * sqrt(1 - 0.5 / 0.6) - 1')" 1e-15
  near "$(value creep)" "$(calculate '1.2 / pi * (1 - sqrt(1 - 0.5 / 0.6))')" 1e-15
  [ "$(value nodes) $(value outer_iterations) $(value unknowns)" = "null 0 null" ] ||
    fail "iterations in the closed form: $(cat out)"
}

JsonHasItsKeysInOrder() {
  local case="method model reason formulation friction traction peclet heating nodes"
  case="$case roller direction heating_2 conductivity_ratio peclet_2 effusivity_ratio bulk_difference"
  case="$case friction_law friction_temperature friction_floor friction_reference_temperature branch"
  local bounded="stick_slip_border creep_constant creep load_ratio gamma0 eccentricity heat_integral"
  bounded="$bounded max_temperature max_temperature_at heat_1 heat_2"
  local limits="friction_min traction_limit creep_at_traction_limit"
  local crossing="exchanged_heat no_slip_traction no_slip_creep edge_log_coefficient"
  local end="heat_partition $crossing full_slip $limits outer_iterations inner_iterations unknowns newton_iterations converged admissible violations"
  end="$end error_estimate"
  local physical="physical half_width radius creep_ratio hertz_pressure max_pressure max_traction"
  physical="$physical max_heat_flux max_temperature_celsius half_width_over_radius dissipation tangential_load max_temperature_at_m"
  physical="$physical heat_1 heat_2 exchanged_heat contact_temperature_celsius no_slip_tangential_load no_slip_creep_ratio tangential_load_limit creep_ratio_at_limit error_estimate"
  local data="data_in_si load speed half_width shear_modulus poisson expansion diffusivity conductivity"
  keys() { grep -o '^ *"[a-z0-9_]*":' out | tr -d ' ":' | paste -sd' '; }
  answers solve "${paper_scene[@]}" "${published[@]}" --format json
  [ "$(keys)" = "$case $bounded $end" ] || fail "keys: $(keys)"
  answers solve "${paper_scene[@]}" --method closed-form --format json
  [ "$(keys)" = "$case $bounded $end traction $bounded $crossing $limits" ] || fail "keys: $(keys)"
  answers solve "${steel[@]}" --half-width 5.5e-3 --format json
  local errors=${physical#physical }
  [ "$(keys)" = "$case $bounded $end traction $bounded $crossing $limits $physical ${errors% error_estimate} notes $data" ] || fail "keys: $(keys)"
  answers solve "${steel[@]}" --half-width 5.5e-3 "${published[@]}" --format json
  [ "$(keys)" = "$case $bounded $end $physical notes $data" ] || fail "keys: $(keys)"
}

SecondRunGivesTheSameBytes() {
  local method format
  for method in $methods; do
    for format in text json csv; do
      answers solve "${paper_scene[@]}" --method $method --format $format
      mv out first
      answers solve "${paper_scene[@]}" --method $method --format $format
      cmp first out || fail "$method $format differs"
    done
    answers temperature "${paper_scene[@]}" --method $method --at -1:3:9
    mv out first
    answers temperature "${paper_scene[@]}" --method $method --at -1:3:9
    cmp first out || fail "temperature by $method differs"
  done
}

# Header and row of the CSV, turned, are the lines of the JSON without its punctuation.
CsvSaysWhatJsonSays() {
  turned() { paste -d' ' <(head -1 out | tr , '\n') <(tail -1 out | tr , '\n'); }
  local case method
  for method in $methods; do
    answers solve "${steel[@]}" --half-width 5.5e-3 --method $method --format json
    local pair="roller\|direction\|heating_2\|conductivity_ratio\|peclet_2\|effusivity_ratio\|bulk_difference\|exchanged_heat\|no_slip_[a-z_]*\|edge_log_coefficient\|heat_[12]\|heat_partition\|full_slip"
    pair="$pair\|friction_law\|friction_temperature\|friction_floor\|friction_reference_temperature\|branch"
    pair="$pair\|friction_min\|traction_limit\|creep_at_traction_limit\|contact_temperature_celsius\|tangential_load_limit\|creep_ratio_at_limit"
    sed -n '/^  "data_in_si": {$/,/^  }$/d; /^ *"\('"$pair"'\)":/d; s/^ *"\(error_estimate\|physical\)": {$/in \1/p; s/^ *"\([a-z0-9_]*\)": "\{0,1\}\([^",{]*\).*/\1 \2/p; s/^  *}.*/out/p' out |
      awk '$1 == "in" { prefix = prefix $2 "."; next } $1 == "out" { sub(/[a-z_]*\.$/, "", prefix); next }
           { key = $1; sub(/^[^ ]* /, ""); print prefix key, $0 == "null" || $0 == "[]" ? "" : $0 }' |
      grep -v 'error_estimate $' >expected
    answers solve "${steel[@]}" --half-width 5.5e-3 --method $method --format csv
    [ "$(wc -l <out)" -eq 2 ] || fail "$(wc -l <out) lines"
    head -1 out >header.$method
    turned | if [ $method != gauss-chebyshev ]; then cat; else grep -v 'error_estimate'; fi | diff expected - ||
      fail "CSV and JSON differ for $method"
  done
  cmp header.closed-form header.gauss-chebyshev || fail "the columns depend on the method"
  cmp header.closed-form header.coupled || fail "the columns depend on the method"
}

# What two bodies have added is in no column, unless the roller conducts.
InsulatedRollersKeepTheirColumns() {
  columns() { head -1 out | tr ',' '\n'; }
  answers solve "${paper_scene[@]}" --format csv
  columns >insulated
  ! grep -Ex 'roller|direction|full_slip|.*heat(ing)?_([12]|partition)|conductivity_ratio|peclet_2|effusivity_ratio|bulk_difference|exchanged_heat|no_slip_.*|edge_log.*' insulated ||
    fail "new columns"
  answers solve --friction 0.6 --traction -0.5 --peclet 5000 --roller insulated --format csv
  columns | cmp - insulated || fail "braking has other columns"
  answers solve "${paper_scene[@]}" --roller identical --format csv
  local new="roller direction heating_2 conductivity_ratio peclet_2 effusivity_ratio bulk_difference heat_1 heat_2 heat_partition"
  new="$new exchanged_heat no_slip_traction no_slip_creep edge_log_coefficient full_slip"
  [ "$(columns | grep -vxFf insulated | paste -sd' ')" = "$new error_estimate.heat_1 error_estimate.heat_2 error_estimate.exchanged_heat error_estimate.no_slip_traction error_estimate.no_slip_creep error_estimate.edge_log_coefficient" ] ||
    fail "$(columns)"
  [ "$(columns | grep -xFf insulated)" = "$(cat insulated)" ] || fail "another order: $(columns)"
}

# The heats in W/m add up to the power lost to friction; the text, the table and the JSON have the same.
HeatsInSi() {
  local warm columns="physical.heat_1 physical.heat_2 physical.exchanged_heat physical.dissipation physical.error_estimate.heat_1"
  local pair=("${steel[@]}" --half-width 5.5e-3 --roller conducting --conductivity-2 30
    --expansion-2 1.1e-5 --bulk-temperature 20)
  for warm in 20 60; do
    answers solve "${pair[@]}" --bulk-temperature-2 $warm --format csv
    cut_columns() { awk -F, -v names="$columns" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
      { n = split(names, name, " "); for (i = 1; i <= n; ++i) printf "%s ", $at[name[i]] }' out; }
    read -r one two crosses lost error <<<"$(cut_columns | sed 's/  / none /')"
    near "$(calculate "$one + $two")" "$lost" "$(calculate "1e-4 * $lost")"
    [ "$crosses" = none ] && [ $warm = 20 ] || near "$(calculate "$crosses / 1e5")" "$(calculate "$one / 1e5 - 50 / 80 * $lost / 1e5")" 1e-3
    cp out table
    answers solve "${pair[@]}" --bulk-temperature-2 $warm --format json
    sed -n '/"physical"/,$p' out | grep -q "\"heat_1\": $one,$" || fail "$one: $(cat out)"
    answers solve "${pair[@]}" --bulk-temperature-2 $warm
    grep -q "^heat_1  *$(printf %.6g "$one")" out || fail "$one: $(cat out)"
  done
  answers solve "${steel[@]}" --half-width 5.5e-3 --format csv
  ! head -1 out | grep -q 'physical.heat_1' || fail "$(head -1 out)"
}

# Nothing slips without traction or creep: the answer is exact, and it is cold.
ZeroTractionAndCreep() {
  local given key scene=(--friction 0.6 --peclet 100 --heating 1)
  for given in "--traction 0" "--creep 0" "--traction -0"; do
    answers solve $given "${scene[@]}" --format json --profile profile.csv
    [ "$(value traction) $(value creep) $(value stick_slip_border) $(value load_ratio) $(value full_slip)" = \
      "0.0 0.0 1.0 1.0 false" ] || fail "$(cat out)"
    for key in gamma0 eccentricity heat_integral max_temperature; do
      [ "$(value $key)" = 0.0 ] || fail "$key: $(cat out)"
    done
    ! sed -n '/"error_estimate"/,$p' out | grep -q ': .*[1-9]' || fail "an error: $(cat out)"
    awk -F, 'NR > 1 { p += ($2 + last) / 2 * ($1 - s); s = $1; last = $2; if ($3 != 0 || $4 != 0 || $6 != 0) exit 1 }
      NR == 1 { s = -1 } END { exit !(p > 0.999 && p < 1.001) }' profile.csv || fail "$(cat profile.csv)"
    for depth in 0 0.1; do
      answers temperature $given "${scene[@]}" --at 0,1,2 --depth $depth
      [ "$(sed 1d out | cut -d, -f2 | sort -u)" = 0 ] || fail "$(cat out)"
    done
  done
  answers solve "${steel[@]:0:2}" --traction 0 "${steel[@]:4}" --radius 0.45 --format json
  near "$(value half_width)" "$(calculate 'sqrt(4 * 0.7 * 0.45 * 1.2e7 / (pi * 8.1e10))')" 1e-12
  [ "$(value max_traction) $(value max_heat_flux) $(value dissipation)" = "0.0 0.0 0.0" ] || fail "$(cat out)"
  near "$(value max_pressure)" "$(value hertz_pressure)" 1e-3
  refuses 2 "traction = 0 is not allowed: it must be above 0" \
    solve --traction 0 "${scene[@]}" --method gauss-chebyshev
  refuses 2 "tolerance = 1 is not allowed" solve --traction 0 "${scene[@]}" --tolerance 1
}

# With constant friction its own traction belongs to all creeps from full slip on.
TractionOfTheFriction() {
  local scene=(--friction 0.6 --peclet 100)
  refuses 2 "traction = 0.6 is the friction: the whole contact slips, and the creep is not determined; it is at least 0.3819" \
    solve --traction 0.6 "${scene[@]}"
  refuses 2 "traction = -0.6 is the friction: the whole contact slips, and the creep is not determined; it is at most -0.3819" \
    solve --traction -0.6 "${scene[@]}"
  refuses 2 "it is at least 6.366e-06" solve --friction 1e-5 --traction 1e-5 --peclet 100
  refuses 2 "traction = 0.61 is not allowed: it must be between -0.6 and 0.6, the friction" \
    solve --traction 0.61 "${scene[@]}"
}

# A law of friction: its traction in full slip, the two solutions at one traction with the maximum
# above them, and the same with true signs where the wheel brakes.
Laws() {
  local scene=(--friction 0.6 --peclet 100 --heating 0.0175 --format json)
  local law=(--friction-law linear --friction-temperature 0.02)
  answers solve --creep 0.5 "${scene[@]}" "${law[@]}"
  near "$(value traction)" 0.29480 5e-6
  [ "$(value full_slip) $(value friction_law) $(value friction_temperature) $(value friction_floor)" = \
    "true linear 0.02 0.0" ] || fail "$(cat out)"
  [ "$(value friction_reference_temperature) $(value branch) $(value traction_limit)" = "0.0 null null" ] ||
    fail "$(cat out)"
  # friction is least where it is hottest
  near "$(value friction_min)" "$(calculate "0.6 * (1 - $(value max_temperature) / 0.02)")" 1e-15
  local sign branch rising falling
  for sign in "" -; do
    answers solve --traction ${sign}0.39 "${scene[@]}" "${law[@]}"
    [ "$(value branch)" = rising ] || fail "$(cat out)"
    rising=$(value creep)
    cp out first
    answers solve --traction ${sign}0.39 "${scene[@]}" "${law[@]}" --branch rising
    cmp out first || fail "rising is not the default"
    local limit at error
    limit=$(value traction_limit) at=$(value creep_at_traction_limit)
    error=$(sed -n 's/^ *"traction_limit": //p' out | tail -1 | tr -d ,)
    answers solve --traction ${sign}0.39 "${scene[@]}" "${law[@]}" --branch falling
    [ "$(value branch)" = falling ] || fail "$(cat out)"
    # the maximum is found on the grids of the solution asked for; both are within their errors
    near "$(value traction_limit)" "$limit" \
      "$(calculate "$error + $(sed -n 's/^ *"traction_limit": //p' out | tail -1 | tr -d ,)")"
    falling=$(value creep)
    awk -v s="${sign}1" -v a="$rising" -v b="$at" -v c="$falling" -v q="$limit" \
      'BEGIN { exit !(0 < s * a && s * a < s * b && s * b < s * c && s * q > 0.39 && s * q < 0.6) }' ||
      fail "$rising $at $falling $limit"
    answers solve --creep "$at" "${scene[@]}" "${law[@]}"
    near "$(value traction)" "$limit" 1e-6
    answers solve --creep "$falling" "${scene[@]}" "${law[@]}"
    near "$(value traction)" ${sign}0.39 1e-6
  done
  refuses 2 "traction = 0.5 is not allowed: it must be at most 0.3977" \
    solve --traction 0.5 "${scene[@]}" "${law[@]}"
  refuses 2 "traction = -0.5 is not allowed: it must be at least -0.3975" \
    solve --traction -0.5 "${scene[@]}" "${law[@]}"
  # friction that rises bears more than f, and none above the reference temperature is constant
  answers solve --traction 0.7 "${scene[@]}" --friction-law linear --friction-temperature -0.01
  [ "$(value traction_limit)" = null ] || fail "$(cat out)"
  answers solve --creep 0.1 "${scene[@]}" --method coupled
  local constant
  constant=$(value traction)
  run solve --creep 0.1 "${scene[@]}" "${law[@]}" --friction-reference-temperature 1
  [ $status -eq 0 ] || fail "reference: $(cat err)"
  near "$(value traction)" "$constant" 1e-6
  [ "$(value friction_min) $(value friction_reference_temperature)" = "0.6 1.0" ] || fail "$(cat out)"
  local kind last=""
  for kind in exponential rational piecewise-linear linear; do
    answers solve --creep 0.1 "${scene[@]}" --friction-law $kind --friction-temperature 0.02 --friction-floor 0.5
    [ "$(value friction_law) $(value friction_floor)" = "$kind 0.5" ] || fail "$(cat out)"
    [ "$(value traction)" != "$last" ] || fail "$kind is as another"
    last=$(value traction)
  done
  # the text has the law, and its numbers with their errors
  answers solve --traction 0.39 "${scene[@]:0:6}" "${law[@]}" --branch falling
  for line in 'friction_law  *linear' 'friction_temperature  *T0\*  *0.02' 'branch  *falling' \
    'friction_min  *0.[0-9]*  *[0-9]e-' 'traction_limit  *0.3977[0-9]*  *[0-9]e-' \
    'creep_at_traction_limit  *0.2353[0-9]*  *[0-9]e-'; do
    grep -q "^$line" out || fail "no $line: $(cat out)"
  done
  answers solve --creep 0.5 "${scene[@]:0:6}" "${law[@]}"
  grep -q '^full_slip  *true$' out || fail "$(cat out)"
  # as CSV the columns are those of a law, and only with a law
  columns() { head -1 out | tr ',' '\n'; }
  answers solve --creep 0.3 "${scene[@]:0:6}" --format csv
  columns >constant
  answers solve --creep 0.3 "${scene[@]:0:6}" "${law[@]}" --format csv
  local limits="friction_min traction_limit creep_at_traction_limit"
  local new="friction_law friction_temperature friction_floor friction_reference_temperature branch full_slip $limits"
  [ "$(columns | grep -vxFf constant | paste -sd' ')" = "$new error_estimate.${limits// / error_estimate.}" ] ||
    fail "$(columns)"
}

# In SI units: K and degree C in place of T*, with the half-width or the radius given; the bulk
# temperature shifts the reference and the absolute temperature only. (The reference is below the
# bulk, so that the law has no kink.)
LawInSiUnits() {
  local data=(--friction 0.6 --creep 0.15 "${steel[@]:4}" --tolerance 1e-8)
  local si=("${data[@]}" --format json)
  answers solve "${si[@]}" --half-width 5.5e-3
  [ "$(value contact_temperature_celsius)" = null ] || fail "$(cat out)"
  local unit
  unit=$(calculate "$(value max_temperature_celsius) / $(value max_temperature)")
  local law=(--friction-law exponential --friction-temperature 500 --friction-floor 0.3)
  answers solve "${si[@]}" --half-width 5.5e-3 "${law[@]}" --bulk-temperature 20 --friction-reference-temperature -10
  near "$(value friction_temperature)" "$(calculate "500 / $unit")" 1e-12
  near "$(value friction_reference_temperature)" "$(calculate "-30 / $unit")" 1e-12
  near "$(value contact_temperature_celsius)" "$(calculate "20 + $(value max_temperature_celsius)")" 1e-9
  local traction temperature radius
  traction=$(value traction) temperature=$(value max_temperature_celsius) radius=$(value radius)
  [ "$(grep -c '"contact_temperature_celsius": [0-9]' out)" -eq 2 ] || fail "no error: $(cat out)"
  local groups=(--peclet "$(value peclet)" --heating "$(value heating)")
  answers solve --friction 0.6 --creep 0.15 "${groups[@]}" --tolerance 1e-8 --friction-law exponential --friction-floor 0.3 \
    --friction-temperature "$(calculate "500 / $unit")" --friction-reference-temperature "$(calculate "-30 / $unit")" --format json
  near "$(value traction)" "$traction" 1e-7
  answers solve "${si[@]}" --half-width 5.5e-3 "${law[@]}" --bulk-temperature 100 --friction-reference-temperature 70
  near "$(value traction)" "$traction" 1e-12
  near "$(value contact_temperature_celsius)" "$(calculate "100 + $temperature")" 1e-9
  # the unit of temperature changes with the half-width, and the law in degree C does not
  answers solve "${si[@]}" --radius "$radius" "${law[@]}" --bulk-temperature 20 --friction-reference-temperature -10
  near "$(value traction)" "$traction" 1e-7
  near "$(value max_temperature_celsius)" "$temperature" 1e-4
  answers solve "${data[@]}" --half-width 5.5e-3 "${law[@]}" --bulk-temperature 20
  grep -q '^contact_temperature_celsius  *[0-9.]*  *[0-9.e-]*  *degree C$' out || fail "$(cat out)"
  answers solve "${data[@]}" --format csv --half-width 5.5e-3 --bulk-temperature 20
  head -1 out | grep -q ',physical.contact_temperature_celsius,.*,physical.error_estimate.contact_temperature_celsius,' ||
    fail "$(cat out)"
}

BadLaws() {
  local scene=(--friction 0.6 --peclet 100 --traction 0.3) si=("${steel[@]}" --half-width 5.5e-3)
  local linear=(--friction-law linear --friction-temperature 0.02) option
  refuses 2 "friction-law = wood is not allowed: it must be constant or linear or exponential or rational or piecewise-linear" \
    solve "${scene[@]}" --friction-law wood
  for option in "--friction-temperature 1" "--friction-floor 0.1" "--friction-reference-temperature 0" "--branch rising"; do
    refuses 2 "constant friction has none of these: ${option% *}; a --friction-law that is not constant is needed" \
      solve "${scene[@]}" $option
  done
  refuses 2 "is needed; the traction is between -0.6 and 0.6" solve "${scene[@]}" --branch falling
  refuses 2 "--friction-law rational lacks --friction-temperature" solve "${scene[@]}" --friction-law rational
  refuses 2 "friction-temperature = 0 is not allowed" solve "${scene[@]}" --friction-law linear --friction-temperature 0
  for option in "--creep 0.1" "--traction 0.1"; do
    refuses 1 "; friction is zero at T* = 0.5, at which the bodies meet" solve --friction 0.6 --peclet 100 --heating 0.01 \
      --roller identical --bulk-difference 1 --friction-law linear --friction-temperature 0.4 $option
  done
  local kind floor
  for kind in exponential rational piecewise-linear; do
    refuses 2 "friction-temperature = -0.02 is not allowed: it must be positive" \
      solve "${scene[@]}" --friction-law $kind --friction-temperature -0.02
  done
  for floor in -0.1 1.1; do
    refuses 2 "friction-floor = $floor is not allowed: it must be from 0 to 1" \
      solve "${scene[@]}" "${linear[@]}" --friction-floor $floor
  done
  run solve "${scene[@]}" "${linear[@]}" --friction-floor 1
  [ $status -eq 0 ] && grep -qx 'thermoroll: note: friction does not change (its floor is all of it)' err || fail "$(cat err)"
  run solve "${scene[@]}" --friction-law linear --friction-temperature -0.02 --friction-floor 1
  [ $status -eq 0 ] && [ "$(cat err)" = "thermoroll: note: --friction-floor makes no difference to friction that rises" ] ||
    fail "it rises: $(cat err)"
  local constant="thermoroll: note: friction does not change"
  run solve "${si[@]}" --friction-law linear --friction-temperature 500 --bulk-temperature 20 --friction-reference-temperature 293
  [ $status -eq 0 ] && [ "$(cat err)" = "$constant (the contact is nowhere as hot as its reference temperature)" ] ||
    fail "in K: $(cat err)"
  run solve "${si[@]:0:2}" --traction 0.2 "${si[@]:4}" --friction-law linear --friction-temperature 100 --friction-floor 0.4 --bulk-temperature 293 --friction-reference-temperature 20
  [ $status -eq 0 ] && [ "$(tail -1 err)" = "$constant (all of the contact is so hot that it is at its floor)" ] &&
    [ "$(head -1 err)" = "thermoroll: note: a bulk temperature of 293 would be that of a room in K: is it in degree C?" ] ||
    fail "bulk in K: $(cat err)"
  run solve "${scene[@]}" "${linear[@]}" --friction-reference-temperature 0.5
  [ $status -eq 0 ] && [ "$(cat err)" = "$constant (the contact is nowhere as hot as its reference temperature)" ] ||
    fail "in T*: $(cat err)"
  for option in "--creep 0.1 --friction-reference-temperature 0.001" "--creep 0"; do
    run solve "${scene[@]:0:4}" --heating 0.0175 --roller identical "${linear[@]}" $option
    [ $status -eq 0 ] && [ ! -s err ] || fail "$option: $(cat err)"
  done
  refuses 2 "the share of friction at the bulk temperature = 0 is not allowed: it must be positive: a floor or a higher reference temperature leaves some" \
    solve "${scene[@]}" "${linear[@]}" --friction-reference-temperature -0.03
  refuses 2 "friction-floor = -0.1 is not allowed: it must be zero or positive" \
    solve "${scene[@]}" --friction-law piecewise-linear --friction-temperature 0.02 --friction-floor -0.1
  answers solve "${scene[@]}" --friction-law piecewise-linear --friction-temperature 0.02 --friction-floor 1.1
  refuses 2 "friction-temperature = nan is not allowed: it must be a finite number" \
    solve "${scene[@]}" --friction-law linear --friction-temperature nan
  refuses 2 "friction-temperature = 0 is not allowed" \
    solve "${si[@]}" --friction-law linear --friction-temperature 0
  refuses 2 "branch = up is not allowed: it must be rising or falling" solve "${scene[@]}" "${linear[@]}" --branch up
  for option in "--creep 0.1" "--stick-slip-border 0"; do
    refuses 2 "--branch is for a given traction only" \
      solve "${scene[@]:0:4}" $option "${linear[@]}" --branch falling
  done
  refuses 2 "branch = falling does not exist: the traction has no maximum; it is between 0 and " \
    solve "${scene[@]}" --friction-law linear --friction-temperature -1 --branch falling
  refuses 2 "branch = falling is not allowed: without traction nothing slips" \
    solve "${scene[@]:0:4}" --traction 0 "${linear[@]}" --branch falling
  local method
  for method in closed-form first-order gauss-chebyshev; do
    refuses 2 "friction that depends on temperature needs the method coupled or auto" \
      solve "${scene[@]}" "${linear[@]}" --method $method
  done
  refuses 2 "for data in SI units only: --bulk-temperature" solve "${scene[@]}" --bulk-temperature 20
  refuses 2 "bulk-temperature = -300 is not allowed: it must be at least -273.15 degree C" \
    solve "${si[@]}" --bulk-temperature -300
  refuses 2 "--friction-reference-temperature in degree C needs --bulk-temperature" \
    solve "${si[@]}" --friction-law linear --friction-temperature 500 --friction-reference-temperature 50
}

# Negative traction or creep brakes, and a border as it is said; the answer has true signs.
Braking() {
  local scene=(--friction 0.6 --peclet 100 --heating 1 --format json)
  answers solve --traction -0.5 "${scene[@]}"
  cp out brakes
  [ "$(value direction) $(value traction)" = "braking -0.5" ] || fail "$(cat out)"
  local border creep
  border=$(value stick_slip_border) creep=$(value creep)
  awk -v x="$creep" 'BEGIN { exit !(x < 0) }' || fail "creep $creep"
  answers solve --traction -0.5 --direction braking "${scene[@]}"
  cmp out brakes || fail "--direction changes what the sign says"
  answers solve --creep "$creep" --direction braking "${scene[@]}"
  near "$(value traction)" -0.5 1e-6
  answers solve --stick-slip-border "$border" --direction braking "${scene[@]}"
  near "$(value traction)" -0.5 1e-6
  near "$(value creep)" "$creep" 1e-6
  answers solve --stick-slip-border "$border" "${scene[@]}"
  [ "$(value direction)" = driving ] || fail "$(cat out)"
  awk -v x="$(value traction)" 'BEGIN { exit !(x > 0) }' || fail "$(cat out)"
  answers solve --traction -0.5 --friction 0.6 --peclet 100 --heating 1
  grep -q '^direction  *braking$' out || fail "$(cat out)"
  answers solve --traction 0.5 --direction driving --friction 0.6 --peclet 100
  ! grep -q '^direction' out || fail "$(cat out)"
  refuses 2 "--direction driving contradicts --traction -0.5: it is positive for driving and negative for braking" \
    solve --traction -0.5 --direction driving "${scene[@]}"
  refuses 2 "--direction braking contradicts --creep 0.1: " solve --creep 0.1 --direction braking "${scene[@]}"
  refuses 2 "direction = back is not allowed: it must be driving or braking" \
    solve --traction 0.5 --direction back "${scene[@]}"
  refuses 2 "gauss-chebyshev is for an insulated cylinder that drives" \
    solve --traction -0.5 "${scene[@]}" --method gauss-chebyshev
  # the half-width of a radius belongs to the direction
  local si=("${steel[@]:0:2}" --stick-slip-border 0.1 "${steel[@]:4}" --direction braking --format json)
  answers solve "${si[@]}" --radius 0.2
  local size traction
  size=$(value half_width) traction=$(value traction)
  near "$(value radius)" 0.2 1e-7
  [ "$(value direction)" = braking ] || fail "$(cat out)"
  answers solve "${si[@]}" --half-width "$size"
  near "$(value traction)" "$traction" 1e-9
}

# A roller that conducts: its words, its data in both kinds, and the heat of either body.
Rollers() {
  local scene=(--friction 0.6 --traction 0.4 --peclet 100 --heating 1 --format json)
  answers solve "${scene[@]}"
  [ "$(value roller) $(value heating_2) $(value conductivity_ratio) $(value heat_partition) $(value full_slip)" = \
    "insulated null null 1.0 false" ] || fail "$(cat out)"
  [ "$(value heat_1) $(value heat_2)" = "$(value heat_integral) 0.0" ] || fail "$(cat out)"
  answers solve "${scene[@]}" --roller identical
  cp out identical
  [ "$(value roller) $(value heating_2) $(value conductivity_ratio) $(value heat_partition)" = \
    "identical 1.0 1.0 0.5" ] || fail "$(cat out)"
  near "$(value heat_1)" "$(calculate "$(value heat_integral) / 2")" 1e-17
  answers solve "${scene[@]}" --roller conducting --conductivity-ratio 1 --heating-2 1
  cmp out identical || fail "the same data by another word"
  answers solve "${scene[@]}" --roller conducting --conductivity-ratio 1 --heating-2 2
  [ "$(value roller)" = conducting ] || fail "another expansion is not identical: $(cat out)"
  answers solve "${scene[@]}" --roller conducting --conductivity-ratio 0.25 --heating-2 2
  [ "$(value roller) $(value heating_2) $(value conductivity_ratio) $(value heat_partition)" = \
    "conducting 2.0 0.25 0.8" ] || fail "$(cat out)"
  near "$(value heat_2)" "$(calculate "0.2 * $(value heat_integral)")" 1e-16
  # in SI units; half of the heat makes steel half as hot, but for what heat does to the slip
  local si=("${steel[@]}" --half-width 5.5e-3)
  answers solve "${si[@]}" --format json
  local hot
  hot=$(value max_temperature_celsius)
  answers solve "${si[@]}" --roller identical --format json
  cp out identical
  near "$(value max_temperature_celsius)" "$(calculate "$hot / 2")" "$(calculate "0.01 * $hot")"
  [ "$(value roller) $(value heating_2)" = "identical $(value heating)" ] || fail "$(cat out)"
  answers solve "${si[@]}" --roller conducting --conductivity-2 50 --expansion-2 1.1e-5 --format json
  cmp out identical || fail "the same data by another word"
  answers solve "${si[@]}" --roller conducting --conductivity-2 25 --expansion-2 2.2e-5 \
    --diffusivity-2 1.4e-5 --format json
  near "$(value heating_2)" "$(calculate "4 * $(value heating)")" 1e-16
  near "$(value conductivity_ratio)" 0.5 0
  # the text tells the roller, and whom it warms
  answers solve "${si[@]}" --roller identical
  local line
  for line in 'roller  *identical' 'heating_2  *H2  *0.017472' 'conductivity_ratio  *K2/K1  *1' \
    'heat_partition  *omega  *0.5'; do
    grep -q "^$line\$" out || fail "no $line: $(cat out)"
  done
  ! grep -q 'half as hot' out || fail "they are: $(cat out)"
  answers solve "${si[@]}"
  grep -q '^All heat goes into one body' out && grep -q 'about half as hot' out || fail "$(cat out)"
  answers solve "${paper_scene[@]}"
  ! grep -q 'half as hot' out || fail "a remark on degrees without any"
}

# A hot wheel on a cold rail: the references of test_exchange.cpp, the same in SI units, bad input.
BulkDifference() {
  local scene=(--friction 0.6 --stick-slip-border -0.1845 --peclet 100 --heating 1 --roller identical)
  answers solve "${scene[@]}" --bulk-difference 0.01 --tolerance 1e-8 --format json
  near "$(value traction)" 0.4956062305 2e-8
  near "$(value creep)" 0.2421004871 2e-8
  near "$(value heat_1)" 0.2004185195 2e-8
  near "$(value exchanged_heat)" "$(calculate "0.2004185195 - 0.1750202899 / 2")" 2e-8
  [ "$(value heat_partition) $(value edge_log_coefficient)" = "null 0.0" ] || fail "$(cat out)"
  near "$(value no_slip_creep)" "$(calculate "0.6 * 0.01 * sqrt(100 / pi)")" 1e-3
  local fine="$(value no_slip_traction)"
  answers solve "${scene[@]}" --bulk-difference 0.01 --tolerance 1e-2 --format json
  local rough="$(value no_slip_traction)"
  [ "$rough" != "$fine" ] || fail "no rougher than asked for"
  sed -i '1,/error_estimate/d' out
  near "$rough" "$fine" "$(value no_slip_traction)"
  answers solve "${scene[@]}" --bulk-difference 0.01
  local name
  for name in exchanged_heat no_slip_traction no_slip_creep; do
    grep -qE "^$name +[0-9.e-]+ +[0-9]+e-[0-9]+$" out || fail "no error of $name: $(cat out)"
  done
  # The direction of a traction or creep is that from the state without slip.
  refuses 2 "--direction is for a given border where bulk temperatures differ" \
    solve --friction 0.6 --creep 0.1 --peclet 100 --heating 1 --roller identical --bulk-difference 0.01 --direction driving
  # An aluminium roller much hotter than steel: the curve says where contact is lost; at 400 K it is lost
  # within a thousandth of the half-width from the leading edge.
  local aluminium=(--friction 0.3 --load 1.2e7 --half-width 7.8e-3 --shear-modulus 8.1e10 --poisson 0.3 --expansion 1.1e-5
    --diffusivity 1.4e-5 --conductivity 50 --roller conducting --conductivity-2 200 --expansion-2 2.3e-5 --diffusivity-2 8.5e-5
    --speed 20 --bulk-temperature 20)
  run creep-curve "${aluminium[@]}" --bulk-temperature-2 300 --points 3
  [ $status -eq 0 ] || fail "$status: $(cat err)"
  grep -q 'note: the curve ends at the creep ratio -0.0045.*: contact is lost' err || fail "no end: $(cat err)"
  grep -q 'note: the curve ends at the creep ratio 0.0046.*: contact is lost' err || fail "no other end: $(cat err)"
  run creep-curve "${aluminium[@]}" --bulk-temperature-2 300 --points 3 --from-ratio -0.001 --to-ratio 0.001
  [ $status -eq 0 ] || fail "$status: $(cat err)"
  ! grep -q 'the curve ends' err || fail "an end that was asked for: $(cat err)"
  answers solve "${aluminium[@]}" --bulk-temperature-2 120 --creep-ratio 0.001
  for name in heat_1 heat_2 exchanged_heat; do
    grep -qE "^$name .* W/m$" out || fail "no W/m of $name: $(cat out)"
  done
  run solve "${aluminium[@]}" --bulk-temperature-2 420 --creep-ratio 0.001
  [ $status -eq 5 ] && grep -q 'separation at s = -0.999.* to -0.999' err || fail "$status: $(cat err)"
  answers solve "${aluminium[@]}" --bulk-temperature-2 20 --creep-ratio 0.001 --direction driving
  # The singular flux at the edge is that of conduction alone; the slope that it bends has the sign of
  # the formulation, @eq:edge-logarithm.
  local unlike=(--friction 0.6 --stick-slip-border 0 --peclet 20 --heating 0.7 --roller conducting
    --conductivity-ratio 0.5 --heating-2 1 --peclet-2 100 --bulk-difference 0.001 --tolerance 1e-4 --format json)
  answers solve "${unlike[@]}" --formulation corrected
  local corrected="$(value edge_log_coefficient)"
  "$program" solve "${unlike[@]}" --formulation printed >out 2>/dev/null || fail "$(cat out)"
  near "$(calculate "-1 * ($(value edge_log_coefficient))")" "$corrected" 1e-6
  answers solve "${unlike[@]/#0.6/0.7}"  # in proportion to the friction
  near "$(calculate "0.6 / 0.7 * ($(value edge_log_coefficient))")" "$corrected" 1e-6
  answers solve "${steel[@]}" --half-width 5.5e-3 --roller identical --bulk-temperature 20 \
    --bulk-temperature-2 120 --format json
  local unit=$(calculate "$(value max_temperature_celsius) / $(value max_temperature)")
  near "$(value bulk_difference)" "$(calculate "100 / $unit")" 1e-9
  refuses 2 "bulk-difference = 0.01 is not allowed: it must be 0, as the roller is an insulator" \
    solve --friction 0.6 --traction 0.4 --peclet 100 --heating 1 --bulk-difference 0.01
  refuses 2 "for data in SI units only: --bulk-temperature-2" solve "${scene[@]}" --bulk-temperature-2 10
  refuses 2 "data in SI units exclude --bulk-difference" \
    solve "${steel[@]}" --half-width 5.5e-3 --roller identical --bulk-difference 0.01
  refuses 2 "--bulk-temperature-2 needs a --roller that conducts heat" \
    solve "${steel[@]}" --half-width 5.5e-3 --bulk-temperature 20 --bulk-temperature-2 10
  refuses 2 "--bulk-temperature-2 needs --bulk-temperature" \
    solve "${steel[@]}" --half-width 5.5e-3 --roller identical --bulk-temperature-2 10
  refuses 2 "a bulk difference needs the method coupled or auto" \
    solve "${scene[@]}" --bulk-difference 0.01 --method first-order
}

# Data of unlike bodies in SI units are those in groups; the total heat is shared by the effusivities.
UnlikeRollers() {
  local pair=(--roller conducting --conductivity-ratio 2 --heating-2 0.7 --peclet-2 20)
  local scene=(--friction 0.6 --stick-slip-border -0.1845 --peclet 100 --heating 1)
  answers solve "${scene[@]}" "${pair[@]}" --tolerance 1e-9 --format json
  near "$(value traction)" 0.4931146464525543 2e-9
  near "$(value heat_1)" 0.09449678871143838 1e-9
  near "$(value heat_partition)" "$(calculate "1 / (1 + 2 * sqrt(0.2))")" 1e-15
  near "$(value effusivity_ratio)" "$(calculate "2 * sqrt(0.2)")" 1e-15
  [ "$(value model) $(value roller) $(value peclet_2)" = "coupled conducting 20.0" ] || fail "$(cat out)"
  answers solve --friction 0.6 --stick-slip-border -0.1845 --peclet 2 --heating 1 "${pair[@]/#20/0.5}" \
    --tolerance 1e-9 --format json
  near "$(value traction)" 0.5044965880771926 2e-9
  near "$(value heat_1)" 0.0905927482340755 1e-8
  local si=("${steel[@]}" --half-width 5.5e-3 --roller conducting --conductivity-2 70 --expansion-2 2.3e-5)
  answers solve "${si[@]}" --diffusivity-2 8e-5 --format json
  near "$(value peclet_2)" "$(calculate "22.2 * 5.5e-3 / (2 * 8e-5)")" 1e-10
  near "$(value heating_2)" "$(calculate "2 * 2.3e-5 * 1.3 * 8e-5 * 1.2e7 / (5.5e-3 * 70)")" 1e-15
  answers solve "${si[@]}" --diffusivity-2 1.4e-5 --format json
  mv out same
  answers solve "${si[@]}" --format json
  cmp out same || fail "the same diffusivity makes a difference"
}

BadRollers() {
  local scene=(--friction 0.6 --traction 0.4 --peclet 100 --heating 1) si=("${steel[@]}" --half-width 5.5e-3)
  refuses 2 "roller = wood is not allowed: it must be insulated or identical or conducting" \
    solve "${scene[@]}" --roller wood
  local kind
  for kind in insulated identical; do
    refuses 2 "--roller $kind has no data of its own; for --heating-2 say --roller conducting" \
      solve "${scene[@]}" --roller $kind --heating-2 1
    refuses 2 "--roller $kind has no data of its own; for --conductivity-2 say --roller conducting" \
      solve "${si[@]}" --roller $kind --conductivity-2 50
  done
  refuses 2 "--roller insulated has no data of its own; for --diffusivity-2" solve "${si[@]}" --diffusivity-2 1.4e-5
  local conducting=(--roller conducting)
  refuses 2 "--roller conducting lacks --conductivity-ratio --heating-2" solve "${scene[@]}" "${conducting[@]}"
  refuses 2 "--roller conducting lacks --heating-2" solve "${scene[@]}" "${conducting[@]}" --conductivity-ratio 1
  refuses 2 "--roller conducting lacks --conductivity-2 --expansion-2" solve "${si[@]}" "${conducting[@]}"
  refuses 2 "--roller conducting lacks --expansion-2" solve "${si[@]}" "${conducting[@]}" --conductivity-2 50
  refuses 2 "peclet = 0 is not allowed: it must be positive" solve --friction 0.6 --traction 0.5 --peclet 0 --heating 0.1 "${conducting[@]}" --conductivity-ratio 1 --heating-2 0.1
  refuses 2 "data in SI units exclude --heating-2" \
    solve "${si[@]}" "${conducting[@]}" --conductivity-2 50 --expansion-2 1e-5 --heating-2 1
  refuses 2 "--peclet and --heating exclude data in SI units; given: --expansion-2" \
    solve "${scene[@]}" "${conducting[@]}" --conductivity-ratio 1 --heating-2 1 --expansion-2 1e-5
  refuses 2 "diffusivity-2 = 0 is not allowed: it must be positive" \
    solve "${si[@]}" "${conducting[@]}" --conductivity-2 50 --expansion-2 1e-5 --diffusivity-2 0
  refuses 2 "peclet-2 = -1 is not allowed: it must be positive" \
    solve "${scene[@]}" "${conducting[@]}" --conductivity-ratio 1 --heating-2 1 --peclet-2 -1
  refuses 2 "--roller identical has no data of its own; for --peclet-2 say --roller conducting" \
    solve "${scene[@]}" --roller identical --peclet-2 50
  refuses 2 "bodies of unlike diffusivities need the method coupled or auto" \
    solve "${scene[@]}" "${conducting[@]}" --conductivity-ratio 1 --heating-2 1 --peclet-2 50 --method first-order
  refuses 2 "conductivity-2 = 0 is not allowed: it must be positive" \
    solve "${si[@]}" "${conducting[@]}" --conductivity-2 0 --expansion-2 1e-5
  refuses 2 "expansion-2 = -1 is not allowed: it must be zero or positive" \
    solve "${si[@]}" "${conducting[@]}" --conductivity-2 50 --expansion-2 -1
  refuses 2 "conductivity-ratio = 0 is not allowed: it must be positive" \
    solve "${scene[@]}" "${conducting[@]}" --conductivity-ratio 0 --heating-2 1
  refuses 2 "heating-2 = -1 is not allowed: it must be zero or positive" \
    solve "${scene[@]}" "${conducting[@]}" --conductivity-ratio 1 --heating-2 -1
  refuses 2 "heating-2 = nan is not allowed: it must be a finite number" \
    solve "${scene[@]}" "${conducting[@]}" --conductivity-ratio 1 --heating-2 nan
  refuses 2 "gauss-chebyshev is for an insulated cylinder that drives" \
    solve "${scene[@]}" --roller identical --method gauss-chebyshev
}

TextTellsWhatIsLeftOut() {
  answers solve "${paper_scene[@]}" --method closed-form
  grep -q 'leaves out what the heat does' out || fail "no remark: $(cat out)"
  grep -q '^max_temperature  *T\*max  *0.00205266692  *[0-9.e-]*$' out || fail "$(cat out)"
  grep -q '^load_ratio  *kappa  *1$' out || fail "an error of what is exact: $(cat out)"
  ! grep -q '^formulation' out || fail "the closed form has no thermal slope"
  answers solve "${paper_scene[@]}"
  ! grep -q 'leaves out' out || fail "a remark for the coupled solver"
  grep -q '^traction  *Q\*  *0.5$' out || fail "the given traction: $(cat out)"
  grep -q '^load_ratio  *kappa  *1.00146[0-9]*  *[0-9.e-]*$' out || fail "$(cat out)"
  answers solve "${paper_scene[@]}" "${published[@]}"
  ! grep -q 'leaves out' out || fail "a remark for the scheme"
  grep -q '^max_temperature  *T\*max  *0.00199803$' out || fail "more than six digits: $(cat out)"
  answers solve --friction 0.6 --traction 0.5 --peclet 100 --method closed-form
  ! grep -q 'leaves out' out || fail "a remark without heat"
  answers solve "${steel[@]}" --half-width 5.5e-3
  grep -q '^max_pressure  *max p  *1.387[0-9]*e+09  *[0-9.e+-]*  *Pa$' out || fail "$(cat out)"
  grep -q '^hertz_pressure  *p0  *1.38899e+09  *Pa$' out || fail "an error of what is exact: $(cat out)"
  grep -q '^max_temperature_celsius .* degree C above the half-space.s bulk$' out || fail "$(cat out)"
}

# --- Data in SI units -----------------------------------------------------------------------------

DimensionalDataGiveTheSameScene() {
  local method
  for method in $methods; do
    answers solve "${steel[@]}" --half-width 5.5e-3 --method $method --format json
    near "$(value peclet)" "$(calculate '22.2 * 5.5e-3 / 2.8e-5')" 1e-11
    near "$(value heating)" "$(calculate '2 * 1.1e-5 * 1.3 * 1.4e-5 * 1.2e7 / (5.5e-3 * 50)')" 1e-16
    sed '/"physical"/,$d' out >without
    answers solve --friction 0.6 --traction 0.5 --peclet "$(value peclet)" \
      --heating "$(value heating)" --method $method --format json
    diff <(tr -d ',' <without) <(sed '$d' out | tr -d ',') || fail "another scene: $method"
  done
}

# Each from its formula, with 17 digits; a dozen roundings are below 1e-14.
SiResultsHaveTheirUnits() {
  answers solve "${steel[@]}" --half-width 5.5e-3 --method closed-form --format json
  relative() { near "$(calculate "$(value "$1") / ($2)")" 1 1e-14; }
  local p0='(2 * 1.2e7 / (pi * 5.5e-3))' strain='(1.4 * 1.2e7 / (8.1e10 * 5.5e-3))'
  relative half_width 5.5e-3
  relative radius 'pi * 8.1e10 * 5.5e-3^2 / (4 * 0.7 * 1.2e7)'
  relative hertz_pressure "$p0"
  relative max_pressure "$p0"
  relative half_width_over_radius "$(value half_width) / $(value radius)"
  relative dissipation "$(value heat_integral) * 0.6 * 22.2 * $strain * 1.2e7"
  relative max_traction "0.6 * $p0"
  relative tangential_load '0.5 * 1.2e7'
  relative max_temperature_at_m "$(value max_temperature_at) * 5.5e-3"
  relative creep_ratio "$(value creep) * $strain"
  relative max_temperature_celsius \
    "$(value max_temperature) * 0.6 * 22.2 * $strain * 1.2e7 / 50"
  # v* p* is largest where 4 h u^2 - (3h - 2b) u - b = 0, s = c0 + 2 h u
  local b h u
  b=$(calculate 'sqrt(1 - 0.5 / 0.6)') h=$(calculate '1 - sqrt(1 - 0.5 / 0.6)')
  u=$(calculate "(3*$h - 2*$b + sqrt((3*$h - 2*$b)^2 + 16*$h*$b)) / (8*$h)")
  local flux="8 * 0.6 / pi^2 * ($b + $h * $u) * 2 * $h * sqrt($u * (1 - $u))"
  relative max_heat_flux "$flux * 0.6 * 22.2 * $strain * 1.2e7 / 5.5e-3"
}

# A modulus in GPa is told in each way in which an answer is given, and changes neither answer nor status.
NotesOnDataBeyondTheModel() {
  local in_gpa=("${steel[@]/8.1e10/81}" --half-width 5.5e-3) name
  run solve "${in_gpa[@]}" --format json
  [ $status -eq 0 ] && [ "$(wc -l <err)" -eq 4 ] || fail "status $status: $(cat err)"
  for name in half_width_over_radius creep_ratio hertz_pressure max_temperature_celsius; do
    grep -q "^thermoroll: note: $name = [^,]* is above [^,]*: are all data in SI units" err || fail "$name: $(cat err)"
  done
  sed 's/^thermoroll: note: //' err >told
  sed -n '/^  "notes": \[$/,/^  \]$/p' out | sed -n 's/^    "\(.*\)",\{0,1\}$/\1/p' | diff told - || fail "not in the JSON: $(cat out)"
  grep -q 'with all heat in one body: two steel bodies are about half as hot' err || fail "$(cat err)"
  run solve "${in_gpa[@]}" --format csv
  [ "$(tail -1 out | sed 's/.*,//')" = "$(paste -sd';' told | sed 's/;/; /g')" ] || fail "not in the CSV: $(cat out)"
  run temperature "${in_gpa[@]}" --at 0.5
  [ $status -eq 0 ] && [ "$(wc -l <err)" -eq 4 ] || fail "status $status: $(cat err)"
  run solve "${wheel[@]/1.4e-5/14}" --traction 0.3 --method closed-form # in mm^2/s
  grep -q '^thermoroll: note: grueneisen = [0-9.e+]* is above 3 .*: is the modulus that of shear and are expansion and diffusivity and conductivity in SI units?$' err || fail "$(cat err)"
  grep '^thermoroll: note: ' err | grep ',' && fail "a note with a comma"
  # The load of a wheel in N.
  run solve "${wheel[@]/1.2e7/1.08e5}" --creep-ratio 0.005
  [ $status -eq 0 ] && one_line "note: hertz_pressure = 1.25e+07 is below 1.62e+08 (a five-hundredth of the shear modulus): is the load that of a metre of the contact's width and a radius in m?"
  answers solve "${steel[@]}" --half-width 5.5e-3 --format json
  [ "$(value notes)" = "[]" ] || fail "a note on the paper's scene: $(cat out)"
  answers solve "${paper_scene[@]}" --format json
  ! grep -q '"notes"' out || fail "notes without data in SI units: $(cat out)"
}

# So does a creep curve, for the largest creep and rise of its rows, and a law for its data.
NotesOnCreepCurves() {
  run creep-curve "${wheel[@]}" --from-ratio 0 --to-ratio 0.9 --points 3
  [ $status -eq 0 ] && [ "$(wc -l <err)" -eq 2 ] || fail "status $status: $(cat err)"
  grep -q '^thermoroll: note: creep_ratio = 0.9 is above 0.1 .*: are all data in SI units and creeps no percentages?$' err || fail "$(cat err)"
  grep -q '^thermoroll: note: max_temperature_celsius = [0-9.e+]* is above 1500 ' err || fail "$(cat err)"
  run creep-curve "${wheel[@]}" --from-ratio 0 --to-ratio 0.005 --points 3
  [ $status -eq 0 ] && [ ! -s err ] || fail "status $status: $(cat err)"
  run law "${wheel[@]}" --format json
  [ $status -eq 0 ] && [ ! -s err ] || fail "status $status: $(cat err)"
  run law "${wheel[@]/5.5e-3/5.5}" --format json
  grep -q '^thermoroll: note: half_width = 5.5 is above 0.1 ' err || fail "$(cat err)"
  local way
  for way in "law --format json" "creep-curve --from-ratio 0 --to-ratio 0.005 --points 3"; do
    run $way "${wheel[@]/#0.6/30}"
    grep -q '^thermoroll: note: friction = 30 is above 2 .*: is it a ratio and no percentage?$' err || fail "$way: $(cat err)"
  done
  # A law that rises without end, and Young's modulus in place of that of shear.
  run solve "${wheel[@]/#0.6/0.3}" --roller identical --creep-ratio 0.02 --friction-law linear --friction-temperature -40
  grep -q '^thermoroll: note: friction = [0-9.]* is above 2 .* and does its law hold at such temperatures?$' err || fail "$(cat err)"
  for way in "solve --creep-ratio 0.002" "law --format json" "creep-curve --from-ratio 0 --to-ratio 0.005 --points 3"; do
    run $way "${wheel[@]}" --roller identical --tolerance 1e-3 --friction-law linear --friction-temperature 0.02 --friction-floor 0.5
    grep -qx 'thermoroll: note: friction_temperature = 0.02 is below 1 in size (a kelvin): is it in K and not in units of T\*?' err ||
      fail "$way: $(cat err)"
  done
  run solve "${wheel[@]/8.1e10/2.1e11}" --creep-ratio 0.002
  grep -q '^thermoroll: note: grueneisen = 4.2[0-9]* is above 3 ' err || fail "$(cat err)"
  run law --friction 0.6 --peclet 1e5 --heating 30 --format json
  [ $status -eq 0 ] || fail "status $status"
  grep -q '^thermoroll: note: the curve ends at the creep 0.0[0-9]*: the solution is not resolved (a larger tolerance may go on)$' err || fail "$(cat err)"
}

# A failure is told with the notes on its data, in one line; without them where the data are as they should be.
NotesOnFailures() {
  local si=("${wheel[@]}" --roller identical) about="; note: grueneisen = 1.[0-9]*e+06 is above 3 (solids have 0.5 to 2): is the modulus that of shear and are expansion and diffusivity and conductivity in SI units?"
  fails() { # fails STATUS BEGINNING NOTE ARGUMENT...
    local expected=$1 beginning=$2 note=$3
    shift 3
    run "$@"
    [ $status -eq "$expected" ] && [ ! -s out ] && [ "$(wc -l <err)" -eq 1 ] || fail "$* gave status $status: $(cat err)"
    grep -q "^thermoroll: $beginning.*$note\$" err || fail "$* said: $(cat err)"
  }
  fails 1 "coupled: " "$about" solve "${si[@]/1.4e-5/14}" --traction 0.2
  fails 1 "coupled: " "$about" solve "${si[@]/1.1e-5/11}" --traction 0.2
  # The creep of a contact that slips is told beside it, as a ratio or not.
  fails 1 "coupled: " "; note: creep_ratio = 0.9 is above 0.1 .*$about" solve "${si[@]/1.4e-5/14}" --creep-ratio 0.9
  fails 2 "creep-ratio = 0.9: creep = " " creep 1 is creep-ratio [0-9.e-]*); note: creep_ratio = 0.9 is above 0.1 .*$about" \
    solve "${wheel[@]/1.4e-5/14}" --creep-ratio 0.9
  fails 2 "creep = 20 is" "); note: creep_ratio = 0.754 is above 0.1 .*$about" solve "${wheel[@]/1.4e-5/14}" --creep 20
  fails 1 "coupled: no contact found in full slip at the creep 26" " (traction 1 is 1.2e+07 N/m, creep 1 is creep-ratio 0.03[0-9]*); note: creep_ratio = 100 .*" \
    solve "${wheel[@]/#0.6/0.3}" --creep-ratio 100
  fails 1 "law: " "$about" law "${wheel[@]/1.1e-5/11}"
  fails 1 "law: " "$about" creep-curve "${wheel[@]/1.1e-5/11}"
  fails 2 "to-ratio = 0.01 is" ", where the curve ends: .*$about" creep-curve "${si[@]/1.4e-5/14}" --to-ratio 0.01
}

# There is a solution for the half-width of Hertz, but none next to that of the radius, to this tolerance.
RadiusOfAnUnresolvedSceneSaysSo() {
  run solve --radius 0.801516811864857 --tolerance 1e-8 --friction 0.50117091978 --roller identical --friction-law linear \
    --friction-floor 0.79441511085 --load 2053532.8065 --speed 28.654788698 --poisson 0.393321041 --expansion 3.27323013e-06 \
    --diffusivity 0.002000037 --conductivity 45.410338688 --shear-modulus 96375397991.56662 --friction-temperature 87.66495852 \
    --bulk-temperature 14.7089559 --bulk-temperature-2 -125.80196923 --creep 0.90850511825
  [ $status -eq 1 ] || fail "status $status: $(cat err)"
  grep -q "not resolved to 1e-08 .* at best to" err || fail "$(cat err)"
}

# A radius and the half-width found for it are the same scene.
RadiusAgreesWithHalfWidth() {
  local method radius
  for method in $methods; do
    answers solve "${steel[@]}" --half-width 5.5e-3 --method $method --tolerance 1e-9 --format json
    cp out by-half-width
    radius=$(value radius)
    answers solve "${steel[@]}" --radius "$radius" --method $method --tolerance 1e-9 --format json
    near "$(calculate "$(value half_width) / 5.5e-3")" 1 2e-9 # the fixed point's tolerance
    near "$(calculate "$(value radius) / $radius")" 1 2e-9
    near "$(value max_temperature)" "$(sed -n 's/^  "max_temperature": \(.*\),/\1/p' by-half-width)" 1e-11
    [ $method != gauss-chebyshev ] || continue # it has no errors
    [ "$(grep -c '"half_width": 0.0,' by-half-width)" -eq 1 ] || fail "an error of what is given: $(cat by-half-width)"
    ! grep -q '"half_width": 0.0,' out || fail "no error of what was found: $(cat out)"
  done
}

MixedData() {
  refuses 2 "--peclet and --heating exclude data in SI units; given: --load" \
    solve "${paper_scene[@]}" --load 1.2e7
  refuses 2 "exclude data in SI units" solve "${steel[@]}" --half-width 5.5e-3 --heating 0
  refuses 2 "either --half-width or --radius, not both" solve "${steel[@]}" --half-width 5.5e-3 --radius 0.3
}

IncompleteData() {
  refuses 2 "--friction is required" solve --traction 0.5 --peclet 100
  refuses 2 "exactly one of --traction, " solve --friction 0.6 --peclet 100
  refuses 2 "--peclet is missing" solve --friction 0.6 --traction 0.5
  refuses 2 "either --half-width or --radius" solve "${steel[@]}"
  refuses 2 "lack --speed --shear-modulus --poisson --expansion --diffusivity --conductivity" \
    solve --friction 0.6 --traction 0.5 --load 1.2e7 --half-width 5.5e-3
  refuses 2 "data in SI units lack --load" solve --friction 0.6 --traction 0.5 --radius 0.3
}

# --- Temperature ----------------------------------------------------------------------------------

TemperatureColumns() {
  answers temperature "${paper_scene[@]}" --at 0.5
  [ "$(head -1 out)" = s,temperature,error_estimate ] || fail "$(head -1 out)"
  tail -1 out | grep -qx '0.5,0.001[0-9]*,[0-9.]*e-[0-9]*' || fail "$(cat out)"
  # the error of the largest temperature is part of the error, and so is twice what the curve misses of it
  local error top at
  error=$(tail -1 out | cut -d, -f3)
  answers solve "${paper_scene[@]}" --format json
  cp out solved
  top=$(sed -n 's/^  "max_temperature": \(.*\),/\1/p' solved)
  at=$(sed -n 's/^  "max_temperature_at": \(.*\),/\1/p' solved)
  answers temperature "${paper_scene[@]}" --at "$at"
  awk -v e="$error" -v flux="$(sed -n '/error_estimate/,$s/ *"max_temperature": \(.*\),/\1/p' solved)" \
    -v missed="$(tail -1 out | awk -F, -v top="$top" '{ print ($2 > top ? $2 - top : top - $2) }')" \
    'BEGIN { exit !(e >= flux + 2 * missed && flux > 0 && e < 1.1 * (flux + 2 * missed)) }' || fail "error $error"
  answers temperature "${paper_scene[@]}" --at 0.5 --method gauss-chebyshev
  tail -1 out | grep -qx '0.5,0.001[0-9]*,' || fail "$(cat out)"
  answers temperature "${steel[@]}" --half-width 5.5e-3 --at 0.5
  [ "$(head -1 out)" = s,x_m,temperature,temperature_celsius,error_estimate,error_estimate_celsius ] || fail "$(head -1 out)"
  answers temperature "${steel[@]}" --half-width 5.5e-3 --at 0.5 --bulk-temperature 20
  [ "$(head -1 out)" = s,x_m,temperature,temperature_celsius,absolute_temperature_celsius,error_estimate,error_estimate_celsius ] || fail "$(head -1 out)"
  awk -F, 'END { exit !($5 == 20 + $4 || $5 - 20 - $4 < 1e-12 && 20 + $4 - $5 < 1e-12) }' out || fail "$(cat out)"
  answers solve "${steel[@]}" --half-width 5.5e-3 --bulk-temperature 20 --profile profile.csv --profile-points 5
  awk -F, 'NR == 1 { if ($13 != "absolute_temperature_celsius") exit 1; next } { d = $13 - 20 - $12; if (d * d > 1e-20) exit 1 }
    $11 != 0 && $11 < 1e-300 { exit 1 }' profile.csv ||
    fail "$(cat profile.csv)"
  answers temperature "${steel[@]}" --half-width 5.5e-3 --at 0.5
  awk -F, 'END { if ($2 != 0.5 * 5.5e-3) exit 1
                 t = $3 * 0.6 * 22.2 * 1.4 * 1.2e7^2 / (8.1e10 * 5.5e-3 * 50)
                 exit !($4 / t - 1 < 1e-14 && 1 - $4 / t < 1e-14 && ($6 / $5 / ($4 / $3) - 1)^2 < 1e-28) }' out || fail "$(cat out)"
}

TemperatureGrid() {
  answers temperature "${paper_scene[@]}" --at -1:3:401
  [ "$(wc -l <out)" -eq 402 ] || fail "$(wc -l <out) lines"
  tail -n +2 out | cut -d, -f1 | diff <(seq -1 0.01 3 | sed 's/\.0*$//; s/\(\.[0-9]*[1-9]\)0*$/\1/; s/^-0$/0/') - ||
    fail "the points are not the decimals"
  answers temperature "${paper_scene[@]}" --at 1,-1,0.25
  [ "$(cut -d, -f1 out | paste -sd' ')" = "s 1 -1 0.25" ] || fail "$(cat out)"
  answers temperature "${paper_scene[@]}" --at 1e308:-1e308:3
  [ "$(cut -d, -f1 out | paste -sd' ')" = "s 1e+308 0 -1e+308" ] || fail "$(cat out)"
  answers temperature "${paper_scene[@]}"
  cp out default
  answers temperature "${paper_scene[@]}" --at -1.5:4:551
  cmp out default || fail "without --at there are other points"
}

# Rows by depth and then by s, each as at that depth alone, with columns for the depth.
TemperatureAtDepths() {
  local depth scene=(--friction 0.6 --traction 0.5 --peclet 5)
  answers temperature "${scene[@]}" --roller identical --bulk-difference 0.01 --at 0 --depth 0.1
  echo s,depth,temperature,error_estimate >expected
  for depth in 0.1 0 0.05; do
    answers temperature "${scene[@]}" --at 2,0,1 --depth $depth
    [ "$(head -1 out)" = s,temperature,error_estimate ] || fail "$(head -1 out)"
    sed "1d; s/,/,$depth,/" out >>expected
  done
  answers temperature "${scene[@]}" --at 2,0,1 --depth 0.1,0,0.05
  cmp out expected || fail "$(diff out expected)"
  answers temperature "${scene[@]}" --at 0:1:2 --depth 0:0.5:3
  [ "$(cut -d, -f1,2 out | paste -sd' ')" = "s,depth 0,0 1,0 0,0.25 1,0.25 0,0.5 1,0.5" ] || fail "$(cat out)"
  answers temperature "${steel[@]}" --half-width 5.5e-3 --at 0.5 --depth 0,1
  [ "$(head -1 out)" = s,x_m,depth,depth_m,temperature,temperature_celsius,error_estimate,error_estimate_celsius ] || fail "$(head -1 out)"
  awk -F, 'NR > 1 && ($2 != $1 * 5.5e-3 || $4 != $3 * 5.5e-3) { exit 1 }' out || fail "$(cat out)"
  # A micrometre below a wheel on ceramics, where an integral has an error of 1e-8 of the temperature.
  answers temperature --friction 0.35 --load 1.2e7 --half-width 7.8e-3 --shear-modulus 8.1e10 --poisson 0.3 \
    --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50 --roller conducting --expansion-2 1e-5 \
    --conductivity-2 0.25 --diffusivity-2 1.5e-7 --speed 60 --creep-ratio 0.001 --at 1 --depth 1e-6
  refuses 2 "depth = -1 is not allowed: it must be zero or positive" temperature "${scene[@]}" --depth 0,-1
  refuses 2 "number of rows = 1000500 is not allowed: it must be at most 1000000" \
    temperature "${scene[@]}" --at 0:1:2001 --depth 0:1:500
  refuses 2 "depth = 1 is not allowed: it must be 0 with gauss-chebyshev" \
    temperature "${paper_scene[@]}" --method gauss-chebyshev --depth 0,1
}

BadPoints() {
  local at
  for at in foo 0:1 0:1:1 0:1:1.5 0:1:1000001 0:1:1e99 0:1:2: 0:1:2:3 :: 0::2 0:nan:2 inf:1:2 1, ,1 "" nan; do
    refuses 2 "at = $at is not allowed: it must be A:B:N" temperature "${paper_scene[@]}" --at "$at"
    refuses 2 "depth = $at is not allowed: it must be A:B:N" temperature "${paper_scene[@]}" --depth "$at"
  done
}

# The curve touches the maximum at its place and is nowhere above it.
TemperatureIsAsTheMaximumSays() {
  answers solve "${paper_scene[@]}" --method closed-form --format json
  local top at
  top=$(value max_temperature) at=$(value max_temperature_at)
  answers temperature "${paper_scene[@]}" --at "$at" --method closed-form
  near "$(tail -1 out | cut -d, -f2)" "$top" 1e-14
  answers temperature "${paper_scene[@]}" --at 0.80:0.91:45 --method closed-form
  awk -F, -v top="$top" 'NR > 1 && $2 > top { exit 1 }' out || fail "above the maximum: $(cat out)"
  # the adaptive quadrature over the coupled flux and the solver's own maximum
  answers solve "${paper_scene[@]}" --format json
  top=$(value max_temperature) at=$(value max_temperature_at)
  answers temperature "${paper_scene[@]}" --at "$at"
  near "$(tail -1 out | cut -d, -f2)" "$top" "$(tail -1 out | cut -d, -f3)"
}

TemperatureBelowTheSurface() {
  answers temperature "${paper_scene[@]}" --at 0:2:5
  cp out surface
  answers temperature "${paper_scene[@]}" --at 0:2:5 --depth 0
  cmp out surface || fail "depth 0 is not the surface"
  answers temperature "${paper_scene[@]}" --at 0:2:5 --depth 0.01
  paste -d, surface out | awk -F, 'NR > 1 && !($5 > 0 && $5 < $2) { exit 1 }' ||
    fail "not colder below the surface: $(cat out)"
  refuses 2 "depth = 0.1 is not allowed" temperature "${paper_scene[@]}" --at 0 --depth 0.1 \
    --method gauss-chebyshev
  refuses 2 "depth = -1 is not allowed" temperature "${paper_scene[@]}" --at 0 --depth -1
}

# With three nodes the middle one is 0 and hot. At it the sum is finite, without its share; a
# little beside it, it is larger, by the logarithm in that share.
TemperatureMeetsNodes() {
  answers temperature --friction 0.6 --traction 0.5 --peclet 1 --nodes 3 --method gauss-chebyshev \
    --at 0,1e-8
  awk -F, 'NR == 2 { without = $2 } NR == 3 { exit !(without > 0 && $2 > 2 * without) }' out ||
    fail "$(cat out)"
}

# --- Scene files -----------------------------------------------------------------------------------

# The chapter's own file, as wheel.toml.
write_wheel() {
  code toml B-command-line.md >wheel.toml
  grep -q '^load = ' wheel.toml || fail "the chapter has no scene file"
}

SceneFile() {
  write_wheel
  answers solve "${steel[@]}" --half-width 5.5e-3 --format json
  cp out by-options
  answers solve --config wheel.toml --format json
  cmp out by-options || fail "the file is another scene"
  answers --config wheel.toml solve --format json
  cmp out by-options || fail "--config before the subcommand is another scene"
  sed 's/#/;/; s/ *=/=/' wheel.toml >wheel.ini
  sed -i 's/ *;.*//' wheel.ini
  answers solve --config wheel.ini --format json
  cmp out by-options || fail "the INI file is another scene"
  { echo '[temperature]'; echo 'at = 0.5'; echo '[solve]'; echo 'format = "json"'; cat wheel.toml; } >both.toml
  answers solve --config both.toml
  cmp out by-options || fail "the section is another scene"
  { cat wheel.toml; echo '[temperature]'; echo 'friction = 0.9'; echo 'roller = "identical"'; echo '[sweep]'
    echo 'tolerance = 0.5'; echo 'creep = 0.1'; } >sections.toml
  answers solve --config sections.toml --format json
  cmp out by-options || fail "the section of another subcommand makes another scene"
  sed -i 's/= 0.6/= 0.7/' wheel.toml
  answers solve --config wheel.toml --format json --friction 0.6
  cmp out by-options || fail "the option does not take precedence"
  answers temperature --config wheel.toml --at 0.5
  # what an option excludes gives way to it
  sed -i 's/= 0.7/= 0.6/' wheel.toml
  answers solve --config wheel.toml --format json --creep 0.1
  [ "$(value creep)" = 0.1 ] || fail "$(cat out)"
  answers solve --config wheel.toml --format json --radius 0.3
  near "$(value radius)" 0.3 1e-6
  refuses 2 "exactly one of" solve --config wheel.toml --creep 0.1 --creep-ratio 0.001
  { printf '\xef\xbb\xbf'; sed 's/= 0.7/= 0.6/' wheel.toml; } >marked.toml
  answers solve --config marked.toml --format json
  cmp out by-options || fail "the byte-order mark makes another scene"
}

BadSceneFiles() {
  local case=$'friction = 0.6\ntraction = 0.5\n'
  bad() { # bad WORDS TEXT
    printf '%s%s\n' "$case" "$2" >bad.toml
    refuses 2 "$1" solve --config bad.toml --output written
    [ ! -e written ] || fail "a file was written"
  }
  bad "no option of solve: pecle" 'pecle = 100'
  bad "no option of solve: peclet 100" 'peclet 100'
  bad "no option of solve: at" $'peclet = 100\nat = 0.5'
  bad "no option of solve: output" $'peclet = 100\noutput = "other"'
  bad "no option of solve: profile" $'[solve]\npeclet = 100\nprofile = "other"'
  bad "no option of solve: nowhere.peclet" $'[nowhere]\npeclet = 100'
  bad "no option of solve: temperature.pecle" $'peclet = 100\n[temperature]\npecle = 100'
  bad "no option of solve: help" $'peclet = 100\nhelp = true'
  echo 'radius = 0.46' >radius.toml
  refuses 2 "no option of creep-curve: radius (a curve keeps the half-width: that of solve --radius)" creep-curve --config radius.toml
  bad "peclet = abc is not allowed: it must be a finite number" 'peclet = abc'
  bad "peclet = nan is not allowed: it must be a finite number" 'peclet = nan'
  bad "peclet =  is not allowed" 'peclet = '
  bad "peclet = -1 is not allowed" 'peclet = -1'
  bad "gives friction more than once" $'peclet = 100\nfriction = 0.6'
  bad "gives peclet more than once" $'peclet = 100\npeclet = 100'
  bad "peclet = [100, 200] is not allowed: it must be a finite number" 'peclet = [100, 200]'
  bad "peclet = 100 m is not allowed: it must be a finite number" '  peclet = 100 m # metres'
  bad "half-width = 7.8e-3 m is not allowed: it must be a finite number in m" 'half_width = 7.8e-3 m'
  bad "peclet = 1 000 is not allowed: it must be a finite number" 'peclet = 1 000'
  bad "load = 1 N/m is not allowed: it must be a finite number in N/m" $'# load [N/m]\nload = 1 N/m'
  [ ! -e other ] || fail "a file was written"
  refuses 2 "A subcommand is required" --config bad.toml
  refuses 2 "cannot read the scene file nowhere.toml: No such file or directory" solve --config nowhere.toml
  refuses 2 "cannot read the scene file .: Is a directory" solve --config .
  refuses 2 "the scene file has more than 100000 bytes" solve --config /dev/zero
  { printf '%s' "$case"; yes '# a comment'; } | head -c 100000 >long.toml
  answers solve --config long.toml --peclet 100
  echo >>long.toml
  refuses 2 "the scene file has more than 100000 bytes" solve --config long.toml --peclet 100
  refuses 2 "--config needs exactly one value" solve "${paper_scene[@]}" --config
}

# --- Refusals -------------------------------------------------------------------------------------

BadNumbers() {
  local text
  for text in nan -nan NaN inf -inf infinity 1e400 abc 0x 0x10 ++1 +-1 ' 1' 1e3abc 1,5 "" "1 2" $'1\n2' --; do
    refuses 2 "is not allowed: it must be a finite number" \
      solve --friction 0.6 --traction 0.5 --peclet "$text" --heating 0
    refuses 2 "is not allowed: it must be a finite number" \
      temperature --friction 0.6 --traction "$text" --peclet 100 --at 0
  done
  refuses 2 "peclet = abc is not allowed" solve --friction 0.6 --traction 0.5 --peclet abc
  for text in 1e-12 0.1 0 -1e-6; do
    refuses 2 "is not allowed: it must be from 1e-11 to 1e-2" \
      solve "${paper_scene[@]}" --tolerance "$text"
  done
  refuses 2 "tolerance = abc is not allowed: it must be a finite number" \
    solve "${paper_scene[@]}" --tolerance abc
  for text in 2.5 1e3 0200 abc 99999999999 "" 0x20; do
    refuses 2 "nodes = $text is not allowed: it must be a whole number" \
      solve "${paper_scene[@]}" --nodes "$text"
  done
  for text in -1 0 2 5001; do
    refuses 2 "nodes = $text is not allowed: it must be from 3 to 5000" \
      solve "${paper_scene[@]}" --method gauss-chebyshev --nodes "$text"
  done
}

BadScenes() {
  local case
  while read -r case; do
    # shellcheck disable=SC2086
    refuses 2 "is not allowed: it must be " solve $case
    # shellcheck disable=SC2086
    refuses 2 "is not allowed: it must be " solve $case --method closed-form
    # shellcheck disable=SC2086
    refuses 2 "is not allowed: it must be " solve $case --method gauss-chebyshev
  done <<'END'
--friction 0 --traction 0.5 --peclet 100
--friction -0.6 --traction -0.7 --peclet 100
--friction 0.6 --traction 0.7 --peclet 100
--friction 0.6 --traction -0.7 --peclet 100
--friction 0.6 --traction 0.5 --peclet 0
--friction 0.6 --traction 0.5 --peclet -100
--friction 0.6 --traction 0.5 --peclet 100 --heating -1
END
  local sign
  for sign in "" -; do
    refuses 2 "traction = ${sign}0.7 is not allowed: it must be between -0.6 and 0.6, the friction" \
      solve --friction 0.6 --traction ${sign}0.7 --peclet 100
  done
  refuses 2 "unit of heat flux 2 (1-nu) P^2 V / (mu a^2) = 0 is not allowed: it must be positive" \
    solve "${steel[@]}" --half-width 1e308
  # no contact is found, rather than a wrong one
  refuses 1 "coupled: no" solve --friction 0.6 --traction 0.5 --peclet 1e200 --heating 1e200
}

# Each of the data in SI units in turn.
BadSiData() {
  local -A good=([load]=1.2e7 [speed]=22.2 [shear-modulus]=8.1e10 [poisson]=0.3 [expansion]=1.1e-5
    [diffusivity]=1.4e-5 [conductivity]=50)
  local bad name size arguments
  for bad in "${!good[@]}"; do
    for size in half-width radius; do
      arguments=(--friction 0.6 --traction 0.5 --$size 0.01)
      for name in "${!good[@]}"; do
        if [ "$name" = "$bad" ]; then arguments+=(--"$name" -1); else arguments+=(--"$name" "${good[$name]}"); fi
      done
      refuses 2 "$bad = -1 is not allowed" solve "${arguments[@]}"
    done
  done
  refuses 2 "half-width = 0 is not allowed" solve "${steel[@]}" --half-width 0
  refuses 2 "radius = -0.3 is not allowed" solve "${steel[@]}" --radius -0.3
}

BadWords() {
  refuses 2 "method = newton is not allowed: it must be auto or closed-form or first-order or coupled or gauss-chebyshev" \
    solve "${paper_scene[@]}" --method newton
  refuses 2 "formulation = other is not allowed: it must be printed or corrected" \
    solve "${paper_scene[@]}" --formulation other
  refuses 2 "format = xml is not allowed: it must be text or json or csv" \
    solve "${paper_scene[@]}" --format xml
  refuses 2 "format = xml is not allowed" claims --format xml
}

BadUsage() {
  refuses 2 "A subcommand is required (see --help)"
  refuses 2 "unexpected --at (see --help)" solve "${paper_scene[@]}" --at 0
  refuses 2 "unexpected 7 (see --help)" solve "${paper_scene[@]}" 7
  refuses 2 "unexpected temperature (see --help)" solve "${paper_scene[@]}" temperature
  refuses 2 "--friction is given twice" solve "${paper_scene[@]}" --friction 0.5
  refuses 2 "--heating-2 is given twice" solve "${paper_scene[@]}" --heating-2 0.5 --heating-2 0.5
  refuses 2 "--peclet needs exactly one value" solve --friction 0.6 --traction 0.5 --peclet
  refuses 2 "either a NAME or --list" figure-data
  refuses 2 "either a NAME or --list" figure-data --list traction
}

# Each option with a unit names it where it is given something else.
UnitsAreNamed() {
  local option unit words
  while read -r option unit; do
    refuses 2 "$option = 80x is not allowed: it must be a finite number in $unit" \
      solve --friction 0.6 --$option 80x
  done <<'END'
load N/m
speed m/s
shear-modulus Pa
expansion 1/K
diffusivity m^2/s
conductivity W/(m K)
half-width m
radius m
conductivity-2 W/(m K)
expansion-2 1/K
diffusivity-2 m^2/s
bulk-temperature degree C
bulk-temperature-2 degree C
tangential-load N/m
END
  answers solve --help
  words=$(grep -oE '^  --[a-z0-9-]+ (N/m|m/s|Pa|1/K|m\^2/s|W/\(m K\)|m|degree C)( |$)' out | wc -l)
  [ "$words" -eq 14 ] || fail "$words options with a unit"
  refuses 2 "poisson = 80x is not allowed: it must be a finite number" solve --friction 0.6 --poisson 80x
  ! grep -q ' in ' err || fail "$(cat err)"
}

EmptyFileNames() {
  local option
  for option in output profile config; do
    refuses 2 "$option =  is not allowed: it must be the name of a file" solve "${paper_scene[@]}" --$option ""
  done
  refuses 2 "output =  is not allowed" temperature "${paper_scene[@]}" --output ""
  refuses 2 "times =  is not allowed" figure-data speed --times ""
}

# The options' names with underscores, on the command line and as keys; values keep theirs.
UnderscoresAreHyphens() {
  write_wheel
  answers solve --config wheel.toml --format json
  cp out expected
  sed -i 's/^half-width/half_width/; s/^shear-modulus/shear_modulus/' wheel.toml
  answers solve --config wheel.toml --format json
  cmp out expected || fail "the keys are others"
  run solve "${steel[@]/shear-modulus/shear_modulus}" --half_width=5.5e-3 --format json --output a_b
  cmp a_b expected || fail "the options are others: $(cat err)"
  echo 'half-width = 1' >>wheel.toml
  refuses 2 "gives half-width more than once" solve --config wheel.toml
  refuses 2 "method = closed_form is not allowed" solve "${paper_scene[@]}" --method closed_form
}

# A misspelt name is told with the nearest, if one is near, and nothing else is done.
NearestNames() {
  local word
  refuses 2 "unexpected --fricton (did you mean --friction?)" solve --fricton 0.6
  refuses 2 "unexpected --fricton=0.6 (did you mean --friction?)" solve --fricton=0.6
  refuses 2 "unexpected --tolerence (did you mean --tolerance?)" solve "${paper_scene[@]}" --tolerence 1e-3
  refuses 2 "unexpected --confg (did you mean --config?)" solve --confg wheel.toml
  refuses 2 "unexpected --radius-2 (for two rollers --radius is R1 R2 / (R1 + R2))" solve --radius-2 0.3
  refuses 2 "unexpected --hertz-pressure (--load is pi / 2 times it and the half-width)" solve --hertz-pressure 1e9
  refuses 2 "unexpected --youngs-modulus (--shear-modulus is E / (2 (1 + nu)))" solve --youngs-modulus 2.1e11
  for word in density heat-capacity specific-heat; do
    refuses 2 "unexpected --$word (--diffusivity is conductivity / (density * heat capacity))" solve --$word 500
  done
  refuses 2 "unexpected --poisson-2 (both bodies have the same elastic constants)" solve --poisson-2 0.2
  refuses 2 "unexpected --shear-modulus-2 (both bodies have the same elastic constants)" solve --shear-modulus-2 1e9
  refuses 2 "unexpected --radius (a curve keeps the half-width: that of solve --radius)" creep-curve --radius 0.46
  refuses 2 "unexpected --creep (options stand after the command and before any --)" --creep 0.1 solve "${paper_scene[@]}"
  refuses 2 "unexpected \"\" (see --help)" solve ""
  refuses 2 "unexpected =5 (see --help)" solve "${paper_scene[@]}" =5
  refuses 2 "unexpected --creep (options stand after the command and before any --)" solve "${paper_scene[@]}" -- --creep 0.1
  refuses 2 "unexpected --nonsense (see --help)" solve --nonsense 1
  refuses 2 "unexpected sovle (did you mean solve?)" sovle "${paper_scene[@]}"
  refuses 2 "unexpected solv (did you mean solve?)" solv
  refuses 2 "unexpected sweeep (did you mean sweep?)" sweeep --help
  refuses 2 "unexpected sweeep (did you mean sweep?)" help sweeep
  refuses 2 "unexpected nonsense (see --help)" nonsense --help
  refuses 2 "unexpected solve (see --help)" solve "${paper_scene[@]}" solve
  answers solve --fricton 0.6 --help
}

# A limit cycle of the published scheme: the last iterate is told, and that it is one.
NotConverged() {
  local scheme=(--method gauss-chebyshev --nodes 20 --formulation printed --format json)
  run solve --friction 0.6 --traction 0.5 --peclet 100 --heating 4 "${scheme[@]}"
  [ $status -eq 3 ] || fail "status $status"
  one_line "did not converge"
  [ "$(value converged)" = false ] || fail "$(cat out)"
  ! grep -qi 'nan\|inf' out || fail "not finite: $(cat out)"
  # Pe H overflows: there is nothing to tell
  refuses 3 "no finite result" solve --friction 0.6 --traction 0.5 --peclet 1e200 --heating 1e200 \
    "${scheme[@]}"
}

# The published scheme settles where its bodies pull and slip backwards: numbers, and what is wrong
# with them, in every format. The coupled solver finds the contact.
NoContact() {
  local scene=(solve --friction 0.6 --traction 0.5 --peclet 1000 --heating 30 --formulation printed)
  local said="is no contact: separation at s = -0.9995" cell="separation -0.999512..1; backward slip -0.999844..1"
  wrong() {
    run "${scene[@]}" --method gauss-chebyshev --nodes 200 --format "$1"
    [ $status -eq 5 ] || fail "status $status: $(cat err)"
    one_line "$said"
  }
  wrong json
  [ "$(value converged) $(value admissible)" = "true false" ] || fail "$(cat out)"
  [ "$(value what)" = separation ] && [ "$(value to)" = 1.0 ] || fail "$(cat out)"
  near "$(value from)" -0.9995 1e-4
  [ "$(grep -c '"what": "backward slip"' out)" -eq 1 ] || fail "$(cat out)"
  wrong csv
  grep -q ",converged,admissible,violations,error_estimate" out || fail "$(head -1 out)"
  grep -qF ",true,false,$cell," out || fail "$(cat out)"
  wrong text
  grep -q "^violations  *$cell\$" out || fail "$(cat out)"
  run "${scene[@]}" --tolerance 1e-3 --format json
  [ $status -eq 0 ] && [ "$(value admissible) $(value violations)" = "true []" ] || fail "$(cat out err)"
}

# --- Output ---------------------------------------------------------------------------------------

OutputFileIsReplacedAsAWhole() {
  answers solve "${paper_scene[@]}" --format json
  cp out expected
  echo old >file
  ln -s file link
  run solve "${paper_scene[@]}" --format json --output link
  [ $status -eq 0 ] && [ ! -s out ] && [ ! -s err ] || fail "status $status: $(cat out err)"
  cmp file expected || fail "another answer in the file"
  [ -L link ] || fail "the link was replaced"
  refuses 2 "is not allowed" solve --friction 0.6 --traction 0.7 --peclet 1 --output file
  cmp file expected || fail "a refusal changed the file"
  run solve "${paper_scene[@]}" --format json --output /dev/stdout
  cmp out expected || fail "not written to a device"
  run solve "${paper_scene[@]}" --output /dev/null
  [ -c /dev/null ] || fail "/dev/null was replaced"
  [ "$(ls)" = "$(printf '%s\n' err expected file link out)" ] || fail "left behind: $(ls)"
}

# Neither that of another run nor any that might be taken for one that is being written.
OutputTouchesNoOtherFile() {
  local file
  for file in result result.tmp p.csv.tmp; do echo mine >$file; done
  run solve "${paper_scene[@]}" --output result --profile result.tmp
  [ $status -eq 0 ] && grep -q '^method' result && grep -q '^s,' result.tmp || fail "$(cat err result result.tmp)"
  run solve "${paper_scene[@]}" --output result.tmp --profile p.csv
  [ $status -eq 0 ] && grep -q '^method' result.tmp && grep -q '^s,' p.csv || fail "$(cat err result.tmp p.csv)"
  [ "$(cat p.csv.tmp)" = mine ] || fail "another file was changed"
  [ "$(ls)" = "$(printf '%s\n' err out p.csv p.csv.tmp result result.tmp)" ] || fail "left behind: $(ls)"
}

# A new file is as others that are made, another keeps what it has; one that may not be written stays.
OutputKeepsPermissions() {
  echo old >private
  echo old >guarded
  chmod 2640 private
  (umask 027 && "$program" solve "${paper_scene[@]}" --output new)
  "$program" solve "${paper_scene[@]}" --output private
  [ "$(stat -c %a new private | paste -sd' ')" = "640 2640" ] || fail "$(ls -l)"
  chmod 444 guarded
  chmod 777 "$scratch" .
  cp "$program" program
  status=0
  powerless ./program solve "${paper_scene[@]}" --output guarded 2>err || status=$?
  [ $status -eq 1 ] || fail "status $status"
  one_line "cannot write guarded: Permission denied"
  [ "$(cat guarded)" = old ] || fail "the file was changed"
  [ "$(ls)" = "$(printf '%s\n' err guarded new private program)" ] || fail "left behind: $(ls)"
}

# Also one to a file that is not there yet, through another link, from another folder.
LinksAreFollowed() {
  mkdir folder
  ln -s ../file folder/second
  ln -s folder/second first
  local there
  for there in absent present; do
    run solve "${paper_scene[@]}" --output first
    [ $status -eq 0 ] && [ -L first ] && [ -L folder/second ] || fail "file $there: $(cat err) $(ls -l . folder)"
    grep -q '^method' file || fail "file $there: $(cat file)"
  done
  rm file
  refuses 2 "--profile and --output are the same file, first" solve "${paper_scene[@]}" --output first --profile file
  ln -s nowhere/file lost
  refuses 1 "cannot write lost: No such file or directory" solve "${paper_scene[@]}" --output lost
  [ -L lost ] || fail "the link was replaced"
}

# In a folder whose files only their owner may replace, another's file may be written, but not replaced.
NewFilesAreTakenBack() {
  [ "$(id -u)" = 0 ] || { echo "skipped: only root can make a file of another"; exit 77; }
  cp "$program" program
  chmod 755 "$scratch" . program
  mkdir -m 1777 sticky
  touch sticky/b
  chmod 666 sticky/b
  local old
  for old in new old; do
    status=0
    powerless ./program solve "${paper_scene[@]}" --output sticky/a --profile sticky/b 2>err || status=$?
    [ $status -eq 1 ] || fail "status $status: $(cat err)"
    one_line "cannot write sticky/b: Operation not permitted"
    [ "$(ls sticky)" = "$([ $old = new ] || echo a; echo b)" ] || fail "an $old file: $(ls sticky)"
    powerless touch sticky/a
  done
}

UnwritableOutput() {
  refuses 1 "cannot write nowhere/file: No such file or directory" \
    solve "${paper_scene[@]}" --output nowhere/file
  refuses 1 "cannot write .: Is a directory" solve "${paper_scene[@]}" --output .
  refuses 1 "cannot write /dev/full: No space left on device" \
    temperature "${paper_scene[@]}" --at 0 --output /dev/full
  refuses 1 "cannot write nowhere/file" figure-data kernels --output nowhere/file
  ln -s loop loop
  refuses 1 "cannot write loop/file: Too many levels" solve "${paper_scene[@]}" --output loop/file
  ln -s back forth
  ln -s forth back
  refuses 1 "cannot write forth: Too many levels of symbolic links" solve "${paper_scene[@]}" --output forth
  [ -L forth ] && [ -L back ] || fail "a link was replaced"
  refuses 2 "profile = - is not allowed: it must be a file" solve "${paper_scene[@]}" --profile -
  run solve "${paper_scene[@]}" --output -
  grep -q '^method' out || fail "- is not standard output"
  [ "$(ls)" = "$(printf '%s\n' back err forth loop out)" ] || fail "left behind: $(ls)"
}

# A name may have 255 bytes; what is written beside the file is no longer.
LongNames() {
  local name long
  name=$(printf '%0255d' 0)
  for long in "${name:10}" "$name"; do
    run solve "${paper_scene[@]}" --output "$long" --profile "p${long:1}"
    [ $status -eq 0 ] && grep -q '^method' "$long" && grep -q '^s,' "p${long:1}" || fail "$(cat err)"
    rm "$long" "p${long:1}"
  done
  refuses 1 "File name too long" solve "${paper_scene[@]}" --output "0$name"
  [ "$(ls)" = "$(printf '%s\n' err out)" ] || fail "left behind: $(ls)"
}

# Too little memory is said to be that, with what is needed or was in use; in a sweep only the row
# that needs it fails.
TooLittleMemory() { # slow
  with_little() { (ulimit -v 300000 && "$program" "$@" >out 2>err) || status=$?; } # kilobytes
  local scheme="gauss-chebyshev with 5000 nodes needs 800 MB of memory, too much here"
  status=0
  with_little solve "${paper_scene[@]}" --method gauss-chebyshev --nodes 5000
  [ $status -eq 1 ] && [ ! -s out ] || fail "status $status: $(cat err)"
  one_line "$scheme"
  printf '%s\n' friction,traction,peclet,method,nodes 0.6,0.5,100,gauss-chebyshev,5000 \
    0.6,0.5,100,closed-form, >scenes.csv
  status=0
  with_little sweep --jobs 1 <scenes.csv
  [ $status -eq 4 ] || fail "status $status: $(cat err)"
  sed -n 2p out | grep -qF ",1,\"$scheme\"" || fail "$(cat out)"
  sed -n 3p out | grep -q ',0,$' || fail "$(cat out)"
  { echo 'friction = 0.6'; echo 'traction = 0.5'; } >case.toml
  status=0
  (ulimit -v 100000 && "$program" temperature --config case.toml --peclet 100 --method closed-form \
    --at -1:1:1000000 >out 2>err) || status=$?
  [ $status -eq 1 ] && [ ! -s out ] || fail "status $status: $(cat err)"
  grep -qx 'thermoroll: there is not enough memory: [1-9][0-9]* MB were in use' err || fail "$(cat err)"
}

# A message is text, whatever it quotes: letters stay, what would control the terminal or is no UTF-8
# does not.
MessagesAreText() {
  said() { # said TEXT QUOTED
    refuses 2 "peclet = $2 is not allowed" solve --friction 0.6 --traction 0.5 --peclet "$1"
  }
  said 'größer' 'größer'
  said '∞' '∞'
  said '😀' '😀'
  said $'\e[2J' ' [2J'
  said $'a\x7fb' 'a b'
  said $'\xc2\x9b2J' ' 2J'
  said $'\xc2\xa0' $'\xc2\xa0'
  said $'\xff' '\xff'
  said $'a\xc3' 'a\xc3'
  said $'\xc3(' '\xc3('
  said $'\xc0\x80' '\xc0\x80'
  said $'\xe0\x9f\xbf' '\xe0\x9f\xbf'
  said $'\xed\xa0\x80' '\xed\xa0\x80'
  said $'\xf0\x8f\xbf\xbf' '\xf0\x8f\xbf\xbf'
  said $'\xf4\x90\x80\x80' '\xf4\x90\x80\x80'
  said $'\xf5\x80\x80\x80' '\xf5\x80\x80\x80'
}

# The letters and decimals of a language make no difference.
SameInEveryLocale() { # slow
  make_locales
  local format locale
  for format in text json csv; do
    answers solve "${steel[@]}" --half-width 5.5e-3 --format $format --profile profile
    mv out expected
    mv profile expected-profile
    for locale in tr_TR de_DE; do
      LC_ALL=$locale.UTF-8 answers solve "${steel[@]}" --half-width 5.5e-3 --format $format --profile profile
      cmp out expected && cmp profile expected-profile || fail "$locale makes a difference"
    done
  done
  local data=("${steel[@]:0:2}" "${steel[@]:4}" --radius 0.46) command
  printf '%s\n' friction,traction,peclet,heating 0.6,0.25,4360,0.0175 0.6,-0.5,100.5,1e-3 >scenes.csv
  for command in "figure-data kernels" "help solve" "solve ${data[*]} --creep-ratio 0.005" \
    "solve ${data[*]} --tangential_load -6.5e6 --profile profile --profile-points 9 --format json" \
    "temperature ${data[*]} --creep_ratio 0.005 --at -0.5:1.5:3 --depth 0,0.25" \
    "creep-curve ${hot_scene[*]} --points 3" "law ${hot_scene[*]} --tolerance 1e-2 --format c" \
    "law ${hot_scene[*]} --tolerance 1e-2 --format json" "sweep scenes.csv --output - --format jsonl"; do
    # shellcheck disable=SC2086
    answers $command
    mv out expected
    for locale in tr_TR de_DE; do
      # shellcheck disable=SC2086
      LC_ALL=$locale.UTF-8 answers $command
      cmp out expected || fail "$locale makes a difference to $command"
      LC_ALL=$locale.UTF-8 refuses 2 "unexpected --FRICTION-LIMIT (see --help)" solve --FRICTION-LIMIT 1
      LC_ALL=$locale.UTF-8 refuses 2 "(did you mean --friction?)" solve --fric_tion 1
    done
  done
}

# Where nothing may be written, and where a file may not grow as large as it would. The program must
# be one that anybody can run.
ReadOnlyFolderAndFullDisk() {
  local arguments
  cp "$program" program
  echo old >file
  chmod 755 "$scratch" . program
  for arguments in "solve ${paper_scene[*]} --output file" "solve ${paper_scene[*]} --profile new" \
    "figure-data kernels --output file" "temperature ${paper_scene[*]} --at 0 --output new"; do
    status=0
    # shellcheck disable=SC2086
    powerless ./program $arguments >out 2>err || status=$?
    [ $status -eq 1 ] && [ ! -s out ] || fail "$arguments gave status $status: $(cat err)"
    one_line "cannot write ${arguments##* }: Permission denied"
  done
  for arguments in "temperature ${paper_scene[*]} --at 0:1:101 --output file" \
    "solve ${paper_scene[*]} --profile file" "figure-data kernels --output file" \
    "law ${hot_scene[*]} --tolerance 1e-2 --output file" "creep-curve ${hot_scene[*]} --points 51 --output file"; do
    status=0
    # shellcheck disable=SC2086
    (ulimit -f 1 && "$program" $arguments 2>err) || status=$?
    [ $status -eq 1 ] || fail "$arguments gave status $status: $(cat err)"
    one_line "cannot write file: File too large"
  done
  [ "$(cat file)" = old ] || fail "the old file was changed"
  [ "$(ls)" = "$(printf '%s\n' err file out program)" ] || fail "left behind: $(ls)"
}

# A signal while it computes, with files to be written.
InterruptedLeavesNothing() {
  echo old >file
  local slow=(--method gauss-chebyshev --nodes 5000) signal number name
  while read -r signal number name; do
    interrupt "$signal" 0 "$program" solve "${paper_scene[@]}" "${slow[@]}" --output file >out
    [ $status -eq "$number" ] && [ ! -s out ] || fail "status $status: $(cat err)"
    one_line "stopped by a signal: $name"
    interrupt "$signal" 0 "$program" figure-data values --output new >out
    [ $status -eq "$number" ] && [ ! -s out ] || fail "status $status: $(cat err)"
  done <<'END'
INT 130 Interrupt
TERM 143 Terminated
HUP 129 Hangup
END
  [ "$(cat file)" = old ] || fail "the old file was changed"
  [ "$(ls)" = "$(printf '%s\n' err file out)" ] || fail "left behind: $(ls)"
}

# A signal while it waits for the reader of a pipe, with the other file prepared.
InterruptedAtAPipe() {
  mkfifo pipe
  "$program" solve "${paper_scene[@]}" --output file --profile pipe 2>err &
  until [ -n "$(find . -name 'thermoroll-*')" ]; do sleep 0.05; done
  kill -TERM $!
  status=0
  wait $! || status=$?
  [ $status -eq 143 ] || fail "status $status: $(cat err)"
  [ "$(ls)" = "$(printf '%s\n' err pipe)" ] || fail "left behind: $(ls)"
}

FullDevice() {
  local arguments
  for arguments in --help --version "solve --help" "figure-data --list" "figure-data kernels" \
    "solve ${paper_scene[*]}" "temperature ${paper_scene[*]} --at 0" \
    "creep-curve ${hot_scene[*]} --points 3" "law ${hot_scene[*]} --tolerance 1e-2" "help --format man"; do
    status=0
    # shellcheck disable=SC2086
    "$program" $arguments >/dev/full 2>err || status=$?
    [ $status -eq 1 ] || fail "$arguments gave status $status"
    one_line "cannot write to standard output: No space left on device"
  done
}

ClosedPipe() {
  set +o pipefail
  local arguments
  for arguments in "solve ${paper_scene[*]}" "law ${hot_scene[*]} --tolerance 1e-2" "creep-curve ${hot_scene[*]} --points 3"; do
    # shellcheck disable=SC2086
    { sleep 0.3; status=0; "$program" $arguments 2>err || status=$?; echo $status >status; } | true
    [ "$(cat status)" = 1 ] || fail "$arguments gave status $(cat status)"
    one_line "cannot write to standard output: Broken pipe"
  done
  status=0
  "$program" solve "${paper_scene[@]}" 2>err >&- || status=$?
  [ $status -eq 1 ] || fail "status $status with standard output closed"
  one_line "cannot write to standard output"
}

VerboseTellsTheTime() {
  answers solve "${paper_scene[@]}"
  cp out expected
  run solve "${paper_scene[@]}" --verbose
  cmp out expected || fail "the time is part of the answer"
  grep -qx 'thermoroll: [0-9.e-]* s' err || fail "said: $(cat err)"
}

# A line for each grid: the border's, then the others with a change and an estimate, of which the last is
# below the tolerance. Where that is not met the lines come before the refusal.
TraceTellsTheGrids() {
  local case=(--friction 0.6 --traction 0.5 --peclet 100 --heating 1 --method coupled)
  answers solve "${case[@]}" --format json --tolerance 1e-8
  cp out expected
  run solve "${case[@]}" --format json --tolerance 1e-8 --trace
  cmp out expected || fail "the trace is part of the answer"
  head -1 err | grep -qE '^unknowns +border +newton +tail +change +estimate$' || fail "said: $(cat err)"
  awk -v unknowns="$(value unknowns)" '
    NR == 2 { wrong += $5 != "-" || $6 != "-" }
    NR > 2 { wrong += !($1 > before) || !($3 > 0) || $6 == "-" }
    { before = $1; last = $6 }
    END { exit wrong || NR < 4 || before != unknowns || !(last <= 1e-8) }' err || fail "$(cat err)"
  run solve "${case[@]}" --tolerance 1e-2 --trace --method closed-form
  [ "$(wc -l <err)" = 1 ] || fail "grids of the closed form: $(cat err)"
  run solve --friction 0.4776 --traction 0.2663 --peclet 200077 --heating 30 --formulation printed \
    --method coupled --tolerance 1e-9 --trace
  [ "$status" = 1 ] && [ ! -s out ] && [ "$(wc -l <err)" -ge 4 ] && tail -1 err | grep -q '^thermoroll: coupled: not resolved' ||
    fail "status $status, said: $(cat err)"
}

# --- Creep curves and laws ------------------------------------------------------------------------

hot_scene=(--friction 0.6 --peclet 100 --heating 0.0175 --friction-law linear --friction-temperature 0.02)
wheel=(--friction 0.6 --load 1.2e7 --speed 22.2 --half-width 5.5e-3 --shear-modulus 8.1e10 --poisson 0.3
  --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50)

# law_in LANGUAGE FILE ARGUMENT...: the law of a scene, in a file.
law_in() {
  local language=$1 file=$2
  shift 2
  run law "$@" --format "$language" --output "$file"
  [ $status -eq 0 ] && [ ! -s out ] && [ ! -s err ] || fail "law $*: $status $(cat out err)"
}

# compiled [speed]: makes a program `law` of law.c that reads creeps, or creeps and speeds, and prints
# traction, slope, temperature and status, one line each.
compiled() {
  local given='scanf("%lf", &x) == 1' arguments='x'
  [ "${1:-}" ] && given='scanf("%lf %lf", &x, &v) == 2' arguments='x, v'
  cat law.c - >main.c <<END
#include <stdio.h>
int main(void) {
  for (double ${arguments/,/ = 0,}, q, s, t; $given;) {
    const int status = creep_law($arguments, &q, &s, &t);
    printf("%.17g %.17g %.17g %d\\n", q, s, t, status);
  }
  return 0;
}
END
  ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -o law main.c -lm || fail "does not compile"
}

# Traction and temperature are within a hundredth of a per cent of what is solved for, on both sides
# and in both regimes (the tolerance is 1e-4, of the temperature relative), and the slope is the tilt.
LawRunsInC() {
  law_in c law.c "${hot_scene[@]}"
  compiled
  local creep q slope t code tilt
  for creep in 0.1 0.25 0.5 3 -0.05 -0.3 -1; do
    read -r q slope t code < <(echo $creep | ./law)
    answers solve "${hot_scene[@]}" --creep=$creep --format json
    near "$q" "$(value traction)" 1e-4
    near "$t" "$(value max_temperature)" "$(calculate "1e-4 * $(value max_temperature)")"
    [ "$code" = 0 ] || fail "status $code"
    tilt=$(printf '%s\n' "$(calculate "$creep + 1e-5")" "$(calculate "$creep - 1e-5")" | ./law |
      awk 'NR == 1 { q = $1 } NR == 2 { printf "%.17g", (q - $1) / 2e-5 }')
    near "$slope" "$tilt" 1e-6
  done
}

# A hot wheel on a cold rail: the law begins at what there is without slip, in C, Python and JSON as in
# solve and in the table of the curve.
LawOfAHotWheel() {
  local wheel=(--friction 0.4 --peclet 300 --heating 0.02 --roller identical --bulk-difference 0.008) creep q
  law_in c law.c "${wheel[@]}"
  compiled
  law_in python law.py "${wheel[@]}"
  answers creep-curve "${wheel[@]}" --points 7 --from -0.5 --to 0.5
  cp out curve.csv
  for creep in 0.0008 0.01 0.2 0.6 -0.0005 -0.1; do
    answers solve "${wheel[@]}" --creep=$creep --format json
    q=$(value traction)
    near "$(echo $creep | ./law | cut -d' ' -f1)" "$q" 1e-4
    near "$(python3 -c "from law import creep_law; print(creep_law($creep)[0])")" "$q" 1e-4
  done
  # before its first piece the law is a straight line, next to the traction without slip
  local rest slope
  rest=$(sed -n 's/^static const double no_slip_creep\[\] = {\(.*\)};/\1/p' law.c)
  slope=$(calculate "($(calculate "$rest + 4e-5" | ./law | cut -d' ' -f1) - $(calculate "$rest + 2e-5" | ./law | cut -d' ' -f1)) / 2e-5")
  near "$(calculate "$rest + 3e-5" | ./law | cut -d' ' -f2)" "$slope" 1e-7
  near "$(python3 -c "from law import creep_law; print(creep_law($rest + 3e-5)[1])")" "$slope" 1e-7
  near "$(cut -d, -f2 curve.csv | sed -n 8p)" "$(echo 0.5 | ./law | cut -d' ' -f1)" 1e-12
  near "$(cut -d, -f2 curve.csv | sed -n 2p)" "$(echo -0.5 | ./law | cut -d' ' -f1)" 1e-12
}

# Beyond its end, and where there is no number, a law says so and gives nothing.
LawEndsInC() {
  law_in c law.c --friction 0.6 --peclet 0.5 --heating 1
  grep -q '^// Driving ends at the creep 7\.78.*: contact is lost: separation\.$' law.c || fail "$(head law.c)"
  compiled
  [ "$(printf '%s\n' 7.8 -6.4 inf nan | ./law | sort -u)" = "0 0 0 1" ] || fail "it goes on"
  [ "$(printf '%s\n' 7.7 -6.3 | ./law | cut -d' ' -f1,4 | tr '\n' ' ')" = "0.59999999999999998 0 -0.59999999999999998 0 " ] ||
    fail "it ends too early: $(echo 7.7 -6.3 | ./law)"
}

# Without heat and with constant friction there is no end.
LawWithoutEndInC() {
  law_in c law.c --friction 0.6 --peclet 100
  compiled
  [ "$(printf '%s\n' 1e12 -1e12 | ./law | cut -d' ' -f1,4 | tr '\n' ' ')" = "0.59999999999999998 0 -0.59999999999999998 0 " ] ||
    fail "$(echo 1e12 -1e12 | ./law)"
}

creeps_of_both_sides='0.001 0.02 0.1 0.25 0.31 0.32 0.5 3 50 -0.004 -0.05 -0.3 -1 -20 1e9 -1e9'

# The same function to rounding.
LawRunsInPython() {
  law_in c law.c "${hot_scene[@]}"
  compiled
  law_in python law.py "${hot_scene[@]}"
  tr ' ' '\n' <<<"$creeps_of_both_sides" | ./law >expected
  python3 - $creeps_of_both_sides <<'END' || fail "Python and C differ"
import sys
from law import creep_law
for creep, line in zip(sys.argv[1:], open("expected"), strict=True):
    expected, found = [float(x) for x in line.split()], creep_law(float(creep))
    assert all(abs(a - b) <= 1e-12 * abs(a) + 1e-15 for a, b in zip(expected, found, strict=True)), (expected, found)
END
}

# A law names its scene as a result does, in JSON and in the comment of a program.
# The number that is told as an end is on the law: rounding in other units does not put it beyond.
LawEndsWhereItSays() {
  run law --format python --output law.py --friction 0.5463 --load 5.836e6 --speed 7.334 --half-width 0.008557 --shear-modulus 8.1e10 \
    --poisson 0.3 --expansion 1.036e-5 --diffusivity 3.237e-5 --conductivity 72.01 --roller conducting --conductivity-2 20 \
    --expansion-2 1.1e-5 --diffusivity-2 1.444e-5 --bulk-temperature 27.98 --bulk-temperature-2 71.2 \
    --friction-law rational --friction-temperature 578.3 --friction-floor 0.4237 --tolerance 1e-5
  [ $status -eq 0 ] || fail "$(cat err)"
  python3 - <<'END' || fail "$(grep ends law.py)"
import re, sys
sys.path.insert(0, ".")
import law
ends = [float(x) for x in re.findall(r"ends at the creep (\S+):", open("law.py").read())]
assert len(ends) == 2 and all(law.creep_law(end)[3] == 0 and law.creep_law(end * (1 + 1e-13))[3] == 1 for end in ends), ends
END
}

LawTellsItsScene() {
  local scene=(--friction 0.6 --peclet 10 --heating 0.01 --tolerance 1e-2 --roller conducting
    --conductivity-ratio 2 --heating-2 0.02 --peclet-2 20 --bulk-difference 0.001
    --friction-law linear --friction-temperature 0.3 --friction-floor 0.4 --friction-reference-temperature 0.002)
  law_in json law.json "${scene[@]}"
  law_in c law.c "${scene[@]}"
  answers solve "${scene[@]}" --creep 0.1 --format json
  local key
  for key in friction peclet heating formulation roller conductivity_ratio heating_2 peclet_2 bulk_difference friction_law \
    friction_temperature friction_floor friction_reference_temperature; do
    [ "$(value $key)" ] && grep -q "^ *\"$key\": \"\{0,1\}$(value $key)\"\{0,1\},$" law.json || fail "$key: $(head -12 law.json)"
    grep -q "^//   $key = \"\{0,1\}$(value $key)\"\{0,1\}$" law.c || fail "$key: $(head -12 law.c)"
  done
  law_in c law.c "${wheel[@]}" --tolerance 1e-2
  data="load = 1.2e+07 N/m|speed = 22.2 m/s|half_width = 0.0055 m|shear_modulus = 8.1e+10 Pa|poisson = 0.3|expansion = 1.1e-05 1/K|diffusivity = 1.4e-05 m^2/s|conductivity = 50 W/(m K)"
  in_si() { sed -n '/^\/\/ In SI units:$/,/^\/\/ [^ ]/p' "$1" | sed -n 's|^//   ||p' | paste -sd'|'; }
  [ "$(in_si law.c)" = "$data" ] || fail "$(in_si law.c)"
  grep -qx "// Both surfaces have one speed in the model: creeps up to 0.1." law.c || fail "$(head -12 law.c)"
  law_in json law.json "${wheel[@]}" --tolerance 1e-2
  grep -qx ' "roller": "insulated",' law.json || fail "$(head -12 law.json)"
  ! grep -q "friction_law\|conductivity_ratio\|bulk_temperature\|_2" law.json || fail "what is not there: $(head -12 law.json)"
  grep -qx ' "speed": 22.2,' law.json || fail "$(head -12 law.json)"
  law_in c law.c "${wheel[@]}" --bulk-temperature 20 --tolerance 1e-2
  [ "$(in_si law.c)" = "$data|bulk_temperature = 20 degree C" ] || fail "$(in_si law.c)"
  law_in json law.json "${wheel[@]}" --bulk-temperature 20 --tolerance 1e-2
  grep -qx ' "bulk_temperature": 20.0,' law.json || fail "$(head -12 law.json)"
  law_in c law.c "${wheel[@]}" --bulk-temperature 20 --bulk-temperature-2 25 --tolerance 1e-2 --roller conducting --conductivity-2 30 \
    --expansion-2 1.2e-5 --friction-law linear --friction-temperature 1600 --friction-reference-temperature 50
  data="$data|expansion_2 = 1.2e-05 1/K|diffusivity_2 = 1.4e-05 m^2/s|conductivity_2 = 30 W/(m K)|bulk_temperature = 20 degree C"
  [ "$(in_si law.c)" = "$data|bulk_temperature_2 = 25 degree C|friction_temperature = 1600 K|friction_reference_temperature = 50 degree C" ] ||
    fail "$(in_si law.c)"
}

# The data that a result tells give the same result again, byte for byte, whose half-width is given.
ResultsTellTheirData() {
  local steel=(--load 1.2e7 --speed 22.2 --shear-modulus 8.1e10 --poisson 0.3 --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50)
  local more=(--bulk-temperature 20 --friction-law linear --friction-temperature 800)
  local unlike=(--roller conducting --conductivity-2 30 --expansion-2 1.2e-5 --diffusivity-2 1.2e-5)
  again() { # the options that are no data
    answers solve "${steel[@]}" "$@" --friction 0.3 --creep 0.1 --format json
    sed -n '/^  "data_in_si": {$/,/^  }$/p' out | sed -n 's/^    "\(.*\)": \(.*[^,]\),\{0,1\}$/\1 \2/p' >told
    mapfile -t data < <(sed 's/^/--/; s/ .*//; s/_/-/g' told | paste -d'\n' - <(sed 's/.* //' told))
    mv out first
  }
  again --half-width 0.0055
  [ ${#data[@]} = 16 ] || fail "${data[*]}"
  answers solve "${data[@]}" --friction 0.3 --creep 0.1 --format json
  cmp first out || fail "${data[*]}"
  again --half-width 0.0055 "${unlike[@]}" "${more[@]}" --bulk-temperature-2 25 --friction-reference-temperature 50
  [ ${#data[@]} = 30 ] || fail "${data[*]}"
  answers solve "${data[@]}" --roller conducting --friction-law linear --friction 0.3 --creep 0.1 --format json
  cmp first out || fail "${data[*]}"
  again --radius 0.46
  [ "$(sed -n 's/^half_width //p' told)" = "$(sed -n 's/^    "half_width": \(.*\),$/\1/p' first | head -1)" ] || fail "$(cat told)"
}

# The tables alone are enough: the series as the sum of cosines that it is.
LawRunsFromJson() {
  law_in c law.c "${wheel[@]}" --tolerance 1e-3
  compiled
  law_in json law.json "${wheel[@]}" --tolerance 1e-3
  python3 - <<'END' || fail "JSON and C differ"
import json, math, subprocess
o = json.load(open("law.json"))
assert o["error_estimate"]["traction"] <= 1.2e7 * 1e-3 and o["friction"] == 0.6
def law(creep):
    side = int(creep < 0)
    size, unit = abs(creep) / o["creep_unit"], o["unit_creep"][side]
    last = o["last_creep"][side]
    if last is not None and size > last:
        return 0, 0, 1
    z = math.sqrt(size / unit) if size <= unit else 2 - unit / size
    pieces = range(o["first_piece"][side], o["first_piece"][side + 1])
    k = min(pieces, key=lambda k: max(o["from_z"][k] - z, z - o["to_z"][k]))
    a, b = o["from_z"][k], o["to_z"][k]
    angle = math.acos(max(-1, min(1, 2 * (z - a) / (b - a) - 1)))
    q, t = (sum(c * math.cos(j * angle) for j, c in enumerate(o[key][11 * k:11 * k + 11]))
            for key in ("traction_terms", "temperature_terms"))
    if a < 1:
        q *= size
    else:
        t *= size / unit
    return math.copysign(1, creep) * q * o["traction_unit"], t * o["temperature_unit"], 0
creeps = [sign * o["creep_unit"] * x for x in (0.01, 0.1, 0.3, 0.5, 2, 1e6) for sign in (1, -1)]
lines = subprocess.run("./law", input="\n".join(map(repr, creeps)), capture_output=True, text=True).stdout.split("\n")
for creep, line in zip(creeps, lines):
    q, _, t, code = map(float, line.split())
    found = law(creep)
    assert abs(found[0] - q) <= 1e-9 * abs(q) and abs(found[1] - t) <= 1e-9 * abs(t) and found[2] == code, (creep, line, found)
END
}

# A law for a range of speeds: at any of them as solve, and the same function in all languages.
by_speed=("${wheel[@]:0:4}" "${wheel[@]:6}" --roller identical --bulk-temperature 20 --friction-law
  exponential --friction-temperature 400 --friction-floor 0.3)

LawBySpeedAgreesWithSolve() {
  law_in c law.c "${by_speed[@]}" --speed 5 --to-speed 20
  compiled speed
  local speed creep q slope t code tilt
  for speed in 5 7.7 20; do
    for creep in 0.2 -0.3 0.7; do
      answers solve "${by_speed[@]}" --speed $speed --creep=$creep --format json
      read -r q slope t code < <(echo "$(value creep_ratio) $speed" | ./law)
      near "$q" "$(calculate "1.2e7 * $(value traction)")" 1200
      near "$t" "$(value max_temperature_celsius)" "$(calculate "2e-4 * $(value max_temperature_celsius)")"
      [ "$code" = 0 ] || fail "status $code"
    done
  done
  tilt=$(printf '%s\n' "0.002001 7.7" "0.001999 7.7" | ./law | awk 'NR == 1 { q = $1 } NR == 2 { printf "%.17g", (q - $1) / 2e-6 }')
  near "$(echo 0.002 7.7 | ./law | cut -d' ' -f2)" "$tilt" "$(calculate "1e-5 * $tilt")"
  [ "$(printf '%s\n' "0.002 4.99" "0.002 20.01" "nan 7" "0.002 nan" | ./law | sort -u)" = "0 0 0 1" ] || fail "it goes on"
  grep -qx "//   speed = 5 to 20 m/s" law.c || fail "$(head -20 law.c)"
  grep -qx "// At speeds outside of this range the status is 1\." law.c || fail "$(head -20 law.c)"
}

LawBySpeedRunsInAllLanguages() {
  local range=("${by_speed[@]}" --speed 1 --to-speed 400)
  law_in c law.c "${range[@]}"
  compiled speed
  local speed
  for speed in 1 1.3 11 40 41 399 400 401; do
    sed "s/.*/& $speed/" <<<"${creeps_of_both_sides// /$'\n'}"
  done >creeps
  law_in modelica law.mo "${range[@]}"
  same_tables speeds share_creep
  [ "$(sed -n 's/^static const double speeds.* = //p' law.c | tr ',' '\n' | wc -l)" -gt 5 ] || fail "one piece"
  runs_in_modelica
  law_in python law.py "${range[@]}"
  law_in json law.json "${range[@]}"
  python3 - <<'END' || fail "Python, JSON and C differ"
import json
import law
tables = json.load(open("law.json"))
for name in ("speeds", "no_slip_creep", "unit_creep", "first_piece", "from_z", "traction_terms", "temperature_terms"):
    assert tables[name] == getattr(law, name), name
assert "speed" not in tables and len(tables["end_reason"]) == 2 * len(law.speeds)
for given, line in zip(open("creeps"), open("expected"), strict=True):
    expected, found = [float(x) for x in line.split()], law.creep_law(*map(float, given.split()))
    assert all(abs(a - b) <= 1e-12 * abs(a) + 1e-15 for a, b in zip(expected, found, strict=True)), (given, expected, found)
END
}

# Modelica has the tables of C, and its statements, translated to Python, give the values of C.
LawInModelicaHasTheNumbers() {
  law_in c law.c "${hot_scene[@]}"
  law_in modelica law.mo "${hot_scene[@]}"
  same_tables
  compiled
  tr ' ' '\n' <<<"$creeps_of_both_sides" >creeps
  runs_in_modelica
}

same_tables() {
  local name
  for name in no_slip_creep no_slip_traction coldest unit_creep last_creep first_piece from_z to_z traction_terms \
    temperature_terms "$@"; do
    sed -n "s/^static const [a-z]* $name\[\] = //p" law.c >tables_c
    sed -n "s/^  constant [A-Za-z]* $name\[:\] = //p" law.mo | sed 's/1e300/HUGE_VAL/g' >tables_modelica
    [ -s tables_c ] && cmp tables_c tables_modelica || fail "$name differs"
  done
  [ "$(grep -c '^end creep_law;$' law.mo)" = 1 ] || fail "no end"
}

# runs_in_modelica: law.mo against ./law at the lines of the file creeps.
runs_in_modelica() {
  ./law <creeps >expected
  python3 - <<'END' || fail "Modelica and C differ"
import math, re
class Array(list):
    def __getitem__(self, i): return list.__getitem__(self, int(i) - 1)
    def __setitem__(self, i, value): list.__setitem__(self, int(i) - 1, value)
    def __add__(self, other): return Array(a + b for a, b in zip(self, other, strict=True))
    def __sub__(self, other): return Array(a - b for a, b in zip(self, other, strict=True))
    def __rmul__(self, factor): return Array(factor * a for a in self)
declared, algorithm = open("law.mo").read().split("\nalgorithm\n")
def expression(e):
    e = re.sub(r"\(if ([^()]*) then ([^()]*) else ([^()]*)\)", r"((\2) if (\1) else (\3))", e)
    e = re.sub(r"^if (.*) then (.*) else (.*)$", r"(\2) if (\1) else (\3)", e)
    return re.sub(r"\{([^{}]*)\}", r"Array([\1])", e)
def loop(r):
    ends = [expression(e) for e in r.split(":")]
    return f"range({ends[0]}, {ends[-1]} + 1)" if len(ends) == 2 else f"range({ends[0]}, {ends[2]} - 1, {ends[1]})"
inputs = re.findall(r"^  input Real (\w+);", declared, re.M)
lines = [f"def creep_law({', '.join(inputs)}):"]
for name, value in re.findall(r"^  constant \w+ (\w+)(?:\[:\])? = (.*);$", declared, re.M):
    lines.append(f"    {name} = {expression(value)}")
depth, at = 1, 0
step = re.compile(r"\s*(?:for (\w+) in ([^;]+?) loop|while ([^;]+?) loop|if ([^;]+?) then(?=\n)|(else)(?=\n)|"
                  r"(end (?:for|while|if));|(return);|(\w+(?:\[i\])?) := (.*?);)")
while not algorithm[at:].strip().startswith("end creep_law;"):
    m = step.match(algorithm, at)
    assert m, algorithm[at:at + 80]
    each, within, until, case, other, end, leave, name, value = m.groups()
    at = m.end()
    depth -= bool(other or end)
    line = (f"for {each} in {loop(within)}:" if each else f"while {until}:" if until else f"if {case}:" if case else
            "else:" if other else "return traction, slope, temperature, status" if leave else
            f"{name} = {expression(value)}" if name else "pass")
    lines.append("    " * depth + line)
    depth += bool(each or until or case or other)
assert depth == 1 and at > 500
lines.append("    return traction, slope, temperature, status")
space = {"Array": Array, "sqrt": math.sqrt, "log": math.log, "div": lambda a, b: a // b}
exec("\n".join(lines), space)
count = 0
for given, line in zip(open("creeps"), open("expected"), strict=True):
    expected, found = [float(x) for x in line.split()], space["creep_law"](*map(float, given.split()))
    assert all(abs(a - b) <= 1e-12 * abs(a) + 1e-15 for a, b in zip(expected, found, strict=True)), (given, expected, found)
    count += expected[3] == 0
assert count > 10, count
END
}

# With data in SI units: the creep as a fraction of the speed, N/m, and degree C.
LawInSiUnitsRuns() {
  law_in c law.c "${wheel[@]}"
  compiled
  local creep q slope t code
  for creep in 0.2 -0.3 0.7; do
    answers solve "${wheel[@]}" --creep=$creep --format json
    read -r q slope t code < <(value creep_ratio | ./law)
    near "$q" "$(calculate "1.2e7 * $(value traction)")" 1200
    near "$t" "$(value max_temperature_celsius)" "$(calculate "1e-4 * $(value max_temperature_celsius)")"
    [ "$code" = 0 ] || fail "status $code $slope"
  done
}

# Rows are solutions, within the errors that stand in them and those of solve at 1e-6.
CreepCurveAgreesWithSolve() {
  answers creep-curve "${hot_scene[@]}" --from -1 --to 1 --points 9
  sed 1d out | tr ',' ' ' >rows
  [ "$(wc -l <rows)" = 9 ] || fail "$(cat rows)"
  local creep traction border full temperature errors_q errors_c errors_t
  while read -r creep traction border full temperature errors_q errors_c errors_t; do
    answers solve "${hot_scene[@]}" --creep="$creep" --format json
    near "$traction" "$(value traction)" "$(calculate "$errors_q + 1e-6")"
    near "$border" "$(value stick_slip_border)" "$(calculate "$errors_c + 1e-6")"
    near "$temperature" "$(value max_temperature)" "$(calculate "$errors_t + 1e-6")"
    [ "$full" = "$(value full_slip)" ] || fail "$creep: $full"
  done <rows
}

# Creeps ascend from one end to the other, and half of them stand about the two maxima.
CreepCurveIsDenseWhereItBends() {
  answers creep-curve "${hot_scene[@]}" --from -2 --to 3 --points 51
  sed 1d out | awk -F, '
    NR == 1 && $1 != -2 || NR > 1 && $1 <= last { exit 1 }
    { last = $1; size = $1 < 0 ? -$1 : $1; if (size > 0.1 && size < 0.5) ++about }
    END { if (NR != 51 || last != 3 || about < 25) exit 1 }' || fail "$(cut -d, -f1 out)"
}

# Without a range the rows cover both maxima, or reach as far as the curve.
CreepCurveHasARange() {
  answers creep-curve "${hot_scene[@]}"
  [ "$(wc -l <out)" = 102 ] || fail "$(wc -l <out) rows"
  near "$(sed -n 2p out | cut -d, -f1)" "$(calculate '-6 * 0.6 / pi')" 1e-12
  near "$(tail -1 out | cut -d, -f1)" "$(calculate '6 * 0.6 / pi')" 1e-12
  # the row next to no creep is there, and no zero has a sign
  answers creep-curve "${hot_scene[@]}" --from -1e-6 --to 1e-6 --points 3
  grep -q '^0,0,1,false,0,' out || fail "$(cat out)"
  answers creep-curve "${hot_scene[@]}" --from -0.1 --to -0 --points 3
  ! grep -q '\(^\|,\)-0\(,\|$\)' out || fail "$(cat out)"
}

CreepCurveInSiUnits() {
  answers creep-curve "${wheel[@]}" --bulk-temperature 20 --from 0 --to 0.3 --points 3
  [ "$(head -1 out)" = "creep,traction,stick_slip_border,full_slip,max_temperature,creep_ratio,creep_speed_m_per_s,tangential_load,max_temperature_celsius,contact_temperature_celsius,error_estimate.traction,error_estimate.stick_slip_border,error_estimate.max_temperature,error_estimate.tangential_load,error_estimate.max_temperature_celsius" ] ||
    fail "$(head -1 out)"
  tail -1 out | tr , ' ' >row
  local creep traction border full temperature ratio speed force rise absolute rest
  read -r creep traction border full temperature ratio speed force rise absolute rest <row
  answers solve "${wheel[@]}" --bulk-temperature 20 --creep=$creep --format json
  near "$ratio" "$(value creep_ratio)" 1e-12
  near "$speed" "$(calculate "22.2 * $ratio")" 1e-12
  near "$force" "$(calculate "1.2e7 * $(value traction)")" 1200
  near "$rise" "$(value max_temperature_celsius)" "$(calculate "1e-4 * $(value max_temperature_celsius)")"
  near "$absolute" "$(calculate "20 + $rise")" 1e-9
  local of_q of_c of_t of_force of_rise
  IFS=' ' read -r of_q of_c of_t of_force of_rise <<<"$rest"
  near "$of_force" "$(calculate "1.2e7 * $of_q")" 1e-6
  near "$(calculate "$of_rise / $of_t")" "$(calculate "$rise / $temperature")" 1e-6
  [ "$border $full $of_c" != "  " ] || fail "no columns"
}

BadCurves() {
  local curve="creep-curve --friction 0.6 --peclet 100"
  refuses 2 "points = 1 is not allowed: it must be from 2 to 100000" $curve --points 1
  refuses 2 "points = 2.5 is not allowed" $curve --points 2.5
  refuses 2 "from = 1 is not allowed: it must be below --to, 1" $curve --from 1 --to 1
  refuses 2 "to = inf is not allowed" $curve --to inf
  refuses 2 "unexpected --creep" $curve --creep 0.1
  refuses 2 "tolerance = 1e-08 is not allowed: it must be from 1e-7 to 1e-2" $curve --tolerance 1e-8
  refuses 2 "to = 9 is not allowed: it must be at most about 7.78" creep-curve --friction 0.6 --peclet 0.5 --heating 1 --to 9
  refuses 2 "from = -9 is not allowed: it must be at least about -6.32" creep-curve --friction 0.6 --peclet 0.5 --heating 1 --from -9
  one_line "where the curve ends: contact is lost: separation"
  # the end that is told is one that is taken
  local end
  end=$(sed -E 's/.*at least about (-[0-9.]*),.*/\1/' err)
  answers creep-curve --friction 0.6 --peclet 0.5 --heating 1 --from "$end" --to 0 --points 2
  # an end as a fraction of the speed is refused as one
  refuses 2 "to-ratio = 100 is not allowed: it must be at most about " creep-curve "${wheel[@]}" --to-ratio 100
  end=$(sed -E 's/.*at most about ([-+0-9.e]*),.*/\1/' err)
  run creep-curve "${wheel[@]}" --to-ratio "$end" --points 2
  [ $status -eq 0 ] || fail "status $status: $(cat err)"
  # a traction that no contact has between that without slip and the friction is told as it was given
  refuses 2 "traction = 0.1 is not allowed: it must be beyond that of a contact without slip, and below the friction" \
    solve --peclet 100 --heating 1 --friction 0.3 --traction 0.1 --roller identical --bulk-difference 1e20
  # with a bulk difference the usual creeps may be no creeps of the curve, and an end is told towards
  # the creep without slip
  curve="creep-curve --friction 0.5 --peclet 1e-4 --heating 1e6 --roller identical --bulk-difference 20"
  refuses 2 "the curve has no creep between -0.95" $curve
  refuses 2 "from = 10 is not allowed: it must be at least about 900.1" $curve --from 10 --to 1000
  end=$(sed -E 's/.*at least about ([-+0-9.e]*),.*/\1/' err)
  run $curve --from "$end" --to "$end"1 --points 2
  [ $status -eq 0 ] || fail "status $status: $(cat err)"
  # next to no slip the thermal distortion of this contact takes more than friction
  refuses 1 "law: it ends where it begins: contact is lost: traction below -friction" creep-curve --friction 0.3 \
    --peclet 100 --heating 1 --roller identical --bulk-difference 0.5 --from 0.3 --to 0.8
  refuses 2 "from-ratio = 0.02 is not allowed: it must be below --to-ratio, 0.01" creep-curve "${wheel[@]}" --from-ratio 0.02 --to-ratio 0.01
  refuses 2 "from-ratio = 0.9 is not allowed: it must be below --to-ratio, 0.0" creep-curve "${wheel[@]}" --from-ratio 0.9
  refuses 2 "to-ratio = -0.5 is not allowed: it must be above --from-ratio, -0.0" creep-curve "${wheel[@]}" --to-ratio -0.5
  refuses 2 "--peclet is missing" creep-curve --friction 0.6
  refuses 2 "--friction is required" creep-curve --peclet 100
}

BadCreepLaws() {
  local law="law --friction 0.6 --peclet 100"
  refuses 2 "format = java is not allowed: it must be c or python or modelica or json" $law --format java
  local option
  for option in "--traction 0.5" "--creep 0.1" "--stick-slip-border 0" "--method coupled" "--nodes 100" \
    "--direction braking" "--branch falling" "--radius 0.5"; do
    # shellcheck disable=SC2086
    refuses 2 "unexpected ${option%% *}" $law $option
  done
  refuses 2 "tolerance = 0.1 is not allowed: it must be from 1e-7 to 1e-2" $law --tolerance 0.1
  refuses 2 "need --half-width: from a radius it would differ along them" law "${wheel[@]:0:6}" "${wheel[@]:8}"
  refuses 2 "--peclet and --heating exclude data in SI units" law "${wheel[@]}" --peclet 100
  refuses 2 "peclet = -1 is not allowed" law --friction 0.6 --peclet -1
  refuses 1 "cannot write nowhere/law.c" $law --output nowhere/law.c
  refuses 2 "for data in SI units only: --to-speed" $law --to-speed 10
  refuses 2 "to-speed = 22.2 is not allowed: it must be above speed = 22.2" law "${wheel[@]}" --to-speed 22.2
  refuses 2 "tolerance = 2e-07 is not allowed: it must be from 3e-7 to 1e-2" law "${wheel[@]}" --to-speed 30 --tolerance 2e-7
}

# --- The other subcommands ------------------------------------------------------------------------

# groff warns of nothing in the manual page. It has every option of every subcommand, below its name, and
# every line of the examples as it stands in the help.
ManualPage() {
  command -v groff >/dev/null || fail "groff is not there: install groff-base"
  answers help --format man
  cp out thermoroll.1
  groff -man -ww -Tascii -P-cbou -rLL=300n -rLT=300n thermoroll.1 >page 2>warnings || fail "$(cat warnings)"
  [ ! -s warnings ] || fail "groff said: $(cat warnings)"
  grep -q '^thermoroll - Rolling contact' <(sed 's/^ *//' page) || fail "no name: $(head -5 page)"
  local command line
  for command in solve sweep temperature creep-curve law figure-data claims help; do
    sed -n "/^thermoroll $command\$/,/^thermoroll [a-z]/p" page | sed 's/^ *//' >section
    [ -s section ] || fail "no $command"
    answers $command --help
    grep -o '^  [-h,]*--[a-z0-9-]*' out | sed 's/.* \(-h,\)\{0,1\}//' >options
    [ "$(wc -l <options)" -ge 3 ] || fail "$command: $(cat out)"
    while IFS= read -r line; do
      grep -q -- "^$line\( \|\$\)" section || fail "$command has no $line"
    done <options
    sed -n 's/^  \(thermoroll .*\)/\1/p' out >examples
    while IFS= read -r line; do
      grep -qxF -- "$line" section || fail "$command has no example $line"
    done <examples
  done
  run help --format man --output file
  cmp file thermoroll.1 || fail "another page in the file"
  echo '.nonsense' >>thermoroll.1
  groff -man -ww -z thermoroll.1 2>&1 | grep -q nonsense || fail "groff warns of nothing"
  refuses 2 "--format man is for the whole program, not solve" help solve --format man
  refuses 2 "format = html is not allowed: it must be text or man or bash" help --format html
}

# Bash's own completion with the function that the program writes.
Completion() {
  answers help --format bash
  cp out thermoroll.bash
  mkdir bin
  ln -s "$program" bin/thermoroll
  touch "a file.csv" scenes.csv
  completes() { # completes EXPECTED WORD...: the last word may become one of these
    local expected=$1 found
    shift
    found=$(PATH="$PWD/bin:$PATH" bash -c 'source ./thermoroll.bash
      COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
      complete_thermoroll
      printf "%s;" "${COMPREPLY[@]}"' bash "$@") || fail "$* ended with an error"
    [ "$found" = "$expected" ] || fail "$*: $found"
  }
  completes 'solve;' thermoroll so
  completes '--version;' thermoroll --v
  completes '--friction;--friction-law;--friction-temperature;--friction-floor;--friction-reference-temperature;' \
    thermoroll solve --peclet 100 --fric
  completes 'insulated;identical;conducting;' thermoroll solve --roller ''
  completes 'identical;' thermoroll solve --roller = id
  completes 'insulated;identical;conducting;' thermoroll solve --roller =
  completes ';' thermoroll solve --friction ''
  completes 'c;python;modelica;json;' thermoroll law --format ''
  completes 'text;json;csv;' thermoroll solve --format ''
  completes 'a file.csv;' thermoroll solve --output a
  completes 'scenes.csv;' thermoroll --config sc
  completes 'creep;creep-ratio;' thermoroll sweep --given cr
  completes 'load_ratio;' thermoroll sweep --columns load
  completes 'status,creep,max_temperature;status,creep,max_temperature_at;' thermoroll sweep --columns status,creep,max_t
  completes 'error_estimate.max_temperature;error_estimate.max_temperature_at;' thermoroll sweep --columns error_estimate.max_t
  completes 'kernels;' thermoroll figure-data kern
  completes 'creep-curve;' thermoroll help cr
  local command option
  for command in solve sweep temperature creep-curve law figure-data claims help; do
    answers $command --help
    for option in $(grep -o '^  [-h,]*--[a-z0-9-]*' out | sed 's/.*--/--/'); do
      grep -q "^  '$command '\*) words='.*$option " thermoroll.bash || fail "$command has no $option"
    done
  done
}

# In a scene file as on the command line.
NearestKey() {
  printf '%s\n' 'friction = 0.6' 'laod = 1' >scene.toml
  refuses 2 "the scene file sets what is no option of solve: laod (did you mean load?)" solve --config scene.toml --traction 0.5
  printf '%s\n' 'friction = 0.6' 'peclet = 100' 'heating = 0' 'creep = 0.1' >scene.toml
  refuses 2 "the scene file sets what is no option of creep-curve: creep (a section [solve] may have it)" creep-curve --config scene.toml
  sed -i '/creep/i [solve]' scene.toml
  answers solve --config scene.toml
  answers creep-curve --config scene.toml
  printf '%s\n' 'friction: 0.6' >scene.toml
  refuses 2 "the scene file sets what is no option of solve: friction: 0.6 (a line is NAME = VALUE)" solve --config scene.toml
}

# A file that is read is not written to, however it is named; a device may be both.
NoInputIsReplaced() {
  write_wheel
  cp wheel.toml kept.toml
  ln -s wheel.toml link.toml
  refuses 2 "--output and --config are the same file, wheel.toml" solve --config wheel.toml --output ./link.toml
  refuses 2 "--profile and --config are the same file" solve --config wheel.toml --profile wheel.toml
  refuses 2 "--output and --config are the same file" temperature --config wheel.toml --at 0 --output wheel.toml
  cmp wheel.toml kept.toml || fail "the scene file was changed"
  printf 'friction,traction,peclet\n0.6,0.5,100\n' >table.csv
  cp table.csv kept.csv
  refuses 2 "--output and the table are the same file, table.csv" sweep table.csv --output table.csv
  local option
  for option in --output --resume; do
    run sweep $option table.csv <table.csv
    [ $status -eq 2 ] || fail "status $status"
    one_line "$option and the table are the same file, /dev/stdin"
  done
  cmp table.csv kept.csv || fail "the table was changed"
  run solve --config wheel.toml --output /dev/null --profile /dev/null
  [ $status -eq 0 ] || fail "$(cat err)"
}

# The largest traction in N/m and its creep ratio, with errors, when driving and when braking.
LimitsInSi() {
  local sign more key
  for sign in "" -; do
    for more in "--half-width 5.5e-3" "--radius 0.46"; do
      answers solve "${steel[@]:0:2}" "${steel[@]:4}" $more --traction ${sign}0.2 --friction-law linear \
        --friction-temperature 200 --format json
      for key in tangential_load_limit:traction_limit:tangential_load:traction \
        creep_ratio_at_limit:creep_at_traction_limit:creep_ratio:creep; do
        set -- ${key//:/ }
        near "$(calculate "$(value $1) / $(value $3) * $(value $4) / $(value $2)")" 1 1e-12
        [ "$(grep -c "\"$1\": $sign[0-9]" out)" -ge 1 ] || fail "$(cat out)"
        # The error has no sign; so has the result when driving.
        [ "$(grep -c "\"$1\": [0-9.]*\(e-[0-9]*\)\?,\?$" out)" -eq $([ "$sign" ] && echo 1 || echo 2) ] || fail "no error: $(cat out)"
      done
    done
  done
  answers solve "${steel[@]}" --half-width 5.5e-3 --format json
  [ "$(value tangential_load_limit) $(value creep_ratio_at_limit)" = "null null" ] || fail "$(cat out)"
}

# The range of a curve as fractions of the speed, which are its column.
CurveByCreepRatio() {
  write_wheel
  sed -i /traction/d wheel.toml
  # Without creep it is zero, and not the rounding of the curve's length.
  answers creep-curve --config wheel.toml --roller identical --from-ratio -0.02 --to-ratio 0.02 --points 5
  [ "$(sed -n 4p out | cut -d, -f1,2)" = 0,0 ] || fail "$(sed -n 4p out)"
  answers creep-curve --config wheel.toml --from-ratio -0.01 --to-ratio 0.03 --points 5
  [ "$(head -1 out | cut -d, -f6)" = creep_ratio ] || fail "$(head -1 out)"
  # To a few units of rounding, by the factor of xi* and back.
  cut -d, -f6 out | awk 'NR == 2 { first = $1 } { last = $1 }
    END { a = first / -0.01 - 1; b = last / 0.03 - 1; exit !(a * a < 1e-28 && b * b < 1e-28) }' || fail "$(cat out)"
  refuses 2 "--to and --to-ratio exclude each other" creep-curve --config wheel.toml --to 1 --to-ratio 0.1
  refuses 2 "for data in SI units only: --to-ratio" creep-curve --friction 0.6 --peclet 100 --to-ratio 0.1
}

FigureData() {
  answers figure-data --list
  grep -qx kernels out && grep -qx values out || fail "$(cat out)"
  answers figure-data kernels
  cp out expected
  run figure-data kernels --output file
  cmp file expected || fail "file and standard output differ"
  refuses 2 "NAME = kernel is not allowed: it must be a name of figure-data --list (did you mean kernels?)" figure-data kernel
  refuses 2 "NAME = nowhere is not allowed: it must be a name of figure-data --list" figure-data nowhere
  ! grep -q 'did you mean' err || fail "$(cat err)"
  refuses 2 "NAME = ../kernels is not allowed" figure-data ../kernels
  local words="is not the output of thermoroll-bench"
  refuses 2 "/dev/null $words: it is not JSON" figure-data speed --times /dev/null
  refuses 2 "nowhere $words: it cannot be read" figure-data speed --times nowhere
  echo '{"benchmarks": 1}' >other
  refuses 2 "other $words: it has other contents" figure-data speed --times other
  echo 'times = "other"' >times.toml
  refuses 2 "no option of figure-data: times" figure-data speed --config times.toml
}

ClaimsInThreeFormats() { # slow
  answers claims
  head -1 out | grep -q '^claim  *source  *paper  *published_scheme  *converged  *corrected  *verdict$' || fail "$(head -1 out)"
  local rows=$(($(wc -l <out) - 1))
  [ $rows -ge 10 ] || fail "$rows claims"
  answers claims --format json
  [ "$(grep -c '"claim": ' out)" -eq $rows ] || fail "the JSON has other rows"
  [ "$(grep -o '"[a-z_]*": ' out | head -7 | tr -d '": ' | paste -sd' ')" = \
    "claim source paper published_scheme converged corrected verdict" ] || fail "keys: $(head -8 out)"
  answers claims --format csv
  [ "$(wc -l <out)" -eq $((rows + 1)) ] || fail "the CSV has other rows"
  # every row has seven cells, commas within quotes not counted
  sed 's/"[^"]*"//g' out | awk -F, 'NF != 7 { exit 1 }' || fail "$(cat out)"
}

Version() {
  answers --version
  grep -qxE 'thermoroll [0-9]+\.[0-9]+\.[0-9]+( \(.*[0-9a-f]{4,}(-dirty)?\))?' out || fail "$(cat out)"
  [ ! -e "$project/.git" ] || grep -q '(' out || fail "without a revision: $(cat out)"
}

Help() {
  local command
  for command in "" solve sweep temperature creep-curve law figure-data claims help; do
    # shellcheck disable=SC2086
    answers help $command
    cp out expected
    # shellcheck disable=SC2086
    answers $command --help
    cmp out expected || fail "help $command prints something else"
    grep -q '^Examples:$' out || fail "no examples: $command"
  done
  answers --help
  grep -q '^Exit status: 0 done; 1 ' out || fail "no exit status: $(cat out)"
  answers solve --help
  grep -q '^Errors are estimates, not bounds\.$' out && grep -q 'not count that in its errors' out || fail "does not say what the errors are: $(cat out)"
  for command in solve temperature creep-curve law; do
    answers $command --help
    tr '\n' ' ' <out | grep -q 'all heat goes into one body.*two steel bodies (--roller identical) are about half as hot' ||
      fail "$command does not say whom the heat warms: $(cat out)"
  done
}

# Every example of every --help, just as it stands there.
ExamplesRun() {
  write_wheel
  printf '%s\n' friction,traction,peclet 0.6,0.5,100 >scenes.csv
  mkdir bin
  ln -s "$program" bin/thermoroll
  local command count=0 example
  for command in "" solve sweep temperature creep-curve law figure-data claims help; do
    # shellcheck disable=SC2086
    answers $command --help
    sed -n '/^Examples:/,/^$/p' out | sed -e :a -e '/\\$/N; s/\\\n *//; ta' | sed -n 's/^  //p' >examples
    while IFS= read -r example; do
      PATH="$PWD/bin:$PATH" bash -c "$example" >/dev/null 2>err || fail "$example: $(cat err)"
      [ ! -s err ] || fail "$example said: $(cat err)"
      count=$((count + 1))
    done <examples
  done
  [ $count -ge 21 ] || fail "only $count examples found"
}

"$1"
