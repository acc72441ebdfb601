# The tractive force of a locomotive's wheel and its hottest point over the creep, at the speeds in the data.
name = 'recipe-curves'
height = 560
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

# The speeds as they come in the data, each once.
speeds = ''
take(speed) = strstrt(speeds.' ', ' '.speed.' ') > 0 ? 0 : (speeds = speeds.' '.speed, 1)
stats data using (take(strcol("speed"))) nooutput
n = words(speeds)
of(k, value) = strcol("speed") eq word(speeds, k) ? value : NaN
set rmargin at screen 0.86
set multiplot

# The end of a curve is its last value. Labels stand at the ends, from the lowest up, as far apart as letters need.
array end[n]; array put[n]
keep(k, value) = value == value ? end[k] = value : 0
lowest(k, j) = j > n ? k : lowest(put[j] == 0 && (k == 0 || end[j] < end[k]) ? j : k, j + 1)
label_ends = 'do for [k = 1:n] { put[k] = 0; stats data using (keep(k, of(k, column(quantity)))) nooutput }; ' \
  .'gap = 0.1*y_max; level = -gap; do for [i = 1:n] { k = lowest(0, 1); put[k] = 1; ' \
  .'eval margin_label(word(speeds, k)." m/s", end[k]) }'

# An axis from 0 to the least multiple of a step that is beyond all values, with every second step told.
power(value) = 10**floor(log10(value))
step(value) = power(value)*(value > 5*power(value) ? 1 : value > 2*power(value) ? 0.5 : 0.2)
most(what) = sprintf("set xrange [*:*]; set yrange [*:*]; stats data using '%s' nooutput; most = STATS_max", what)
axis = 'eval most(quantity); eval range(0, x_end, 0, step(most)*ceil(most/step(most))); set ytics 2*step(most)'
eval most('creep_percent')
x_end = most
set xtics 2*step(x_end)

quantity = 'force_kn'
eval upper_panel
set tmargin at screen 0.93; set bmargin at screen 0.56
eval axis
set label 1 'tractive force in kN' at graph 0, graph 1.09 left offset -4,0
eval label_ends
plot for [k = 1:n] data using "creep_percent":(of(k, column(quantity))) with lines linetype k title word(speeds, k).' m/s, force'

quantity = 'celsius'
eval lower_panel
set tmargin at screen 0.43; set bmargin at screen 0.095
eval axis
set xlabel 'creep in % of the speed' offset 0,1.1
set label 1 'hottest point in °C' at graph 0, graph 1.09 left offset -4,0
eval label_ends
plot for [k = 1:n] data using "creep_percent":(of(k, column(quantity))) with lines linetype k title word(speeds, k).' m/s, temperature'
unset multiplot
