# A body in a uniform stream moves with it, rigidly and for ever, while the grid
# follows it: on one rank and on two. One that is twice as dense is accelerated
# by an accelerating stream 2/3 as fast (potential flow around a cylinder, whose
# added mass is that of the fluid it displaces).
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >stream.prm <<'END'
set Bodies = disc
subsection Time
  set End time = 1
  set Step     = 0.05
end
subsection Domain
  set Size   = 2, 1
  set Cells  = 8, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 3
  set Kinematic viscosity = 0.01
  set Initial velocity    = 1; 0
  set Inflow velocity     = 1; 0
  subsection Boundary conditions
    set left   = inflow
    set right  = inflow
    set bottom = free slip
    set top    = free slip
  end
end
subsection Body disc
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.5, 0.5
  end
  subsection Region body
    set Young's modulus = 30
  end
end
subsection Refinement
  set Interval    = 4
  set Body margin = 1
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END

translate() {
  for pair in "x of centre of mass=1.5" "y of centre of mass=0.5" "u of centre of mass=1" \
              "v of centre of mass=0" "area change=0" "min J=1" "force x of the fluid=0"; do
    difference=$(awk "BEGIN { print $(last "disc: ${pair%=*}" results/statistics.txt) - ${pair#*=} }")
    check "$1: $pair" "($difference)^2 < 1e-9^2"
  done
  check "$1: momentum" "($(last "kinetic energy" results/statistics.txt) - 3)^2 < 1e-8^2"
}
caudal stream.prm
translate "one rank"
caudal stream.prm -D "Time/Scheme=explicit" -D "Time/End time=0.2" -D "Time/Step=0.01" \
  -D "Body disc/Shape/Position=1.3, 0.5"
translate "explicit"
mpirun -np 2 "$CAUDAL" stream.prm >caudal.log 2>&1 || cat caudal.log
translate "two ranks"
grep Warning caudal.log || true

for density in 6 1.5; do
  caudal stream.prm -D "Fluid/Initial velocity=0;0" -D "Fluid/Inflow velocity=t;0" \
    -D "Fluid/Kinematic viscosity=1e-6" -D "Time/End time=0.05" -D "Time/Step=0.005" \
    -D "Coupling/Kernel=dirac" -D "Body disc/Density=$density" -D "Domain/Levels=4"
  check "density $density: as in theory within 6 %" \
    "($(last "disc: u of centre of mass" results/statistics.txt) / 0.05 / (2 / (1 + $density / 3)) - 1)^2 < 0.06^2"
done
