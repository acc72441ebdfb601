# Tangled from paper/L-recipes.md; edit there.
mkfifo rows answers
thermoroll sweep --peclet 100 --heating 1 --columns creep,max_temperature <rows >answers &
exec 3>rows 4<answers
rm rows answers
ask() {
  echo "$1" >&3
  read -r answer <&4
  echo "$answer"
}
ask friction,traction
for traction in 0.1 0.2 0.3 0.4; do ask "0.6,$traction"; done
