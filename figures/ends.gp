# How far the coupled solver's largest temperature is from its limits at high and at low speed.
name = 'ends'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(1e-3, 1e8, 1e-13, 10)
eval axes('Pe', '')
set label 'relative distance' at graph 0, graph 1.07 offset -4,0
set bmargin at screen 0.155
set rmargin at screen 0.95
set logscale xy
set xtics ('0.001' 1e-3, '0.1' 0.1, '10' 10, '10^3' 1e3, '10^5' 1e5, '10^7' 1e7) offset 0,0.2
set ytics ('1' 1, '10^{−4}' 1e-4, '10^{−8}' 1e-8, '10^{−12}' 1e-12)
set label 'slow limit' at 0.02, 1.2e-5
set label 'fast limit' at 3e3, 1e-5
plot data using "peclet":"fast" with linespoints linetype 1 pointtype 6 pointsize 0.4 \
       title 'from the fast limit', \
     data using "peclet":"slow" with linespoints linetype 3 pointtype 6 pointsize 0.4 \
       title 'from the slow limit'
