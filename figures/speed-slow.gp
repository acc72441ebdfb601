# Time of a solve against relative error at Pe = 100 and H = 0.0175.
name = 'speed-slow'
height = 260
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval speed_figure
