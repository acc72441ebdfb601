# Time of a solve against relative error at Pe = 4360 and H = 0.0175.
name = 'speed-steel'
height = 260
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval speed_figure
