// Tangled from paper/L-recipes.md; edit there.
for speed in 20 40 80; do
  thermoroll creep-curve --config locomotive.toml --speed $speed --from 0 --to 1.25 --output $speed.csv
done
awk 'FNR == 1 && NR > 1 { next }
  { print (FNR == 1 ? "speed" : FILENAME + 0) "," $0 }' 20.csv 40.csv 80.csv >curves.csv
