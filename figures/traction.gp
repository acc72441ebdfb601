# Shear traction q*(s) for four tractions Q* (the paper's Fig. 2), and below it what heat changes.
name = 'traction'; height = 600
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

quantity = 'q'
parameter = 'traction'; symbol = 'Q*'; values = '0.2 0.4 0.5 0.59'
set multiplot
eval upper_panel
eval range(-1, 1, 0, 0.4)
eval axes('', 'q*')
eval heat_key(0.54, 0.185)
set xtics 0.5
set ytics 0.1
set label '{/:Italic Q*} = 0.59' at -0.62, 0.335 right
set label '0.5' at -0.16, 0.235
set label '0.4' at 0.21, 0.215
set label '0.2' at 0.6, 0.145
eval leader(-0.61, 0.333, -0.53, 0.326)
eval leader(-0.17, 0.236, -0.33, 0.243)
eval leader(0.2, 0.216, 0.04, 0.245)
eval leader(0.59, 0.146, 0.47, 0.155)
eval draw_hot_family
eval lower_panel
eval range(-1, 1, -0.002, 0.002)
eval change_axes('q*')
eval change_key(0.02, 0.36)
set ytics 0.001
eval draw_changes
unset multiplot
