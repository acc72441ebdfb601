# Digits lost by the kernels' formulas as printed (lines) and with scaled Bessel functions (points).
name = 'arithmetic'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(1e-12, 1e12, 0, 16)
eval axes('|ζ|', '')
set label 'digits lost, of 16' at graph 0, graph 1.07 offset -4,0
set bmargin at screen 0.155
set rmargin at screen 0.955
set logscale x
set xtics ('10^{−12}' 1e-12, '10^{−8}' 1e-8, '10^{−4}' 1e-4, '1' 1, '10^4' 1e4, '10^8' 1e8, \
  '10^{12}' 1e12) offset 0,0.2
set ytics 4

# What each should lose, @eq:digits-lost, in units of its rounding error.
law(x) = log10(x)
slope(x) = x > 3 ? law(2*x) : NaN
near(x) = x < 0.1 ? law(1/(x*log(2/x))) : NaN
far(x) = x > 3 ? law(sqrt(pi/2*x)) : NaN

set label '{/:Italic N}_2' at 3e-9, 9.6
set label '{/:Italic N}_1' at 15, 3 right
set label '{/:Italic N}_1, {/:Italic N}_2, {/:Italic M}' at 150, 14 right
set label 'nothing left' at 150, 12.8 right
set label 'with scaled functions' at graph 0.06, graph 0.95
set label '' at graph 0.035, graph 0.95 point linetype 5
set arrow from graph 0.01, graph 0.885 rto graph 0.04, 0 nohead linewidth 1.25
set label 'as printed' at graph 0.06, graph 0.885
set label '{/:Italic N}_1' at 1e8, 10 right
set label '{/:Italic N}_2' at 1e10, 6.6 right
set label '{/:Italic M}' at 1e11, 0.9 right

plot data using "zeta":(slope(column("zeta"))) with lines linetype 6 title 'law of N1', \
     data using "zeta":(near(column("zeta"))) with lines linetype 6 title 'law of N2 near zero', \
     data using "zeta":(far(column("zeta"))) with lines linetype 6 title 'law of N2 at infinity', \
     data using "zeta":"N1" with lines linetype 1 title 'N1, printed', \
     data using "zeta":"N2" with lines linetype 2 title 'N2, printed', \
     data using "zeta":"M" with lines linetype 3 title 'M, printed', \
     data using "zeta":"N1_scaled" every 4 with points linetype 5 title 'N1, scaled', \
     data using "zeta":"N2_scaled" every 4 with points linetype 5 title 'N2, scaled', \
     data using "zeta":"M_scaled" every 4 with points linetype 5 title 'M, scaled'
