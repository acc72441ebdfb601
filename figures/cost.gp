# Time of the coupled solver over the Péclet number, for three tolerances, with little heat and much.
name = 'cost'
height = 640
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval read_times
set logscale xy
set xrange [0.1:1e6]; set yrange [3e-5:0.4]
set xtics ('0.1' 0.1, '1' 1, '10' 10, '100' 100, '10^3' 1e3, '10^4' 1e4, '10^5' 1e5, '10^6' 1e6)
set ytics ('0.1 ms' 1e-4, '1 ms' 1e-3, '10 ms' 1e-2, '0.1 s' 0.1)
set lmargin at screen 0.13
set rmargin at screen 0.88
chosen(tolerance, heating) = column('tolerance') == tolerance && column('heating') == heating \
  ? column('peclet') : NaN
line(digits, heating, i) = sprintf("data using (chosen(1e-%d, %g)):(seconds(strcol('name'))) " \
  ."with linespoints linetype %d pointtype 7 pointsize 0.4 title '10^{−%d}, H = %g'", \
  digits, heating, i, digits, heating)
end(digits, heating, lift) = sprintf("data using (chosen(1e-%d, %g) == 1e6 ? 1e6 : NaN):" \
  ."(seconds(strcol('name'))):('10^{−%d}') with labels left offset 0.6,%g notitle", \
  digits, heating, digits, lift)
panel(k, heating, title, apart) = sprintf("set label 1 '%s' at graph 0, graph 1.08; ", title) \
  .sprintf("set tmargin at screen %g; set bmargin at screen %g; plot ", 0.94 - k*0.46, 0.58 - k*0.46) \
  .end(4, heating, -0.4*apart).', '.end(6, heating, 0.2*apart).', '.end(8, heating, 0).', ' \
  .line(4, heating, 1).', '.line(6, heating, 2).', '.line(8, heating, 3)
set multiplot
eval panel(0, 0.0175, 'a. {/:Italic H} = 0.0175', 1)  # two curves nearly meet at their end
set xlabel 'Pe' offset 0,0.6
eval panel(1, 1, 'b. {/:Italic H} = 1', 0)
unset multiplot
