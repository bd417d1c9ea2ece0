# Short swims: the fish's muscle reverses and the result does not depend on the
# number of ranks; two fish, one steered and one driven by a table; an eel by its
# gait, which exerts no net force; a ball in 3D; fields in HDF5.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

# The paper's fish, on a coarse grid in a small tank, with a muscle that reverses soon.
cat >fish.prm <<END
include $CAUDAL_SOURCE_DIR/prm/fish.prm
subsection Time
  set End time = 0.06
  set Step     = 0.004
end
subsection Domain
  set Size   = 3, 2
  set Cells  = 6, 4
  set Levels = 4
end
subsection Body fish
  subsection Shape
    set Elements = 40, 4
    set Position = 1, 1
  end
  subsection Muscle
    set Force distribution = if(s>0.7,1,0)
    subsection Bang-bang
      set Maximum force density = 2e5
      set Switching position    = 0.003
      set Switching duration    = 0
    end
  end
end
subsection Refinement
  set Vorticity levels = 3
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END
caudal fish.prm
column "fish: activation" results/statistics.txt >activation
column "fish: lateral position" results/statistics.txt >positions
# The activation is that of the middle of a step: it may reverse a row after the position passes.
paste activation positions | awk '
  $2 > 0.003 && !passed { passed = NR }
  $1 < 1 && !step { step = NR }
  END { where = step == passed || step == passed + 1 ? "there" : "elsewhere"
    print "the muscle reverses where it should: " where ", activation then " $1 }'
names="x of point 1/y of point 3/u of centre of mass/muscle work/area change"
echo "$names" | tr / '\n' | while read -r name; do last "fish: $name" results/statistics.txt; done >one_rank
mpirun -np 2 "$CAUDAL" fish.prm >caudal.log 2>&1 || cat caudal.log
echo "$names" | tr / '\n' | while read -r name; do last "fish: $name" results/statistics.txt; done >two_ranks
paste one_rank two_ranks | awk '{ d = $1 - $2; if (d * d > (1e-5 * $1)^2) wrong = 1 }
  END { print "on two ranks " (wrong ? "something else" : "the same") }'

# Two fish in one tank: one steered to the left, one driven by a table.
printf '# time [s], force density [N/m^3]\n0 0\n0.02 1e5\n0.04 0\n' >table.txt
cat >school.prm <<'END'
set Bodies = left, right
subsection Time
  set End time = 0.05
  set Step     = 0.005
end
subsection Domain
  set Size   = 3, 2
  set Cells  = 6, 4
  set Levels = 3
end
subsection Coupling
  set Kernel = dirac
end
subsection Body left
  subsection Shape
    set Type     = naca
    set Elements = 40, 4
    set Position = 1, 0.6
  end
  subsection Region body
    set Young's modulus = 1e6
  end
  subsection Muscle
    set Type = travelling wave
    subsection Travelling wave
      set Maximum active stress = 1e4
      set Frequency = 2
    end
  end
  subsection Controller
    set Type = heading
    subsection Heading
      set Target heading = 0.5
      set Heading gain   = 1
    end
  end
end
subsection Body right
  subsection Shape
    set Type     = naca
    set Elements = 40, 4
    set Position = 1.2, 1.4
  end
  subsection Region body
    set Young's modulus = 1e6
  end
  subsection Muscle
    set Type               = table
    set Force distribution = s
    subsection Table
      set File = table.txt
      set Periodic = true
    end
  end
end
subsection Output
  set Folder             = results
  set Interval of fields = 0.05
  set Format             = hdf5
end
END
caudal school.prm
check "the fish with the active stress moves its tail" \
  "($(last "left: lateral position" results/statistics.txt))^2 > 1e-4^2"
check "the force of the table works" "$(last "right: muscle work" results/statistics.txt) > 0"
check "power identity" "$(last "power identity" results/statistics.txt) < 1e-10"
ls results results/fields
steered=$(last "left: lateral position" results/statistics.txt)
caudal school.prm -D "Body left/Controller/Type=none"
check "its controller bends it" "$steered < $(last "left: lateral position" results/statistics.txt) - 1e-5"

# Fish that meet: at the start and, drawn together by the force of the table, on their way.
rm -rf results
for place in 0.78 0.95; do
  "$CAUDAL" school.prm -D "Body right/Shape/Position=1, $place" -D "Body right/Muscle/Force distribution=-10*s" \
    -D "Time/End time=0.2" 2>&1 >/dev/null | grep -o "Bodies left and right are .* m apart" | sed 's/[0-9.]\{4,\}/.../'
done
[ -e results/restart ] && echo "the last good state is kept"

# An eel that moves as its gait prescribes: the muscle exerts no net force.
cat >eel.prm <<'END'
set Bodies = eel
subsection Time
  set End time = 0.2
  set Step     = 0.01
end
subsection Domain
  set Size   = 3, 2
  set Cells  = 6, 4
  set Levels = 4
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-3
end
subsection Body eel
  set Gait damping     = 1e4
  set Monitored points = 1, 0
  subsection Shape
    set Type     = eel
    set Elements = 30, 4
    set Position = 1, 1
  end
  subsection Region body
    set Material = none
  end
  subsection Gait
    set Type          = curvature
    set Start-up ramp = 0.2
    subsection Curvature
      set Function = 2*s*sin(2*pi*(s-t))
    end
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END
caudal eel.prm
largest() {
  column "$1" results/statistics.txt |
    awk '{ x = $1 < 0 ? -$1 : $1; if (x > largest) largest = x } END { print largest }'
}
check "the eel's tail beats" "$(largest "eel: v of point 1") > 0.1"
check "the eel moves" "$(largest "eel: u of centre of mass") > 1e-3"
# The only force on it is the fluid's, so that its impulse is the eel's momentum. The
# forces' differences in time add up to 3/2 of the last velocity and -1/2 of the one before.
column "eel: force x of the fluid" results/statistics.txt >forces
column "eel: u of centre of mass" results/statistics.txt >velocities
check "no other force" "($(awk '{ sum += 0.01 * $1 } END { print sum }' forces) / \
  $(tail -n 2 velocities | awk '{ u[NR] = $1 } END { print 0.048513 * (1.5 * u[2] - 0.5 * u[1]) }') - 1)^2 < 0.02^2"

# A ball on a spring in a stream, in 3D.
cat >ball.prm <<'END'
set Dimension = 3
set Bodies    = ball
subsection Time
  set End time = 0.03
  set Step     = 0.01
end
subsection Domain
  set Size   = 1, 1, 1
  set Cells  = 2, 2, 2
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.01
  set Initial velocity    = 1; 0; 0
  set Inflow velocity     = 1; 0; 0
  subsection Boundary conditions
    set left   = inflow
    set right  = outflow
    set bottom = free slip
    set top    = free slip
    set back   = free slip
    set front  = free slip
  end
end
subsection Body ball
  subsection Shape
    set Type     = disc
    set Radius   = 0.1
    set Elements = 4, 2, 4
    set Position = 0.5, 0.5, 0.5
  end
  subsection Region body
    set Young's modulus    = 10
    set Feedback stiffness = 1e4
    set Feedback damping   = 100
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Refinement
  set Body margin = 0
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END
caudal ball.prm
check "the stream drags it along" "$(last "ball: x of centre of mass" results/statistics.txt) > 0.501"
check "and it slows the stream" "$(last "ball: force x of the fluid" results/statistics.txt) > 0.1"
check "but pushes to no side" "($(last "ball: force y of the fluid" results/statistics.txt))^2 < 1e-9^2"
check "power identity" "$(last "power identity" results/statistics.txt) < 1e-10"
