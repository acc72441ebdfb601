# Up to which heating the closed form (dashed) and its linear correction (full) meet a tolerance.
name = 'rungs'
height = 460
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(1e-2, 1e6, 1e-7, 100)
eval axes('Pe', 'H')
set rmargin at screen 0.89
set logscale xy
set xtics ('0.01' 1e-2, '1' 1, '100' 100, '10^4' 1e4, '10^6' 1e6) offset 0,0.2
set ytics ('100' 100, '1' 1, '10^{−2}' 1e-2, '10^{−4}' 1e-4, '10^{−6}' 1e-6)
set label 'paper' at 4360, 0.0175 point pointtype 2 pointsize 0.8 offset 0.6,-0.7
# No contact has more than H = 0.1, where a/R is 0.1.
set object rectangle from 1e-2, 0.1 to 1e6, 100 behind fillcolor rgb 'grey50' fillstyle transparent solid 0.14 noborder
set label 'no contact: {/:Italic a}/{/:Italic R} > 0.1' at 5e5, 20 right
# Each line has its tolerance at its end, apart where two end close to each other.
end(k, level) = sprintf("set label '10^{−%d}' at 1.7e6, %g left", k, level)
eval end(2, 0.65)
eval end(3, 0.12)
eval end(2, 0.0185)
eval end(3, 3.6e-3)
eval end(6, 6e-4)
eval end(6, 2e-6)
tolerance(k, i) = sprintf("data using 'peclet':'first_%d' with lines linetype %d dashtype solid title '10−%d', " \
  ."data using 'peclet':'closed_%d' with lines linetype %d dashtype (8,4) title '10−%d, closed form'", k, i, k, k, i, k)
eval "plot ".tolerance(2, 1).", ".tolerance(3, 2).", ".tolerance(6, 3)
