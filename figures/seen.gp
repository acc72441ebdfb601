# The share of the thermal effect that n nodes see, over Péclet numbers and nodes, with its levels
# and those of the law. On the map, near-black is #111111: black is for the page to choose.
name = 'seen'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

# The grid, whose scan lines gnuplot wants parted by blank lines.
set table $rows
plot data using (log10(column("peclet"))):(log10(column("nodes"))):"seen":"law" with table
unset table
set print $grid
line = word($rows[1], 1)
do for [k = 1:|$rows|] {
  if (word($rows[k], 1) ne line) { print ''; line = word($rows[k], 1) }
  print $rows[k]
}
unset print
set datafile separator whitespace
set datafile nocolumnheaders

set contour base
unset surface
set cntrparam levels discrete 0.1, 0.5, 0.9, 0.99, 0.999
set table $seen
splot $grid using 1:2:3 with lines
set table $law
splot $grid using 1:2:4 with lines
unset table
unset contour

eval range(1 - 1/16.0, 5 + 1/16.0, 0.95, 3.35)  # half a cell more than the grid
eval axes('Pe', 'n')
set bmargin at screen 0.155
set xtics ('10' 1, '100' 2, '10^3' 3, '10^4' 4, '10^5' 5) offset 0,0.2
set ytics ('10' 1, '100' 2, '1000' 3)
set rmargin at screen 0.82
set colorbox user origin screen 0.845, screen 0.155 size screen 0.03, screen 0.75
set cbrange [0:1]
set cbtics ('0' 0, '50 %%' 0.5, '100 %%' 1) offset -0.6,0
set label 'share seen' at screen 0.99, graph 1.075 right

set label '99.9 %' at 1.58, 2.95 right front textcolor rgb '#111111' font ',14'
set label '99 %' at 1.78, 2.55 right front textcolor rgb '#111111' font ',14'
set label '90 %' at 2.34, 2.55 right front textcolor rgb '#111111' font ',14'
set label '50 %' at 2.92, 2.55 right front textcolor rgb '#ffffff' font ',14'
set label '10 %' at 4.16, 2.55 right front textcolor rgb '#ffffff' font ',14'

# What the paper computed.
$paper << end
100 50
5000 50
5000 200
100 200
100 50
end
set label 'the paper' at 2.85, 2.0 center front textcolor rgb '#ffffff' font ',14'

set palette defined (0 '#440154', 0.13 '#482878', 0.25 '#3e4989', 0.38 '#31688e', 0.5 '#26828e', \
  0.63 '#1f9e89', 0.75 '#35b779', 0.85 '#6ece58', 0.95 '#b5de2b', 1 '#fde725')
plot $grid using 1:2:3 with image title 'share seen', \
     $seen using 1:2 with lines linecolor rgb '#ffffff' linewidth 1 title 'levels', \
     $law using 1:2 with lines linecolor rgb '#111111' linewidth 0.75 dashtype (5,7) title 'law', \
     $paper using (log10($1)):(log10($2)) with lines linecolor rgb '#ffffff' linewidth 1 dashtype solid title 'range of the paper'
