# The one style of all figures. A script sets `name` and loads this file first. `data` and `output`
# then stand, unless the command line gave them:
#   gnuplot figures/traction.gp
#   gnuplot -e "data='my.csv'; output='my.svg'" figures/traction.gp

if (!exists("data")) data = 'build/data/'.name.'.csv'
if (!exists("height")) height = 380
if (!exists("output")) { output = 'build/figures/'.name.'.svg'; system 'mkdir -p build/figures' }

# The name heads the SVG's title and ids, in which gnuplot allows no hyphen.
id = ''
do for [k = 1:strlen(name)] { id = id.(name[k:k] eq '-' ? '_' : name[k:k]) }
set terminal svg size 560,height enhanced font 'sans-serif,17' linewidth 2 rounded name id
set output output
set encoding utf8
set minussign
set datafile separator comma
set datafile columnheaders
set datafile missing NaN

# Text, axes and points are black, which the report turns into the colour of its text, light or
# dark. The curves take the four Okabe-Ito colours that stand out on white and on near-black
# alike, each with its own dash, so that they differ in grey as well.
blue = 0x0072B2; green = 0x009E73; vermilion = 0xD55E00; purple = 0xCC79A7
set linetype 1 linecolor rgb blue      linewidth 1.25 dashtype solid
set linetype 2 linecolor rgb green     linewidth 1.25 dashtype (12,4)
set linetype 3 linecolor rgb vermilion linewidth 1.25 dashtype (12,4,1,4)
set linetype 4 linecolor rgb purple    linewidth 1.25 dashtype (4,3)
set linetype 5 linecolor rgb 'black' linewidth 0.5 pointtype 6 pointsize 0.55
set linetype 6 linecolor rgb 'grey50' linewidth 0.9 dashtype (2,4)

set border 3 linecolor rgb 'black' linewidth 0.4
set tics nomirror out scale 0.5
set xtics offset 0,0.4
set ytics offset 0.6,0
set lmargin at screen 0.125
set rmargin at screen 0.97
set tmargin at screen 1 - 36.1/height
set bmargin at screen 53.2/height
unset key

# The symbols of the axes: the abscissa below the middle, the ordinate above its axis.
# They are italic but for Pe, which is upright as in the text.
lift = height < 380 ? 1.105 : 1.075
one(word) = word eq 'Pe' ? word : '{/:Italic '.word.'}'
symbols(x) = strstrt(x, 'Pe') == 0 || words(x) < 2 \
  ? one(x) : one(word(x, 1)).' '.symbols(x[strlen(word(x, 1)) + 2:])
axes(x, y) = sprintf("set xlabel '%s' offset 0,0.9; " \
  ."set label 100 '%s' at graph 0, graph %g right offset 0.8,0", symbols(x), symbols(y), lift)

# A plot's range, kept for thinning the points.
range(x0, x1, y0, y1) = sprintf("x_min = %g; x_max = %g; y_min = %g; y_max = %g; " \
  ."set xrange [x_min:x_max]; set yrange [y_min:y_max]", x0, x1, y0, y1)

# The rows of one curve: `value` where the text column `kind` says `word` and the number column
# `parameter` says `number`; elsewhere nothing.
row(kind, word, parameter, number, value) = \
  strcol(kind) eq word && column(parameter) == number ? value : NaN

# The published scheme has more nodes than the eye can part: a point is drawn only when it is at
# least 3.5 % of the plot away from every point drawn before, so that common arcs are not crowded.
array drawn_x[1000]; array drawn_y[1000]; drawn = 0
near(x, y, k) = \
  ((x - drawn_x[k])/(x_max - x_min))**2 + ((y - drawn_y[k])/(y_max - y_min))**2 < 0.035**2
apart(x, y) = drawn == 0 || (sum [k = 1:drawn] near(x, y, k)) == 0
thinned(x, y) = y == y && apart(x, y) \
  ? (drawn = drawn + 1, drawn_x[drawn] = x, drawn_y[drawn] = y) : NaN

# A thin grey line from a label, which starts or ends at (x, y), to a point of its curve.
leader(x, y, x_curve, y_curve) = sprintf("set arrow from %g, %g to %g, %g nohead back " \
  ."linecolor rgb 'grey50' linewidth 0.4", x, y, x_curve, y_curve)

# The key says only what a line and what a point is; the curves carry their own labels. (x, y) is its
# upper left corner in the plot's own unit square; `entry` is one row of it.
entry(x, y, text) = sprintf("set label '%s' at graph %g, graph %g; ", text, x + 0.08, y)
line_entry(x, y, style, text) = entry(x, y, text) \
  .sprintf("set arrow from graph %g, graph %g rto graph 0.06, 0 nohead %s; ", x, y, style)
point_entry(x, y, text) = entry(x, y, text) \
  .sprintf("set label '' at graph %g, graph %g point linetype 5; ", x + 0.03, y)
key(x, y) = line_entry(x, y, 'linewidth 1.25', 'coupled') \
  .point_entry(x, y - 0.075, 'published scheme, {/:Italic n} = 200')
heat_key(x, y) = line_entry(x, y, 'linewidth 1.25', 'coupled') \
  .line_entry(x, y - 0.07, "linecolor rgb 'grey50' linewidth 0.5", 'without heat, {/:Italic H} = 0') \
  .point_entry(x, y - 0.14, 'published scheme')

