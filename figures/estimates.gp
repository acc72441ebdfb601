# Errors of random scenes: asked and made, and how much larger the stated ones are than the true.
name = 'estimates'
height = 330
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

set tmargin at screen 0.85
set bmargin at screen 0.18
set logscale xy
of(word, part) = strcol('part') eq part && strcol('curve') eq word ? column('y') : NaN
spoken(key) = key eq 'max_temperature' ? 'temperature' : key eq 'load_ratio' ? 'load ratio' : key
curve(part, word, i) = sprintf("data using 'x':(of('%s', '%s')) with lines linetype %d " \
  ."title '%s' noenhanced", word, part, i, spoken(word))
set multiplot
set lmargin at screen 0.115; set rmargin at screen 0.475
set xrange [1e-9:1e-2]; set yrange [1e-15:1e-2]
set xtics ('10^{−9}' 1e-9, '10^{−6}' 1e-6, '10^{−3}' 1e-3)
set ytics ('10^{−14}' 1e-14, '10^{−10}' 1e-10, '10^{−6}' 1e-6, '10^{−2}' 1e-2)
set xlabel 'tolerance' offset 0,0.9
set label 1 'a. true error' at graph 0, graph 1.07
set arrow from 1e-9, 1e-9 to 1e-2, 1e-2 nohead linetype 6
set label 'all' at 2e-7, 5e-5 right; eval leader(2.3e-7, 3e-5, 5.6e-6, 3.5e-6)
set label '99 of 100' at 9e-3, 5e-8 right; eval leader(4e-5, 2e-7, 1.8e-5, 8e-7)
set label 'median' at 9e-3, 1e-11 right
eval 'plot '.curve('achieved', 'median', 1).', '.curve('achieved', '99 of 100', 2).', ' \
  .curve('achieved', 'all', 3)
unset label; unset arrow
set lmargin at screen 0.6; set rmargin at screen 0.975
unset logscale y
set xrange [0.1:1e7]; set yrange [0:20]
set xtics ('1' 1, '10^{2}' 100, '10^{4}' 1e4, '10^{6}' 1e6)
set ytics ('0' 0, '10 %%' 10, '20 %%' 20)
set xlabel 'stated by true error'
set label 1 'b. share of scenes' at graph 0, graph 1.07
set arrow from 1, 0 to 1, 20 nohead linetype 6
eval line_entry(0.66, 0.93, 'linetype 1', '{/:Italic T*}')
eval line_entry(0.66, 0.83, 'linetype 2', '{/:Italic ξ*}')
eval line_entry(0.66, 0.73, 'linetype 3', '{/:Italic κ}')
eval 'plot '.curve('ratio', 'max_temperature', 1).', '.curve('ratio', 'creep', 2).', ' \
  .curve('ratio', 'load_ratio', 3)
unset multiplot
