# Tangled from paper/L-recipes.md; edit there.
awk -v rows="${ROWS:-100000}" '
  function part(step) { return (i * step) % 1 }
  BEGIN {
    print "friction,traction,peclet,heating"
    for (i = 1; i <= rows; ++i) {
      f = 0.1 + 0.5 * part(0.8566748838545029)
      printf "%.6f,%.6f,%.6g,%.6g\n", f, f * (0.05 + 0.9 * part(0.7338918566271260)), \
        10^(4 * part(0.6287067210378087)), 10^(-3 + 4 * part(0.5385972572236101))
    }
  }' >scenes.csv
thermoroll sweep scenes.csv --tolerance 1e-3 --output sweep.csv \
  --columns friction,traction,peclet,heating,creep,load_ratio,max_temperature,status
