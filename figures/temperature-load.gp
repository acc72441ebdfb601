# Surface temperature T*(s) at Pe = 1000 for four tractions Q* (the paper's Fig. 5).
name = 'temperature-load'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

T_max = 0.008; T_step = 0.002
parameter = 'traction'; symbol = 'Q*'; values = '0.2 0.4 0.5 0.59'; order = '1 2 3 4'
eval temperature_figure
