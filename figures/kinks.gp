# The error of the traction (full) and its estimate (dashed) where friction has a kink, for nodes
# where they are and for nodes moved to the kink.
name = 'kinks'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(16, 256, 1e-11, 1e-2)
eval axes('unknowns', '')
set label 'error of {/:Italic Q}*' at graph 0, graph 1.07 offset -4,0
set bmargin at screen 0.155
set rmargin at screen 0.95
set logscale xy
set xtics (16, 32, 64, 128, 256) offset 0,0.2
set ytics ('0.01' 1e-2, '10^{−4}' 1e-4, '10^{−6}' 1e-6, '10^{−8}' 1e-8, '10^{−10}' 1e-10)
set key at screen 0.97, screen 0.99 right top samplen 2 maxrows 1 reverse Left width 1
nodes(which, i, text) = sprintf("data using 'unknowns':'%s' with lines linetype %d dashtype solid title '%s', " \
  ."data using 'unknowns':'%s_estimate' with lines linetype %d dashtype (8,4) notitle", which, i, text, which, i)
eval "plot ".nodes('plain', 3, 'plain').", ".nodes('moved', 1, 'moved')
