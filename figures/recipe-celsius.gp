# The temperature along a locomotive's wheel on the surface and at two depths.
name = 'recipe-celsius'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

depths = '0 0.01 0.03'
at(k) = abs(column("depth") - real(word(depths, k))) < 1e-9 ? column("temperature_celsius") : NaN
eval range(-1.5, 3, 0, 100)
eval axes('s', '')
set ytics 25
set label 1 'rise of the temperature in °C' at graph 0, graph 1.09 left offset -4,0
set label 2 'surface' at first 1.1, first 88
set label 3 'depth 0.01' at first 1.5, first 26
set label 4 'depth 0.03' at first 2.2, first 10.5
plot for [k = 1:3] data using "s":(at(k)) with lines linetype k title 'depth '.word(depths, k)
