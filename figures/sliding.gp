# Surface temperature T*(s) of rolling and of pure sliding with the same heat, at Pe = 1000.
name = 'sliding'
load ARG0[:strlen(ARG0) - strlen(name.'.gp')].'style.gp'

eval range(-1, 3, 0, 0.005)
eval axes('s', 'T*')
set xtics 1
set ytics 0.001
set label 'rolling, {/:Italic Q*} = 0.5' at 1.25, 0.0043
set label "sliding,\nsame heat" at -0.2, 0.0036 right
set label 'rolling, {/:Italic Q*} = 0.2' at 1.3, 0.00105
set label 'sliding' at 0.07, 0.00083
eval leader(1.23, 0.0043, 0.96, 0.0043)
eval leader(-0.18, 0.00315, 0.03, 0.0027)
eval leader(1.28, 0.00104, 1.03, 0.0008)
eval leader(0.3, 0.0007, 0.3, 0.0004)
plot data using "s":(row("kind", "rolling", "traction", 0.5, column("T"))) \
       with lines linetype 3 dashtype solid title 'Q* = 0.5, rolling' noenhanced, \
     data using "s":(row("kind", "sliding", "traction", 0.5, column("T"))) \
       with lines linetype 3 dashtype (5,4) title 'Q* = 0.5, sliding' noenhanced, \
     data using "s":(row("kind", "rolling", "traction", 0.2, column("T"))) \
       with lines linetype 1 dashtype solid title 'Q* = 0.2, rolling' noenhanced, \
     data using "s":(row("kind", "sliding", "traction", 0.2, column("T"))) \
       with lines linetype 1 dashtype (5,4) title 'Q* = 0.2, sliding' noenhanced
