# Tangled from paper/L-recipes.md; edit there.
speeds='20 40 80'
for speed in $speeds; do
  thermoroll creep-curve --config locomotive.toml --speed $speed --from-ratio 0 --to-ratio 0.03 --output $speed.csv
done
awk -F, 'NR == 1 { print "speed,creep_percent,force_kn,celsius"; for (i = 1; i <= NF; ++i) at[$i] = i }
  FNR > 1 { printf "%d,%.10g,%.10g,%.10g\n", FILENAME, 100 * $at["creep_ratio"], \
    $at["tangential_load"] * 0.009 / 1000, $at["contact_temperature_celsius"] }' \
  $(printf '%s.csv ' $speeds) >curves.csv
