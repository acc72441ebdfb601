# The creep of many random scenes over that without heat, against the heating; the colour is the speed.
name = 'recipe-sweep'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

# Carter's creep, without heat.
cold = 'column("friction")*2/pi*(1 - sqrt(1 - column("traction")/column("friction")))'
eval 'cold_creep(x) = '.cold
set logscale x
set logscale cb
set xrange [1e-4:10]
set yrange [0.2:1.2]
set ytics 0.2
set format x '10^{%T}'
set xlabel '{/:Italic fH}' offset 0,1.1
set label 1 'creep over that without heat' at graph 0, graph 1.075 left offset -4,0
set rmargin at screen 0.82
set colorbox user origin screen 0.845, screen 0.14 size screen 0.03, screen 0.765
set cbrange [1:1e4]
set format cb '10^{%T}'
set cbtics offset -0.6,0
set label 2 'Pe' at screen 0.86, graph 1.075 center
set palette defined (0 '#440154', 0.3 '#3e4989', 0.6 '#1f9e89', 1 '#fde725')
plot data using (column("friction")*column("heating")):(column("creep")/cold_creep(0)):"peclet" \
  with points pointtype 7 pointsize 0.35 palette title 'scenes'
