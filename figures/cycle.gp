# The border at every inner step of the published scheme with 89, 90 and 91 nodes.
name = 'cycle'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 125, -0.2252, -0.2215)
eval axes('', 'c_0')
set xlabel 'inner step' offset 0,0.9
set bmargin at screen 0.155
set xtics 20
set ytics 0.001
set format y '%.3f'
set lmargin at screen 0.15
node = -0.22252
of(n) = column("nodes") == n ? column("c0") : NaN
set arrow from x_min, node to x_max, node nohead linetype 6
set label 'a node of {/:Italic n} = 90' at 12, node + 0.00046
set arrow from 22, node + 0.0003 to 22, node + 0.00003 nohead linewidth 0.5 linecolor rgb 'black'
set label '{/:Italic n} = 90: no end' at 70, -0.2239
set label '{/:Italic n} = 89 and 91: settled' at 26, -0.22425
plot data using "step":(of(90)) with lines linetype 1 title 'n = 90', \
     data using "step":(of(90)) with points linetype 5 title 'steps', \
     data using "step":(of(89)) with lines linetype 2 title 'n = 89', \
     data using "step":(of(91)) with lines linetype 3 title 'n = 91'
