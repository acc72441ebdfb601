# The tractive force of a locomotive's wheel and its hottest point over the creep, at three speeds.
name = 'recipe-curves'
height = 560
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

speeds = '20 40 80'
of(k, value) = column("speed") == real(word(speeds, k)) ? value : NaN
set rmargin at screen 0.86
set multiplot

eval upper_panel
set tmargin at screen 0.93; set bmargin at screen 0.56
eval range(0, 3, 0, 40)
set xtics 1; set ytics 10
set label 1 'tractive force in kN' at graph 0, graph 1.09 left offset -4,0
set label 2 '20 m/s' at graph 1.02, first 32.3
set label 3 '80 m/s' at graph 1.02, first 28.3
plot for [k = 1:3] data using "creep_percent":(of(k, column("force_kn"))) \
  with lines linetype k title word(speeds, k).' m/s, force'

eval lower_panel
set tmargin at screen 0.43; set bmargin at screen 0.095
eval range(0, 3, 0, 320)
set ytics 100
set xlabel 'creep in % of the speed' offset 0,1.1
set label 1 'hottest point in °C' at graph 0, graph 1.09 left offset -4,0
set label 2 '20 m/s' at graph 1.02, first 180
set label 3 '40 m/s' at graph 1.02, first 236
set label 4 '80 m/s' at graph 1.02, first 304
plot for [k = 1:3] data using "creep_percent":(of(k, column("celsius"))) \
  with lines linetype k title word(speeds, k).' m/s, temperature'
unset multiplot
