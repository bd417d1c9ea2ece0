# SPDX-License-Identifier: LGPL-2.1-or-later
# What can't be, or is likely not meant, is said at the start, before anything is written: sizes
# that no machine has, bodies that the grid does not see, gaits and tables that end, units.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >good.prm <<'END'
set Bodies = fish
subsection Time
  set End time = 1
  set Step     = 0.005
end
subsection Domain
  set Size   = 4, 2
  set Cells  = 16, 8
  set Levels = 4
end
subsection Fluid
  set Density             = 1000
  set Kinematic viscosity = 1e-3
  set Inflow velocity     = 1; 0
  subsection Boundary conditions
    set left  = inflow
    set right = outflow
  end
end
subsection Body fish
  set Regions = head, tail
  subsection Shape
    set Type              = eel
    set Elements          = 20, 4
    set Position          = 1.5, 1
    set Region boundaries = 0.5
  end
  subsection Region head
    set Young's modulus    = 1e5
    set Feedback stiffness = 1e6
  end
  subsection Region tail
    set Young's modulus = 1e5
  end
end
subsection Output
  set Folder = results
end
END

# warn TEXT OVERRIDES: what --check warns of.
warn() {
  echo "* $1"
  shift
  "$CAUDAL" --check --fast good.prm "$@" 2>&1 | grep -E "^(Warning|Error|No problems)" | grep -v thinnest | sed 's/^/    /'
  [ ! -e results ] || echo "    there is a folder of results"
}

# of_memory: without the memory that is free, which depends on the machine.
of_memory() {
  sed 's/and [0-9.e+]* GiB are free/and ... GiB are free/'
}

echo "= sizes"
refuse "too many levels" good.prm -D "Domain/Levels=12" -D "Domain/Cells=160, 80" | of_memory
override "Domain/Cells" "100000, 50000" | of_memory
override "Body fish/Shape/Elements" "2000000, 400000" | of_memory
override "Domain/Cells" "16, 2"

echo "* less virtual memory than the program's libraries take"
(
  ulimit -v 600000
  timeout 60 "$CAUDAL" --check good.prm
) 2>&1 | sed 's/^/    /'

echo "= a body that is thinner than half a cell"
cat >thin.prm <<'END'
include good.prm
subsection Domain
  set Levels = 1
end
subsection Body fish
  set Gait damping = 1e4
  subsection Gait
    set Type = travelling wave
  end
end
END
refuse "a swimmer" thin.prm
echo "    on demand it is marked $("$CAUDAL" thin.prm -D "Time/End time=0.005" \
  -D "Coupling/Accept unresolved bodies=true" 2>errors | grep -c "MEAN NOTHING") times"
rm -rf results

echo "= gaits and tables"
wave="Body fish/Gait/Travelling wave"
refuse "a slope of the midline beyond 1" good.prm -D "Body fish/Gait/Type=travelling wave" \
  -D "$wave/Amplitude=0.0874" -D "$wave/Offset=0.3138" -D "$wave/Wave number=2.492"
printf '0, 0\n0.5, 1\n' >force.csv
refuse "a table of forces that ends" good.prm -D "Body fish/Muscle/Type=table" \
  -D "Body fish/Muscle/Table/File=force.csv"
printf '0.1, 0\n2, 1\n' >late.csv
refuse "one that begins too late" good.prm -D "Body fish/Muscle/Type=table" \
  -D "Body fish/Muscle/Table/File=late.csv"
refuse "to go on beyond it" good.prm -D "Body fish/Muscle/Type=table" \
  -D "Body fish/Muscle/Table/File=late.csv" -D "Time/End time=3"

echo "= fluxes"
refuse "an inflow without outflow" good.prm -D "Fluid/Boundary conditions/right=wall"
refuse "one from a time on" good.prm -D "Fluid/Boundary conditions/right=wall" \
  -D "Fluid/Inflow velocity=if(t>0.5,1,0); 0"
warn "fluxes that differ by half a percent" -D "Fluid/Boundary conditions/right=inflow" \
  -D "Fluid/Boundary conditions/Right inflow/Velocity=1.005; 0"
cat >tank.prm <<'END'
subsection Time
  set End time = 0.01
  set Step     = 0.005
end
subsection Domain
  set Size   = 4, 2
  set Cells  = 4, 2
  set Levels = 1
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1
  set Initial velocity    = 1; 0
  set Inflow velocity     = 1; 0
  set Probes              = 3.9, 1
  subsection Boundary conditions
    set left   = inflow
    set right  = inflow
    set bottom = free slip
    set top    = free slip
    subsection Right inflow
      set Velocity = 1.005; 0
    end
  end
end
subsection Output
  set Folder = results
end
END
echo "* what flows out then is what flows in"
"$CAUDAL" tank.prm >printed 2>&1
echo "    $(last "u at probe 1" results/statistics.txt) m/s"
rm -rf results

echo "= values"
warn "nothing"
warn "a light body" -D "Body fish/Density=1"
warn "a soft body" -D "Body fish/Region head/Young's modulus=2" -D "Body fish/Region tail/Young's modulus=2"
warn "long steps" -D "Time/Step=0.2"
warn "a thin boundary layer" -D "Fluid/Kinematic viscosity=1e-6"
warn "grad-div stabilisation" -D "Fluid/Boundary conditions/left=wall" -D "Fluid/Inflow velocity=0; 0" \
  -D "Body fish/Gait/Type=travelling wave" -D "Body fish/Region head/Feedback stiffness=0" \
  -D "Body fish/Shape/Region boundaries=0.5" -D "Refinement/Vorticity threshold=0.1" \
  -D "Body fish/Gait damping=1e4" -D "Time/End time=0.5" -D "Fluid/Grad-div stabilisation=1"
warn "too little grad-div stabilisation for the step" -D "Fluid/Grad-div stabilisation=1e-5"
warn "a swimmer in a current, which takes a part of its way" \
  -D "Body fish/Gait/Type=travelling wave" -D "Body fish/Region head/Feedback stiffness=0" \
  -D "Body fish/Shape/Region boundaries=0.5" -D "Refinement/Vorticity threshold=0.1" \
  -D "Body fish/Gait damping=1e4" -D "Time/End time=5" -D "Fluid/Initial velocity=0.3; 0"
warn "a symmetric body that is free" -D "Body fish/Density=1100" -D "Body fish/Region head/Feedback stiffness=0"

cat >ball.prm <<END
set Dimension = 3
set Bodies    = ball
subsection Time
  set End time = 2e5
  set Step     = 0.01
end
subsection Domain
  set Size   = 1, 1, 1
  set Cells  = 2, 2, 2
  set Levels = 3
end
subsection Fluid
  set Grad-div stabilisation = 1
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
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Refinement
  set Body margin = 0
end
subsection Solver
  set Method = iterative
end
END
echo "* a run in space that takes weeks: told by estimate, before any step"
"$CAUDAL" --check --fast ball.prm | sed -n 's/^Warning: Domain/    &/p; s/^Estimate/    &/p'
