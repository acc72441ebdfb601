# The temperature along a locomotive's wheel on the surface and at two depths.
name = 'recipe-celsius'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

at(depth) = abs(column("depth") - depth) < 1e-9 ? column("temperature_celsius") : NaN
eval range(-12, 24, 0, 100)
set xtics 6; set ytics 25
set xlabel 'position in mm' offset 0,1.1
set label 1 'temperature over ambient in °C' at graph 0, graph 1.09 left offset -4,0
set label 2 'surface' at first 8.6, first 88
set label 3 '0.08 mm below' at first 11.6, first 36
set label 4 '0.23 mm below' at first 14.5, first 11
plot for [k = 1:3] depth = word('0 0.01 0.03', k) data \
  using (column("x_m")*1000):(at(real(word('0 0.01 0.03', k)))) with lines linetype k \
  title word('surface|0.08 mm|0.23 mm', k)
