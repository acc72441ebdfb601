# Temperature along the contact before, at and past the maximum of the traction-creep curve.
name = 'hot-profile-b'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-1, 1, 0, 0.8)
eval axes('s', 'T*/T_0*')
set xtics 0.5
set ytics 0.2
set key at screen 0.97, screen 0.99 right top samplen 2 maxrows 1 reverse Left width 1
curve(state, i) = sprintf("data using 's':(strcol('state') eq '%s' ? column('T') : NaN) " \
  ."with lines linetype %d title '%s'", state, i, state)
eval "plot ".curve('before', 1).", ".curve('at', 2).", ".curve('past', 3)
