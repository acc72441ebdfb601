# Creep curve: traction Q* against creep ξ*, with full sliding as its ceiling.
name = 'creep'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 0.45, 0, 0.7)
eval axes('ξ*', 'Q*')
eval line_entry(0.42, 0.30, 'linewidth 1.25', 'closed form, {/:Italic H} = 0')
eval point_entry(0.42, 0.225, 'published scheme, {/:Italic n} = 200')
set xtics 0.1
set ytics 0.1
friction = 0.6
set arrow from 0, friction to x_max, friction nohead linetype 6
set label 'full sliding, {/:Italic Q*} = {/:Italic f}' at x_min + 0.02, friction + 0.03
plot data using "creep":(strcol("method") eq "converged" ? column("traction") : NaN) \
       with lines linetype 1 title 'converged', \
     data using "creep":(strcol("method") eq "printed" ? column("traction") : NaN) \
       with points linetype 5 title 'published scheme'
