# Slip velocity v*(s) for four tractions Q* (the paper's Fig. 3), and below it what heat changes.
name = 'slip'; height = 600
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

quantity = 'v'
parameter = 'traction'; symbol = 'Q*'; values = '0.2 0.4 0.5 0.59'; order = '1 2 3 4'
eval range(-1, 1, 0, 0.8)
labelled = 'cold'
eval label_family
set multiplot
eval upper_panel
eval axes('', 'v*')
eval heat_key(0.05, 0.95)
set xtics 0.5
set ytics 0.2
eval draw_hot_family
eval lower_panel
eval range(-1, 1, -0.004, 0.004)
eval change_axes('v*')
eval change_key(0.04, 0.4)
set ytics 0.002
eval draw_changes
unset multiplot
