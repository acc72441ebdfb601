# Traction against creep of a hot wheel on a cold rail, and of two bodies at the mean (dotted).
name = 'hot-wheel-grip'
height = 300
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 0.6, -0.1, 0.6)
eval axes('ξ*', 'Q*')
set xtics 0.1
set ytics 0.1
set rmargin at screen 0.86
set label '{/:Italic Θ} = 0' at graph 1.02, first 0.5
set label '{/:Italic T}_0*/3' at graph 1.02, first 0.42
set label '{/:Italic T}_0*' at graph 1.02, first 0.25
mean(column) = "data using 'creep':'".column."' with lines linetype 5 linewidth 0.6 dashtype (2,4) notitle"
eval "plot data using 'creep':'equal' with lines linetype 3 dashtype solid title 'Θ = 0', " \
  ."data using 'creep':'third' with lines linetype 2 dashtype solid title 'Θ = T0/3', " \
  ."data using 'creep':'whole' with lines linetype 1 dashtype solid title 'Θ = T0', " \
  .mean('mean_third').", ".mean('mean_whole')
