# Traction along the contact before, at and past the maximum of the curve, and its limit (dashed).
name = 'hot-profile-a'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-1, 1, 0, 0.5)
eval axes('s', 'q*')
set xtics 0.5
set ytics 0.1
set key at screen 0.97, screen 0.99 right top samplen 2 maxrows 1 reverse Left width 1
of(state, value) = strcol("state") eq state ? value : NaN
curve(state, i) = sprintf("data using 's':(of('%s', column('limit'))) with lines linetype %d " \
  ."dashtype (4,3) linewidth 0.8 notitle, data using 's':(of('%s', column('q'))) with lines " \
  ."linetype %d dashtype solid title '%s'", state, i, state, i, state)
eval "plot ".curve('before', 1).", ".curve('at', 2).", ".curve('past', 3)
