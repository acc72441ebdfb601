# Temperature T*(s, y) below the surface at Q* = 0.5 and Pe = 100, with a few isotherms.
name = 'subsurface'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

# The grid, whose scan lines gnuplot wants parted by blank lines.
set table $rows
plot data using "s":"y":"T" with table
unset table
set print $grid
depth = word($rows[1], 2)
do for [k = 1:|$rows|] {
  if (word($rows[k], 2) ne depth) { print ''; depth = word($rows[k], 2) }
  print $rows[k]
}
unset print
set datafile separator whitespace
set datafile nocolumnheaders
set datafile missing

# The isotherms, traced on the grid.
set contour base
unset surface
set cntrparam levels discrete 0.0005, 0.002, 0.004, 0.006, 0.009
set table $isotherms
splot $grid using 1:2:3 with lines
unset table
unset contour

# All but the innermost isotherm make room for their labels, which stand on them.
array at_s[5] = [2.1, 2.1, 2.1, 1.62, 1.55]
array at_y[5] = [0.284, 0.185, 0.111, 0.06, 0.022]
levels = '0.0005 0.002 0.004 0.006 0.009'
do for [k = 1:5] {
  set label word(levels, k) at at_s[k], at_y[k] center front textcolor rgb '#ffffff' font ',14'
}
clear(k, s, depth) = abs(s - at_s[k]) > 0.33 || abs(depth - at_y[k]) > 0.025
parted(s, depth) = (sum [k = 1:4] clear(k, s, depth)) == 4 ? depth : NaN

# The map is drawn in cells about the grid's points: half a cell more than the grid on each side.
stats $grid using 1:2 nooutput
cells_s = STATS_records/(STATS_blank + 1); cells_y = STATS_blank + 1
half_s = (STATS_max_x - STATS_min_x)/(cells_s - 1)/2
half_y = (STATS_max_y - STATS_min_y)/(cells_y - 1)/2
set xrange [STATS_min_x - half_s:STATS_max_x + half_s]
set yrange [STATS_max_y + half_y:STATS_min_y - half_y]
eval axes('s', 'y')
set xtics 1
set ytics 0.1
set rmargin at screen 0.82
set colorbox user origin screen 0.845, screen 0.14 size screen 0.03, screen 0.765
set cbrange [0:0.015]
set cbtics 0.005 offset -0.6,0
set label '{/:Italic T*}' at screen 0.86, graph 1.075 center

# The zones of the contact, along the surface.
c = 2*sqrt(1 - 0.5/0.6) - 1
set arrow from -1, graph 1.012 to c, graph 1.012 nohead linecolor rgb blue linewidth 2.5
set arrow from c, graph 1.012 to 1, graph 1.012 nohead linecolor rgb vermilion linewidth 2.5
set label 'stick' at (c - 1)/2, graph 1.075 center
set label 'slip' at (c + 1)/2, graph 1.075 center

# Viridis, its steps closer where the body is cool.
set palette defined (0 '#440154', 0.04 '#482878', 0.11 '#3e4989', 0.2 '#31688e', 0.3 '#26828e', \
  0.41 '#1f9e89', 0.54 '#35b779', 0.68 '#6ece58', 0.83 '#b5de2b', 1 '#fde725')
plot $grid using 1:2:3 with image title 'T*', \
     $isotherms using 1:(parted($1, $2)) with lines linecolor rgb '#ffffff' linewidth 0.5 title 'isotherms'
