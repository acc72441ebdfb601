# As figures/iteration-a.gp, with the sign corrected.
name = 'iteration-b'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'iteration-a.gp'
