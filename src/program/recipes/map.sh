# Tangled from paper/L-recipes.md; edit there.
thermoroll temperature --config locomotive.toml --speed 40 --creep-ratio 0.01 \
  --at -1.2:2.4:37 --depth 0:0.024:17 --output map.csv
