# The heat flux into a cold rail and into the hot wheel on it, and what crosses in the closed form.
name = 'hot-wheel-a'
height = 300
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-1, 1, -4, 6)
eval axes('s', 'g*/C')
set xtics 0.5
set ytics 2
set key at screen 0.98, screen 0.99 right top samplen 1.5 maxrows 1 reverse Left width -2.5
eval "plot data using 's':'closed_rail' with lines linetype 6 title 'closed form', " \
  ."data using 's':'closed_wheel' with lines linetype 6 notitle, " \
  ."data using 's':'rail' with lines linetype 1 title 'rail', " \
  ."data using 's':'wheel' with lines linetype 3 title 'wheel'"