# A family of curves: `quantity` (a column of the data) over s, one curve for each of four `values`
# of a `parameter` (a column, too, written `symbol` in the picture). A script sets these and says
# `eval label_family`, if it wants the labels in the right margin, and `eval draw_family`.
number(i) = word(values, i) + 0
member(method, i) = row("method", method, parameter, number(i), column(quantity))
label(i) = symbol.' = '.word(values, i)
lines(method, word) = 'for [i = 1:4] data using "s":(member("'.method.'", i)) with lines '.word.', '
draw_family = 'plot '.lines('corrected', 'linetype i title label(i).", coupled" noenhanced') \
  .'for [i = 1:4] data using "s":(thinned(column("s"), member("scheme", i))) ' \
  .'with points linetype 5 title label(i).", published scheme" noenhanced'

# Above, such a family with thin lines for what it is without heat; below, what heat changes at one
# load, with the sign as corrected, as printed, and by the published scheme, which has the latter.
upper_panel = "set tmargin at screen 0.935; set bmargin at screen 0.43"
lower_panel = "unset label; unset arrow; set tmargin at screen 0.325; set bmargin at screen 0.09; " \
  ."drawn = 0"
draw_hot_family = "set lmargin at screen 0.125; plot " \
  .lines('cold', 'linecolor rgb "grey50" linewidth 0.5 title label(i).", without heat" noenhanced') \
  .draw_family[6:]
change_axes(what) = "set xlabel '{/:Italic s}' offset 0,0.9; " \
  .sprintf("set label 100 '{/:Italic Δ%s}, change by heat at {/:Italic Q*} = 0.5' ", what) \
  ."at graph 0, graph 1.13 left offset 0.5,0"
change(method) = row("method", method, parameter, 0.5, column("change"))
change_key(x, y) = line_entry(x, y, 'linetype 3 dashtype solid', 'corrected sign') \
  .line_entry(x, y - 0.135, 'linetype 3', 'sign as printed') \
  .point_entry(x, y - 0.27, 'published scheme')
draw_changes = 'plot data using "s":(change("corrected")) with lines linetype 3 dashtype solid ' \
  .'title "corrected", data using "s":(change("printed")) with lines linetype 3 title "printed", ' \
  .'data using "s":(thinned(column("s"), change("scheme"))) with points linetype 5 title "scheme"'

# Each label stands on a short grey leader from its curve's end, lifted where it would touch the one
# below; `order` has the indices of the values from the lowest curve up, the last one the symbol.
labelled = "corrected"; level = -1e9
lifted(height) = level = height > level + gap ? height : level + gap
margin_label(text, height) = sprintf("set arrow from x_max, %.6g to graph 1.035, first %.6g " \
  ."nohead linecolor rgb 'grey50' linewidth 0.4; set label '%s' at graph 1.045, first %.6g", \
  height, lifted(height), text, level)
label_family = 'set rmargin at screen 0.80; gap = 0.062*(y_max - y_min); do for [k = 1:4] { ' \
  .'i = int(word(order, k)); ' \
  .'stats data using (column("s") == x_max ? member(labelled, i) : NaN) nooutput; ' \
  .'eval margin_label(k < 4 ? word(values, i) : "{/:Italic ".symbol."} = ".word(values, i), ' \
  .'STATS_max) }'

# The times of runs by name are those of times.csv, beside the data.
read_times = "set table $times; plot system(sprintf(\"dirname '%s'\", data)).'/times.csv' " \
  ."using (stringcolumn(1).' '.stringcolumn(2)) with table; unset table; " \
  ."seconds(name) = sum [k = 1:|$times|] " \
  ."(word($times[k], 1) eq name ? real(word($times[k], 2)) : 0)"

# The time of every run in a regime against its error: three panels side by side, one quantity each,
# in each a curve of every method and a point for what has no settings.
of(name, what) = strcol('method') eq name && strcol('quantity') eq what ? column("error") : NaN
curve(name, title, i, mark) = sprintf("data using (of('%s', what)):(seconds(strcol('name'))) " \
  ."with linespoints linetype %d dashtype solid pointtype %d pointsize 0.4 " \
  ."title what.': %s'", name, i, mark, title)
dot(name, title, mark) = sprintf("data using (of('%s', what)):(seconds(strcol('name'))) " \
  ."with points linetype 5 pointtype %d title what.': %s'", name, mark, title)
panel(k, of_what, title) = sprintf("what = '%s'; set label 1 '%s' at graph 0.5, graph 1.08 center; ", \
  of_what, title) \
  .sprintf("set lmargin at screen %g; set rmargin at screen %g; ", 0.11 + k*0.305, 0.365 + k*0.305) \
  .(k == 0 ? '' : "set format y ''; ") \
  .(k == 1 ? "set xlabel 'relative error' offset 0,0.9; " : "unset xlabel; ")."plot " \
  .curve('gauss_chebyshev', 'published scheme', 3, 5).', ' \
  .curve('thrifty', 'cached', 4, 13).', '.curve('moments', 'product integration', 2, 9).', ' \
  .curve('graded_panels', 'graded panels', 6, 1).', '.curve('coupled', 'coupled', 1, 7).', ' \
  .dot('first_order', 'first order', 8).', ' \
  .dot('closed_form', 'closed form', 4)
speed_figure = "set logscale xy; set xrange [2:5e-12]; set yrange [4e-8:4]; " \
  ."set xtics ('1' 1, '10^{−5}' 1e-5, '10^{−10}' 1e-10); " \
  ."set ytics ('1 µs' 1e-6, '1 ms' 1e-3, '1 s' 1); eval read_times; set multiplot; " \
  ."eval panel(0, 'load', '{/:Italic κ} − 1'); set ytics ('' 1e-6, '' 1e-3, '' 1); " \
  ."eval panel(1, 'temperature', '{/:Italic T*}, largest'); " \
  ."eval panel(2, 'creep', '{/:Italic ξ*}'); unset multiplot"
