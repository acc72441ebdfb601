# Shear traction q*(s) for four tractions Q* (the paper's Fig. 2).
name = 'traction'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

quantity = 'q'
parameter = 'traction'; symbol = 'Q*'; values = '0.2 0.4 0.5 0.59'
eval range(-1, 1, 0, 0.4)
eval axes('s', 'q*')
eval key(0.38, 0.13)
set xtics 0.5
set ytics 0.1
set label '{/:Italic Q*} = 0.59' at -0.58, 0.325 right
set label '0.5' at -0.27, 0.245
set label '0.4' at 0.11, 0.215
set label '0.2' at 0.55, 0.14
eval draw_family
