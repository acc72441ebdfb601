# Digits that are right in all of three results against the evaluations of kernels, for the paper's wheel.
name = 'evaluations'
height = 470
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

set logscale y
set xrange [0:12]; set yrange [100:1e8]
set xtics 2
set format y '10^{%T}'
set lmargin at screen 0.125
set xlabel 'correct digits of {/:Italic κ}, {/:Italic T*} and {/:Italic ξ*}, the worst of them' offset 0,1.1
set label 100 'evaluations of kernels' at graph 0, graph 1.07 left offset -5.2,0

# Beyond eleven digits the reference itself may err.
do for [k = 0:11] { set arrow from first 11, graph k/12. to first 12, graph (k + 1)/12. nohead back \
  linecolor rgb 'grey50' linewidth 0.3 }
set label 'error of the reference' at 10.9, graph 0.97 right

# Every setting is a point; the line is through those that no other of the method beats in both.
set table $runs
plot data using (strcol('method')):(column('digits')):(column('evaluations')) with table
unset table
beats(k, word, digits, count) = word($runs[k], 1) eq word && real(word($runs[k], 2)) > digits + 1e-4 \
  && real(word($runs[k], 3)) <= 1.001*count
best(word, digits, count) = (sum [k = 1:|$runs|] beats(k, word, digits, count)) == 0 ? digits : NaN
of(word) = strcol('method') eq word ? column('digits') : NaN
settings(word, i, mark, title) = sprintf("data using (of('%s')):'evaluations' " \
  ."with points linetype %d pointtype %d pointsize 0.45 title '%s'", word, i, mark, title)
envelope(word, i, title) = sprintf("data using (best('%s', of('%s'), column('evaluations'))):" \
  ."'evaluations' with lines linetype %d dashtype solid title '%s'", word, word, i, title)
curve(word, title, i, mark) = envelope(word, i, title).', ' \
  .settings(word, i, mark, title.': settings')
set label 'published scheme' at 0.35, 1.5e7 left
set label 'cached' at 1.75, 2.6e4 left
set label 'product integration' at 5, 2e6 left
set label 'graded panels' at 10.2, 1.1e5 right
set label 'coupled' at 8.4, 1.6e3 left
set label 'first order' at 5.15, 2.1e3 right
set label 'closed form' at 2.75, 272 left
eval "plot ".curve('gauss_chebyshev', 'published scheme', 3, 5).', ' \
  .curve('thrifty', 'cached', 4, 13).', '.curve('moments', 'product integration', 2, 9).', ' \
  .curve('graded_panels', 'graded panels', 6, 1).', '.curve('coupled', 'coupled', 1, 7).', ' \
  .settings('first_order', 5, 8, 'first order').', '.settings('closed_form', 5, 4, 'closed form')
