# Surface temperature T*(s) at Q* = 0.5 for four Péclet numbers (the paper's Fig. 4c).
name = 'temperature-c'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

T_max = 0.016; T_step = 0.004
parameter = 'peclet'; symbol = 'Pe'; values = '100 500 1000 5000'; order = '4 3 2 1'
eval temperature_figure
