# The surface temperature of a cold rail under a hot wheel, with friction and without.
name = 'hot-wheel-b'
height = 300
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-2, 4, 0, 1.4)
eval axes('s', 'T*/Θ')
set xtics 1
set ytics 0.2
set key at screen 0.98, screen 0.99 right top samplen 1.5 maxrows 1 reverse Left width -2.9
eval "plot data using 's':'friction' with lines linetype 1 title 'friction', " \
  ."data using 's':'alone' with lines linetype 2 title 'no friction', " \
  ."data using 's':'closed' with lines linetype 6 title 'closed form'"
