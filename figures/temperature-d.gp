# Surface temperature T*(s) at Q* = 0.59 for four Péclet numbers (the paper's Fig. 4d).
name = 'temperature-d'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

T_max = 0.025; T_step = 0.005
parameter = 'peclet'; symbol = 'Pe'; values = '100 500 1000 5000'; order = '4 3 2 1'
eval temperature_figure
