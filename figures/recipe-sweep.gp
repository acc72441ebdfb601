# The hottest point of many scenes against the speed; the colour is the traction. Those with H > 0.1,
# where a/R is above 0.1, are circles.
name = 'recipe-sweep'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

set logscale xy
set xrange [1:1e4]
set yrange [1e-4:1]
eval axes('Pe', 'T*')
set format xy '10^{%T}'
set rmargin at screen 0.82
set colorbox user origin screen 0.845, screen 0.14 size screen 0.03, screen 0.765
set cbrange [0:0.6]
set cbtics 0.2 offset -0.6,0
set label 1 '{/:Italic Q*}' at screen 0.86, graph 1.075 center
# Colours that stand out on white and on near-black.
set palette defined (0 '#7a4fd0', 0.5 '#1f9e89', 1 '#d9a004')
beyond(x) = column("heating") > 0.1 ? x : NaN
contact(x) = column("heating") > 0.1 ? NaN : x
plot data using "peclet":(contact(column("max_temperature"))):"traction" \
       with points pointtype 7 pointsize 0.35 palette title 'a/R ≤ 0.1', \
     data using "peclet":(beyond(column("max_temperature"))):"traction" \
       with points pointtype 6 pointsize 0.6 palette title 'a/R > 0.1'
