# What the closed form (dashed) and its linear correction (full) leave out, for two heatings.
name = 'small-heat'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(1e-2, 1e6, 1e-9, 0.1)
eval axes('Pe', '')
set label 'relative difference' at graph 0, graph 1.07 offset -4,0
set bmargin at screen 0.155
set rmargin at screen 0.95
set logscale xy
set xtics ('0.01' 1e-2, '1' 1, '100' 100, '10^4' 1e4, '10^6' 1e6) offset 0,0.2
set ytics ('0.1' 0.1, '10^{−3}' 1e-3, '10^{−5}' 1e-5, '10^{−7}' 1e-7, '10^{−9}' 1e-9)
set key at screen 0.97, screen 0.99 right top samplen 2 maxrows 1 reverse Left width 1
heating(k, i, text) = sprintf("data using 'peclet':'first_%d' with lines linetype %d dashtype solid title '%s', " \
  ."data using 'peclet':'closed_%d' with lines linetype %d dashtype (8,4) notitle", k, i, text, k, i)
eval "plot ".heating(1, 3, '{/:Italic H} = 0.1').", ".heating(2, 1, '{/:Italic H} = 0.01')
