# How far a moving surface rises where it is heated: finite elements, kernel, and the printed sign.
name = 'sign'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-3, 3, -0.6, 0.6)
eval axes('x / a', 'w')
set xtics 1
set ytics 0.2
set arrow from -1, 0 to 1, 0 nohead linewidth 3 linecolor rgb 'grey50'
set label 'heated' at 0, -0.07 center
set label 'corrected sign' at 1.2, 0.51
set label 'printed sign' at 1.2, -0.51
eval point_entry(0.05, 0.93, 'finite elements')
plot data using "x":"kernel" with lines linetype 1 title 'corrected', \
     data using "x":"printed" with lines linetype 3 title 'printed', \
     data using "x":"elements" \
       with points linetype 5 title 'finite elements'
