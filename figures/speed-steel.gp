# Time of a solve against relative error at Pe = 4360 and H = 0.0175.
name = 'speed-steel'
height = 900
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

notes = note('gauss_chebyshev', 800, 'published scheme, n = 800', 'left offset 0.5,0.3') \
  .note('thrifty', 800, 'cached', 'left offset 0.5,-0.2') \
  .note('moments', 800, 'product integration', 'left offset 0.5,-0.2') \
  .note('coupled', 1e-8, 'coupled', 'right offset 0,-1.3') \
  .note('first_order', 0, 'first order', 'left offset 0,-1')
eval speed_figure
