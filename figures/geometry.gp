# The contact of the cylinder and the half-space, schematically (the paper's Fig. 1).
name = 'geometry'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

# The border c of stick and slip, the cylinder's radius R and the height of its axle, all in units
# of the half-width a of the contact, as the data have them.
part(word, value) = strcol("part") eq word ? value : NaN
stats data using (part("slip", column("x"))) nooutput
c = STATS_min
stats data using (part("cylinder", column("y"))) nooutput
top = STATS_max; R = (top**2 + 1)/(2*top); axle = top - R

unset border; unset tics
set lmargin at screen 0; set rmargin at screen 1
set tmargin at screen 1; set bmargin at screen 0
set xrange [-4.4:4.4]; set yrange [-1.45:4.52]    # one scale: 8.8/560 = 5.97/380
set style fill transparent solid 0.14 noborder
set style arrow 1 filled size 0.17,20 fixed linecolor rgb 'black' linewidth 0.6
set style arrow 2 filled size 0.22,20 fixed linecolor rgb 'black' linewidth 1.1
set style arrow 3 filled size 0.12,25 fixed linecolor rgb vermilion linewidth 0.8
set style arrow 4 nohead linecolor rgb 'black' linewidth 0.5

# Loads, motion and radius.
set label '{/:Italic P}' at 0.15, top + 0.55
set arrow from 0, top + 0.75 to 0, top arrowstyle 2
set label '{/:Italic Q}' at 1.05, axle + 0.05
set arrow from 0, axle to 0.95, axle arrowstyle 2
set label '' at 0, axle point pointtype 7 pointsize 0.3 linecolor rgb 'black'
set label '{/:Italic R}' at -1.05, axle - 0.08
set arrow from 0, axle to -R*cos(0.35), axle - R*sin(0.35) arrowstyle 1
set label "{/:Italic V}" at -3.35, -0.7 center
set arrow from -3.9, -0.45 to -2.8, -0.45 arrowstyle 1
set label "{/:Italic V}" at 3.35, -0.7 center
set arrow from 2.8, -0.45 to 3.9, -0.45 arrowstyle 1
rim_x(degrees) = (R + 0.25)*cos(degrees*pi/180)
rim_y(degrees) = axle + (R + 0.25)*sin(degrees*pi/180)
do for [k = 15:57:3] {
  set arrow from rim_x(k), rim_y(k) to rim_x(k + 3), rim_y(k + 3) arrowstyle 4
}
set arrow from rim_x(60), rim_y(60) to rim_x(64), rim_y(64) arrowstyle 1
set label '{/:Italic V} / {/:Italic R}' at (R + 0.4)*cos(0.65), axle + (R + 0.4)*sin(0.65)

# The driving torque, which turns the cylinder against Q and the traction.
turn_x(degrees) = 0.42*cos(degrees*pi/180)
turn_y(degrees) = axle + 0.42*sin(degrees*pi/180)
do for [k = 100:222:6] {
  set arrow from turn_x(k), turn_y(k) to turn_x(k + 6), turn_y(k + 6) arrowstyle 4
}
set arrow from turn_x(228), turn_y(228) to turn_x(246), turn_y(246) arrowstyle 1
set label '{/:Italic QR}' at -0.38, axle + 0.5 right

# What counts as positive, on both sides of a piece of the surface.
set label 'positive' at -3.3, 3.6 center
set arrow from -4.15, 2.4 to -2.45, 2.4 arrowstyle 4
set arrow from -3.85, 2.4 to -3.85, 3.1 arrowstyle 1
set label '{/:Italic V}_2' at -3.72, 2.95
set arrow from -3.85, 2.4 to -3.85, 1.7 arrowstyle 1
set label '{/:Italic V}_1' at -3.72, 1.85
set arrow from -3.45, 2.58 to -2.95, 2.58 arrowstyle 1
set label '{/:Italic v}' at -2.87, 2.7
set arrow from -3.45, 2.22 to -2.95, 2.22 arrowstyle 1
set label '{/:Italic q}, {/:Italic U}_1' at -2.87, 2.1

# The wheel goes against the material.
set arrow from 4.1, 3.6 to 3.0, 3.6 arrowstyle 2
set label 'the wheel travels' at 4.3, 3.95 right

# The axes, the zones and the heat.
set arrow from 1.05, 0 to 2.3, 0 arrowstyle 1
set label '{/:Italic x}' at 2.2, 0.25
set arrow from 0, 0 to 0, 0.95 arrowstyle 1
set label '{/:Italic y}' at 0.12, 0.85
set label 'stick' at (c - 1)/2, 0.24 center
set label 'slip' at (c + 1)/2, 0.24 center
set arrow from -1, -0.08 to -1, -0.25 arrowstyle 4
set arrow from c, -0.08 to c, -0.25 arrowstyle 4
set arrow from 1, -0.08 to 1, -0.25 arrowstyle 4
set label '−{/:Italic a}' at -1.05, -0.42 center
set label '{/:Italic c}' at c, -0.42 center
set label '{/:Italic a}' at 1, -0.42 center
do for [k = 1:4] {
  set arrow from c + k*(1 - c)/5.0, -0.08 to c + k*(1 - c)/5.0, -0.6 arrowstyle 3
}
set label 'heat {/:Italic f V v p}' at (c + 1)/2, -0.85 center
set label 'half-space' at -4.2, -1.2
set label 'cylinder, insulated' at 0, axle + 0.55*R center

plot data using "x":(part("half_space", column("y"))) with filledcurves y=-1.45 \
       linecolor rgb 'grey50' title 'half-space', \
     data using "x":(part("cylinder", column("y"))) with filledcurves closed \
       linecolor rgb 'grey50' title 'cylinder', \
     data using "x":(part("cylinder", column("y"))) with lines \
       linecolor rgb 'black' linewidth 0.6 dashtype solid title 'outline of the cylinder', \
     data using "x":(part("half_space", column("y"))) with lines \
       linecolor rgb 'black' linewidth 0.6 dashtype solid title 'surface of the half-space', \
     data using "x":(part("stick", column("y"))) with lines \
       linecolor rgb blue linewidth 3 dashtype solid title 'stick zone', \
     data using "x":(part("slip", column("y"))) with lines \
       linecolor rgb vermilion linewidth 3 dashtype solid title 'slip zone'
