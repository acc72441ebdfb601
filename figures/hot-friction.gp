# Traction against creep where friction falls with temperature, and the usual shortcut (dashed).
name = 'hot-friction'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(0, 1, 0, 0.68)
eval axes('ξ*', 'Q*')
set xtics 0.2
set ytics 0.1
set rmargin at screen 0.86
of(kind, lambda) = row("kind", kind, "softening", lambda, column("traction"))
set label '{/:Italic Λ} = 0' at graph 1.02, first 0.6
set label '0.5' at graph 1.02, first 0.45
set label '1' at graph 1.02, first 0.355
set label '3' at graph 1.02, first 0.2
set label '6' at graph 1.02, first 0.12
curve(lambda, i) = sprintf("data using 'creep':(of('shortcut', %s)) with lines linetype %d " \
  ."dashtype (4,3) linewidth 0.8 notitle, data using 'creep':(of('local', %s)) with lines " \
  ."linetype %d dashtype solid title 'Λ = %s', ", lambda, i, lambda, i, lambda)
marks(kind, type) = sprintf("data using 'creep':(strcol('kind') eq '%s' ? column('traction') : NaN) " \
  ."with points linetype 5 pointtype %d title '%s'", kind, type, kind)
eval "plot data using 'creep':(of('local', 0)) with lines linetype 6 linewidth 1 title 'Λ = 0', " \
  .curve('0.5', 2).curve('1', 4).curve('3', 1).curve('6', 3) \
  .marks('maximum', 6).", ".marks('pair', 7)
