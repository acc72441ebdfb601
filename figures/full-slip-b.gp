# Load ratio against creep through full slip, for two heatings, with the closed limit (dashed).
name = 'full-slip-b'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-4, 4, 0.9, 2.5)
eval axes('ξ*', 'κ')
set xtics 1
set ytics 0.5
set format y '%.1f'
set label 'brakes' at -3.6, 1.07
set label 'drives' at 2.8, 1.07
set key at screen 0.97, screen 0.99 right top samplen 2 maxrows 1 reverse Left width 1
curve(column_name, i, text) = \
  sprintf("data using 'creep':'limit_%s' with lines linetype %d dashtype (4,3) linewidth 0.8 notitle, " \
  ."data using 'creep':'%s' with lines linetype %d dashtype solid title '%s'", \
  column_name, i, column_name, i, text)
eval "plot ".curve('one', 1, '{/:Italic H} = 1').", ".curve('half', 2, '{/:Italic H} = 0.5')
