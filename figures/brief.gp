# The creep curve of the paper's wheel: with distortion by heat, and with friction that falls.
name = 'brief'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 2, 0, 1.12)
set xlabel '{/:Italic ξ*} over that of full slip' offset 0,1.1
set label 100 '{/:Italic Q*}/{/:Italic f}' at graph 0, graph 1.075 right offset 0.8,0
set xtics 0.5
set ytics 0.2
set label "Carter; with heat's distortion" at 1.98, 1.05 right
set label 'two bodies of steel' at 1.98, 0.946 right
set label 'one body takes all heat' at 1.98, 0.67 right
set label 'friction falls with temperature,' at 0.62, 0.3
set label 'none left at 1600 °C' at 0.62, 0.225
of(name) = strcol('curve') eq name ? column('traction') : NaN
plot data using 'creep':(of('Carter')) with lines linecolor rgb 'grey50' linewidth 2.5 title 'Carter', \
     data using 'creep':(of('constant friction')) with lines linetype 1 linewidth 0.8 title 'distortion', \
     data using 'creep':(of('two bodies')) with lines linetype 2 dashtype solid title 'two bodies', \
     data using 'creep':(of('one body')) with lines linetype 3 dashtype solid title 'one body', \
     data using 'creep':(of('maximum')) with points linetype 5 title 'maximum'
