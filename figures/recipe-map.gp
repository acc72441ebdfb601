# The temperature below the surface of a rail at a locomotive's wheel, as a map.
name = 'recipe-map'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

# Cells about the points of the grid.
set xrange [-1.25:2.45]
set yrange [0.02475:-0.00075]
eval axes('s', '')
set xtics 1
set ytics 0.005
set label 1 'depth' at graph 0, graph 1.075 left offset -4,0
set rmargin at screen 0.82
set colorbox user origin screen 0.845, screen 0.14 size screen 0.03, screen 0.765
set cbrange [0:100]
set cbtics 25 offset -0.6,0
set label 2 '°C' at screen 0.86, graph 1.075 center
set palette defined (0 '#440154', 0.04 '#482878', 0.11 '#3e4989', 0.2 '#31688e', 0.3 '#26828e', \
  0.41 '#1f9e89', 0.54 '#35b779', 0.68 '#6ece58', 0.83 '#b5de2b', 1 '#fde725')
plot data using "s":"depth":"temperature_celsius" with image title 'temperature'
