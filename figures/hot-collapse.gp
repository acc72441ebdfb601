# Traction against creep, both over the friction, for three softening numbers at five speeds.
name = 'hot-collapse'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 1.44, 0, 1)
eval axes('ξ*/f_0', 'Q*/f_0')
set xtics 0.5
set ytics 0.2
set rmargin at screen 0.86
set bmargin at screen 0.155
of(lambda) = column("softening") == lambda ? column("traction") : NaN
fast(lambda) = column("peclet") == 5e4 ? of(lambda) : NaN
slow(lambda) = column("peclet") == 1 ? of(lambda) : NaN
between(lambda) = column("peclet") > 1 && column("peclet") < 5e4 ? of(lambda) : NaN
set label '{/:Italic Λ} = 1' at graph 1.02, first 0.6
set label '3' at graph 1.02, first 0.36
set label '6' at graph 1.02, first 0.2
curve(lambda, i) = sprintf("data using 'creep':(slow(%d)) with lines linetype %d dashtype (4,3) " \
  ."linewidth 0.8 title 'Λ = %d, Pe = 1', data using 'creep':(fast(%d)) with lines linetype %d " \
  ."dashtype solid title 'Λ = %d', data using 'creep':(between(%d)) with points linetype 5 " \
  ."title 'Λ = %d, Pe between'", lambda, i, lambda, lambda, i, lambda, lambda, lambda)
eval "plot ".curve(1, 4).", ".curve(3, 1).", ".curve(6, 3)
