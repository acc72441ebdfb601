# The kernels N1 and N2 (thermal deformation) and M (temperature) against ζ.
name = 'kernels'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-6, 6, -1, 3)
eval axes('ζ', '')
set xtics 2
set ytics 1
set label '{/:Italic M}' at -2.6, 1.25
set label '{/:Italic N}_1' at 1.9, 0.65
set label '{/:Italic N}_2' at 2.1, -0.8
eval leader(-2.2, 1.12, -1.9, 0.9)
eval leader(1.8, 0.6, 1.0, 0.28)
eval leader(2, -0.75, 1.5, -0.56)
set label 'downstream' at -5.8, 2.8
set label 'upstream' at 5.8, 2.8 right

# N1 jumps at its source: two pieces.
plot data using "zeta":(column("zeta") < 0 ? column("N1") : NaN) \
       with lines linetype 1 title 'N1, downstream', \
     data using "zeta":(column("zeta") > 0 ? column("N1") : NaN) \
       with lines linetype 1 title 'N1, upstream', \
     data using "zeta":"N2" with lines linetype 2 title 'N2', \
     data using "zeta":"M" with lines linetype 3 title 'M'
