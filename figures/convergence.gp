# Digits that are right in all of three results against the number of unknowns.
name = 'convergence'
height = 365
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

set logscale x
set xrange [4:1000]; set yrange [0:12]
set xtics (5, 10, 20, 50, 100, '' 200, 500)
set ytics 2
set bmargin at screen 0.18
set tmargin at screen 0.85
set xlabel 'unknowns {/:Italic n}' offset 0,0.9
set key off
of(regime, word) = strcol('regime') eq regime && strcol('method') eq word ? column('digits') : NaN
curve(regime, word, title, i, mark) = sprintf("data using 'unknowns':(of('%s', '%s')) " \
  ."with linespoints linetype %d dashtype solid pointtype %d pointsize 0.5 title '%s'", \
  regime, word, i, mark, title)
# Where the published scheme does not settle, with 100 nodes in b, its line is broken.
beyond(low, high) = low < column('unknowns') && column('unknowns') < high
broken(low, high) = sprintf("data using 'unknowns':(beyond(%g, %g) ? of('hot', 'thrifty') : NaN) " \
  ."with linespoints linetype 3 dashtype solid pointtype 5 pointsize 0.5 title 'published scheme'", \
  low, high)
scheme(regime) = regime eq 'hot' ? broken(0, 100).', '.broken(100, 1000) \
  : curve(regime, 'thrifty', 'published scheme', 3, 5)
panel(left, right, regime, title) = sprintf("set label 1 '%s' at graph 0, graph 1.07; ", title) \
  .sprintf("set lmargin at screen %g; set rmargin at screen %g; plot ", left, right) \
  .scheme(regime).', ' \
  .curve(regime, 'moments', 'product integration', 2, 9).', ' \
  .curve(regime, 'graded_panels', 'graded panels', 6, 1).', ' \
  .curve(regime, 'coupled', 'coupled', 1, 7)
set label 100 'correct digits' at screen 0.02, screen 0.965 left
set multiplot
set label 2 'coupled' at 28, 9.8 right
set label 3 'product integration' at 700, 2.9 right
set label 5 'graded panels' at 700, 7.2 right
set label 4 'published scheme' at 700, 0.6 right
eval panel(0.075, 0.515, 'steel', 'a. Pe = 4360, {/:Italic H} = 0.0175')
unset label 2; unset label 3; unset label 4; unset label 5; unset label 100
eval panel(0.56, 0.985, 'hot', 'b. Pe = 100, {/:Italic H} = 1')
unset multiplot
