# Tangled from paper/L-recipes.md; edit there.
sed -i 's|2 \* c.friction / pi \* std::sqrt|2.005 * c.friction / pi * std::sqrt|' paper/05-closed-form.md
make build/figures/slip.svg
