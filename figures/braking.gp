# Traction against creep: the paper's pair that drives and that brakes, two identical bodies, no heat.
name = 'braking'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 0.45, 0, 0.65)
eval axes('ξ*', 'Q*')
set xtics 0.1
set ytics 0.1
set key at screen 0.98, screen 0.99 right top samplen 0.8 maxrows 1 reverse Left width -3.2
curve(column_name, i, dash) = sprintf("data using 'creep':'%s' with lines linetype %d %s title '%s'", \
  column_name, i, dash, column_name)
eval "plot ".curve('driving', 1, '').", ".curve('identical', 2, '').", ".curve('braking', 3, '').", " \
  ."data using 'creep':'carter' with lines linetype 6 title 'no heat'"
