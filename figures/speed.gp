# Digits that are right in all of three results against the time of a solve, for the paper's wheel.
name = 'speed'
height = 470
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval read_times
digits_of(word, number) = sprintf("stats data using (strcol('method') eq '%s' && " \
  ."column('setting') == %g ? column('digits') : NaN) nooutput", word, number)
at_wheel = '/Pe:4360/H:0.0175'
slow = seconds('gauss_chebyshev_thrifty/n:200'.at_wheel); fast = seconds('coupled/tol:1e-06'.at_wheel)
eval digits_of('thrifty', 200); from = STATS_min
eval digits_of('coupled', 1e-6); to = STATS_min

# What is proven of the tables of kernels.
stats ARG0[:strlen(ARG0) - strlen(name.'.gp')].'measured/certified-tables.csv' \
  using (column('largest error') + column('radius')) nooutput
proven = -log10(STATS_max)

set logscale y
set xrange [0:14]; set yrange [2e-6:3]
set xtics 2
set ytics ('10 µs' 1e-5, '0.1 ms' 1e-4, '1 ms' 1e-3, '10 ms' 1e-2, '0.1 s' 0.1, '1 s' 1)
set lmargin at screen 0.125
set xlabel 'correct digits of {/:Italic κ}, {/:Italic T*} and {/:Italic ξ*}, the worst of them' offset 0,1.1
set label 100 'time of a solve' at graph 0, graph 1.07 left offset -5.2,0

# Beyond eleven digits the reference itself may err, and no method with the tables is better than they are.
do for [k = 0:11] { set arrow from first 11, graph k/12. to first proven, graph (k + 1)/12. nohead back \
  linecolor rgb 'grey50' linewidth 0.3 }
set arrow from first proven, graph 0 to first proven, graph 1 nohead back linecolor rgb 'black' linewidth 0.5
set label 'proven error of the kernels' at proven + 0.35, graph 0.5 center rotate by 90
set label 'error of the reference' at 10.9, graph 0.97 right

# From the scheme with 200 nodes, cached, to the coupled solver.
unit = 10**(floor(log10(slow/fast)) - 1)
set arrow from from + 0.12, slow/1.25 to to - 0.12, fast*1.25 head filled size screen 0.015,20 \
  linecolor rgb 'black' linewidth 0.5
set label sprintf('%g times faster', unit*floor(slow/fast/unit + 0.5)) \
  at from + 0.5, 1.35*slow left

# Every setting is a point; the line is through those that no other of the method beats in both.
set table $runs
plot data using (strcol('method')):(column('digits')):(seconds(strcol('name'))) with table
unset table
beats(k, word, digits, time) = word($runs[k], 1) eq word && real(word($runs[k], 2)) > digits + 1e-4 \
  && real(word($runs[k], 3)) <= 1.001*time
best(word, digits, time) = (sum [k = 1:|$runs|] beats(k, word, digits, time)) == 0 ? digits : NaN
of(word) = strcol('method') eq word ? column('digits') : NaN
settings(word, i, mark, title) = sprintf("data using (of('%s')):(seconds(strcol('name'))) " \
  ."with points linetype %d pointtype %d pointsize 0.45 title '%s'", word, i, mark, title)
envelope(word, i, title) = sprintf("data using (best('%s', of('%s'), seconds(strcol('name')))):" \
  ."(seconds(strcol('name'))) with lines linetype %d dashtype solid title '%s'", word, word, i, title)
curve(word, title, i, mark) = envelope(word, i, title).', ' \
  .settings(word, i, mark, title.': settings')
set label 'published scheme' at 2.05, 1.1 left
set label 'cached' at 2.05, 0.11 left
set label 'product integration' at 5, 0.1 left
set label 'graded panels' at 10.3, 2.2*seconds('graded_panels/n:100'.at_wheel) right
set label 'coupled' at 8.3, 6.5e-5 left
set label 'linear correction' at 5.2, seconds('first_order'.at_wheel) right
set label 'closed form' at 2.95, seconds('closed_form'.at_wheel) left
eval "plot ".curve('gauss_chebyshev', 'published scheme', 3, 5).', ' \
  .curve('thrifty', 'cached', 4, 13).', '.curve('moments', 'product integration', 2, 9).', ' \
  .curve('graded_panels', 'graded panels', 6, 1).', '.curve('coupled', 'coupled', 1, 7).', ' \
  .settings('first_order', 5, 8, 'linear correction').', '.settings('closed_form', 5, 4, 'closed form')
