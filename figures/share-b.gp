# The heat flux into body 1 ahead of the border and behind it, for four speeds.
name = 'share-b'
height = 300
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-1, 0.25, 0, 0.5)
eval axes('s', 'g_1*')
set xtics 0.2
set ytics 0.1
set key at screen 0.98, screen 0.99 right top samplen 2 maxrows 1 reverse Left width -1.4
# Far ahead there is no flux; its rounding is below 1e-6, of either sign.
no_noise(flux) = abs(flux) < 1e-6 ? 0 : flux
curve(speed, i, text) = \
  sprintf("data using 's':(no_noise(column('%s'))) with lines linetype %d title '%s'", speed, i, text)
eval "plot ".curve('1', 1, 'Pe = 1').", " \
  .curve('10', 2, '10').", ".curve('100', 3, '100').", ".curve('1000', 4, '1000').", " \
  ."data using 's':'effusivity' with lines linetype 6 notitle"
