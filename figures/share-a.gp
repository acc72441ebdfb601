# The share of the heat that flows into body 1 along the slip zone, for four speeds.
name = 'share-a'
height = 300
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-0.2, 1, 0, 1)
eval axes('s', 'g_1*/g*')
set xtics 0.2
set ytics 0.2
set key at screen 0.98, screen 0.99 right top samplen 2 maxrows 1 reverse Left width -1.4
set label 'effusivities' at 0.62, 0.585
set label 'conductivities' at -0.17, 0.285
level(y) = sprintf("set arrow from -0.2, %.10g to 1, %.10g nohead back linetype 6", y, y)
eval level(1/(1 + 2*sqrt(0.2)))
eval level(1/3.0)
curve(speed, i, text) = \
  sprintf("data using 's':'%s' with lines linetype %d title '%s'", speed, i, text)
eval "plot ".curve('1', 1, 'Pe = 1').", " \
  .curve('10', 2, '10').", ".curve('100', 3, '100').", ".curve('1000', 4, '1000')
