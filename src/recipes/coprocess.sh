# Tangled from paper/L-recipes.md; edit there.
coproc thermoroll sweep --peclet 100 --heating 1 --columns creep,max_temperature
ask() {
  echo "$1" >&"${COPROC[1]}"
  read -r answer <&"${COPROC[0]}"
  echo "$answer"
}
ask friction,traction
for traction in 0.1 0.2 0.3 0.4; do ask "0.6,$traction"; done
