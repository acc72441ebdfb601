# The share of the converged 1 − κ and T*max that the published scheme finds with n nodes.
name = 'nodes'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(22, 800, 0, 105)
eval axes('n', '%')
set label 100 '% found'
set logscale x
set xtics (25, 50, 100, 200, 400, 800)
set ytics 20
set arrow from x_min, 100 to x_max, 100 nohead linetype 6
set label 'largest temperature,' at 25, 86
set label 'Pe = 100' at 27, 76 point linetype 2 pointtype 9 pointsize 0.8 offset 0.8,0
set label 'Pe = 4360' at 27, 67 point linetype 4 pointtype 13 pointsize 0.8 offset 0.8,0
set label '1 − {/:Italic κ}, Pe = 100' at 115, 74
set label '1 − {/:Italic κ}, Pe = 4360' at 240, 38
share(peclet, what) = column("peclet") == peclet ? 100*column(what) : NaN
curve(peclet, what, title, i, mark) = sprintf("data using 'n':(share(%g, '%s')) " \
  ."with linespoints linetype %d dashtype solid pointtype %d pointsize 0.5 title '%s, Pe = %g'", \
  peclet, what, i, mark, title, peclet)
eval "plot ".curve(100, 'temperature', 'T*', 2, 9).", ".curve(4360, 'temperature', 'T*', 4, 13) \
  .", ".curve(100, 'load', '1 − κ', 1, 7).", ".curve(4360, 'load', '1 − κ', 3, 5)
