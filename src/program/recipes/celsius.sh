# Tangled from paper/L-recipes.md; edit there.
thermoroll temperature --config locomotive.toml --speed 40 --creep-ratio 0.01 \
  --at -1.5:3:91 --depth 0,0.01,0.03 --output celsius.csv
