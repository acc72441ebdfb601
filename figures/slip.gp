# Slip velocity v*(s) for four tractions Q* (the paper's Fig. 3).
name = 'slip'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-1, 1, 0, 0.8)
eval axes('s', 'v*')
eval key(0.05, 0.95)
eval set_margin_labels
set xtics 0.5
set ytics 0.2
tractions = '0.2 0.4 0.5 0.59'
number(i) = word(tractions, i) + 0
do for [i = 1:4] {
  stats data using (column("s") == x_max ? row("method", "converged", "traction", number(i), column("v")) : NaN) nooutput
  eval margin_label(i, (i < 4 ? '' : '{/:Italic Q*} = ').word(tractions, i), STATS_max)
}
plot for [i = 1:4] data \
       using "s":(row("method", "converged", "traction", number(i), column("v"))) \
       with lines linetype i title 'Q* = '.word(tractions, i).', converged' noenhanced, \
     for [i = 1:4] data \
       using "s":(thinned(column("s"), row("method", "printed", "traction", number(i), column("v")))) \
       with points linetype 5 title 'Q* = '.word(tractions, i).', published scheme' noenhanced
