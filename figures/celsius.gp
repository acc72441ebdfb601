# The largest temperature in degrees over the speed of the wheel, Q* = 0.5; below, how far the curve and the points
# are from the square root of the speed, which in the upper panel they hide.
name = 'celsius'
height = 540
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 88, 0, 600)
set multiplot
set tmargin at screen 0.933
set bmargin at screen 0.425
set label 100 'largest rise, °C' at graph 0, graph 1.075 left offset -4,0
set xtics 25
set ytics 100
of(kind) = strcol("kind") eq kind ? column("celsius") : NaN
set label 'converged' at 84, 550 right
set label 'the paper' at 47.5, 445 right
set label 'published scheme, {/:Italic n} = 200' at 86, 335 right
set label "{/:Italic T} ∝ √{/:Italic V} through the\npaper's first value" at 24, 170
plot data using "speed":(of("converged")) with lines linetype 1 title 'converged', \
     data using "speed":(of("law")) with lines linetype 6 title 'T ∝ √V', \
     data using "speed":(of("scheme")) with points linetype 5 title 'published scheme', \
     data using "speed":(of("paper")) with points linetype 3 pointtype 8 pointsize 1.2 title 'paper'

stats data using (of("law")/sqrt(column("speed"))) nooutput
root = STATS_max
unset label
eval range(0, 88, -15, 45)
set tmargin at screen 0.315
set bmargin at screen 0.0985
set xlabel '{/:Italic V}, m/s' offset 0,0.9
set ytics 20
set label 100 '°C above {/:Italic T} ∝ √{/:Italic V}' at graph 0, graph 1.13 left offset -4,0
beyond(kind) = of(kind) - root*sqrt(column("speed"))
set label 'converged' at 22, 19 left
set label 'the paper' at 52.5, 37 left
set label 'published scheme' at 86, -8 right
plot data using "speed":(beyond("converged")) with lines linetype 1 title 'converged, beyond', \
     data using "speed":(beyond("law")) with lines linetype 6 title 'T ∝ √V, beyond', \
     data using "speed":(beyond("scheme")) with points linetype 5 title 'published scheme, beyond', \
     data using "speed":(beyond("paper")) with points linetype 3 pointtype 8 pointsize 1.2 title 'paper, beyond'
unset multiplot
