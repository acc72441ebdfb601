# Which iteration is the first to find the solution, over Péclet numbers and heatings, with the lines
# on which the linearised steps stop contracting, and where the published scheme ends at an
# inadmissible iterate. figures/iteration-b.gp shares all of it.
if (!exists("name")) name = 'iteration-a'
load ARG0[:strlen(ARG0) - strlen('iteration-a.gp')].'style.gp'

# The grid in decades, whose scan lines gnuplot wants parted by blank lines.
set table $rows
plot data using (log10(column("peclet"))):(log10(column("strength"))):"method":"picard":"half":"scheme" \
  with table
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

# Where the linearised steps neither grow nor shrink; 0 stands for what was not computed.
set contour base
unset surface
set cntrparam levels discrete 0
known(x) = x > 0 ? log10(x) : NaN
set table $picard
splot $grid using 1:2:(known($4)) with lines
set table $half
splot $grid using 1:2:(known($5)) with lines
unset table
unset contour

eval range(-1.1, 5.1, -0.1, 6.1)  # half a cell more than the grid
eval axes('Pe', 'f Pe H')
set bmargin at screen 0.155
set xtics ('0.1' -1, '1' 0, '10' 1, '100' 2, '10^3' 3, '10^4' 4, '10^5' 5) offset 0,0.2
set ytics ('1' 0, '10' 1, '100' 2, '10^3' 3, '10^4' 4, '10^5' 5, '10^6' 6)

# Each method has a colour, and its name beside a patch of it in the corner that was not tried. None is
# a colour of the curves, which a dark page would lighten: the lines and the label on them are white.
colours = "#00659C #56B4E9 #00916A #F0E442 #E69F00 #999999"
names = "Picard 'Picard, half steps' Anderson Newton continuation 'not reached'"
set palette maxcolors 6 defined (1 '#00659C', 2 '#56B4E9', 3 '#00916A', 4 '#F0E442', 5 '#E69F00', \
  6 '#999999')
set cbrange [0.5:6.5]
unset colorbox
do for [k = 1:6] {
  height = 0.13 + 0.07*(6 - k) + 0.45
  set arrow from graph 0.02, graph height rto graph 0.035, 0 nohead linewidth 4 \
    linecolor rgb word(colours, k)
  set label word(names, k) at graph 0.075, graph height font ',15'
}
# A scene where the scheme's last iterate is inadmissible is hatched by a diagonal.
none(x) = column(6) >= 3 ? x - 0.1 : NaN
do for [k = 0:2] {
  set arrow from graph 0.018 + 0.013*k, graph 0.523 rto graph 0.013, -0.026 nohead linewidth 0.5
}
set label 'inadmissible' at graph 0.075, graph 0.51 font ',15'
# No contact lies above a/R = 0.1, which is f Pe H = 0.06 Pe.
edge = log10(0.06)
set arrow from -0.1 - edge, -0.1 to 5.1, 5.1 + edge nohead front linecolor rgb '#ffffff' linewidth 0.5
set label 'contacts: {/:Italic a}/{/:Italic R} ≤ 0.1' at 5, 1.6 right front textcolor rgb '#ffffff' font ',15'
set label 'ρ = 1' at 2.6, 2.15 front textcolor rgb '#ffffff' font ',15'
plot $grid using ($3 > 0 ? $1 : NaN):2:(0.1):(0.1):3 with boxxyerrorbars linecolor palette \
       fillstyle solid noborder title 'method', \
     $grid using (none($1)):($2 + 0.1):(0.2):(-0.2) with vectors nohead linecolor rgb '#1a1a1a' \
       linewidth 0.5 title 'the scheme ends inadmissible', \
     $picard using 1:2 with lines linecolor rgb '#ffffff' linewidth 1.25 dashtype solid \
       title 'Picard contracts', \
     $half using 1:2 with lines linecolor rgb '#ffffff' linewidth 1.25 dashtype (4,4) \
       title 'half steps contract'
