# Time of a solve against relative error at Pe = 100 and H = 1.
name = 'speed-hot'
height = 900
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

notes = note('gauss_chebyshev', 400, 'published scheme, n = 400', 'left offset 0.5,0.3') \
  .note('thrifty', 400, 'cached', 'left offset 0.5,-0.2') \
  .note('moments', 400, 'product integration', 'left offset 0.5,-0.2') \
  .note('coupled', 1e-8, 'coupled', 'right offset 0,-1.3') \
  .note('first_order', 0, 'first order', 'left offset 0.7,-0.3')
eval speed_figure
