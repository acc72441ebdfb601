# The largest temperature in degrees over the speed of the wheel, Q* = 0.5.
name = 'celsius'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 88, 0, 600)
eval axes('V', 'T')
set xlabel '{/:Italic V}, m/s'
set label 100 '°C'
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
