# Surface temperature T*(s) for four Péclet numbers at four tractions (the paper's Fig. 4a to d).
name = 'temperatures'; height = 620
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

quantity = 'T'
parameter = 'peclet'; symbol = 'Pe'; values = '100 500 1000 5000'
of_load(load, method, i) = column('traction') == load ? member(method, i) : NaN
set tics font ',14'
place(k) = sprintf("set tmargin at screen %g; set bmargin at screen %g; ", \
    k < 2 ? 0.93 : 0.45, k < 2 ? 0.57 : 0.09) \
  .sprintf("set lmargin at screen %g; set rmargin at screen %g; ", \
    k % 2 ? 0.605 : 0.095, k % 2 ? 0.905 : 0.395)
end(load, i, lift) = sprintf("data using (column('s') == 3 ? 3 : NaN):(of_load(%g, 'corrected', %d)):" \
  ."('%s') with labels font ',13' left offset 0.3,%g notitle", load, i, word(values, i), lift)
# Where the curves end near each other their labels stand apart.
panel(k, load, T_max, T_step, near) = place(k) \
  .sprintf("drawn = 0; eval range(-1, 3, 0, %g); set ytics %g; ", T_max, T_step) \
  .sprintf("set label 1 '{/:Italic Q*} = %g' at graph 0.97, graph 0.93 right font ',15'; ", load) \
  .sprintf("plot for [i = 1:4] data using 's':(of_load(%g, 'corrected', i)) with lines linetype i " \
    ."title label(i).', coupled' noenhanced, for [i = 1:4] data using 's':(thinned(column('s'), " \
    ."of_load(%g, 'scheme', i))) with points linetype 5 pointsize 0.4 " \
    ."title label(i).', published scheme' noenhanced, ", load, load) \
  .end(load, 1, near ? 0.3 : 0).', '.end(load, 2, near ? 0.5 : 0.3).', ' \
  .end(load, 3, near ? -0.15 : 0.05).', '.end(load, 4, near ? -0.5 : -0.2)
eval axes('s', 'T*')
set xtics 1
set multiplot
eval panel(0, 0.2, 0.004, 0.001, 1)
eval panel(1, 0.4, 0.01, 0.002, 0)
eval panel(2, 0.5, 0.016, 0.004, 0)
eval panel(3, 0.59, 0.025, 0.005, 0)
unset multiplot
