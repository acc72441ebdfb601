# Surface temperature T*(s) at Q* = 0.2 for four Péclet numbers (the paper's Fig. 4a).
name = 'temperature-a'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

T_max = 0.004; T_step = 0.001
parameter = 'peclet'; symbol = 'Pe'; values = '100 500 1000 5000'; order = '4 3 2 1'
eval temperature_figure
