# Traction against creep through the end of the stick zone, braking and driving, for three heatings.
name = 'full-slip-a'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-0.7, 0.7, -0.7, 0.7)
eval axes('ξ*', 'Q*')
set xtics 0.2
set ytics 0.2
friction = 0.6
set arrow from 0, friction to x_max, friction nohead linetype 6
set arrow from x_min, -friction to 0, -friction nohead linetype 6
set label 'brakes' at -0.62, 0.1
set label 'drives' at 0.45, 0.1
set key at screen 0.97, screen 0.99 right top samplen 2 maxrows 1 reverse Left width 1
curve(column_name, i, text) = sprintf("data using 'creep':'%s' with lines linetype %d title '%s'", \
  column_name, i, text)
eval "plot ".curve('one', 1, '{/:Italic H} = 1').", ".curve('half', 2, '{/:Italic H} = 0.5').", ".curve('without', 3, '{/:Italic H} = 0')
