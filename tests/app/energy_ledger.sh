# The residual of the energy ledger falls with the step at the order of the schemes,
# two: an eel with muscle, springs and dampers that starts from rest in a closed box.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >eel.prm <<'END'
set Bodies = eel
subsection Time
  set End time = 0.2
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 2
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.02
end
subsection Body eel
  subsection Shape
    set Type     = eel
    set Length   = 0.5
    set Elements = 12, 4
    set Position = 0.25, 0.5
  end
  subsection Region body
    set Young's modulus    = 30
    set Feedback stiffness = 100
    set Feedback damping   = 10
  end
  subsection Muscle
    set Type          = travelling wave
    set Start-up ramp = 0.1
    subsection Travelling wave
      set Maximum active stress = 60
      set Frequency             = 3
    end
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Refinement
  set Level expression = 1
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END

# converge SCHEME STEP: the observed order of the largest residual of the run, rounded.
converge() {
  rm -f residuals
  for factor in 1 0.5; do
    caudal eel.prm -D "Time/Scheme=$1" -D "Time/Step=$(awk "BEGIN { print $factor * $2 }")"
    column "energy residual" results/statistics.txt |
      awk '{ r = $1 < 0 ? -$1 : $1; if (r > largest) largest = r } END { print largest }' >>residuals
  done
  awk -v scheme="$1" '{ r[NR] = $1 }
    END { printf "%s: order %.0f\n", scheme, log(r[1] / r[2]) / log(2) }' residuals
}
converge semi-implicit 0.0025
converge explicit 0.002

# Every part of the ledger takes part in it.
work=$(last "eel: muscle work" results/statistics.txt)
share() {
  check "$1: more than 1 % of the muscle's work" \
    "($(last "$1" results/statistics.txt))^2 > (0.01 * $work)^2"
}
share "kinetic energy"
share "eel: elastic energy"
share "dissipation"
share "numerical dissipation"
share "eel: feedback work"
check "residual: less than 0.1 %" "$(tail -n 1 residuals) < 0.001 * $work"

# Energy through the sides and by the body force: a channel with a jet, from rest.
cat >channel.prm <<'END_OF_FILE'
subsection Time
  set End time = 0.4
end
subsection Domain
  set Size   = 2, 1
  set Cells  = 8, 4
  set Levels = 2
end
subsection Fluid
  set Density             = 2
  set Kinematic viscosity = 0.05
  set Body force          = 20*sin(10*t)*y; 3
  set Inflow velocity     = 6*y*(1-y)*(2+y); 0
  set Inflow ramp         = 0.3
  subsection Boundary conditions
    set left  = inflow
    set right = outflow
  end
end
subsection Refinement
  set Level expression = if(x < 0.5, 1, 0)
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END_OF_FILE
caudal channel.prm -D "Time/Step=0.0025"
residual=$(last "energy residual" results/statistics.txt)
external=$(last "external work" results/statistics.txt)
check "channel: external work" "$external > 0"
check "channel: residual less than 0.1 % of it" "($residual)^2 < (0.001 * $external)^2"

# In a closed box with little viscosity and large steps the time scheme takes a tenth of the work.
caudal channel.prm -D "Fluid/Boundary conditions/left=wall" -D "Fluid/Boundary conditions/right=wall" \
  -D "Fluid/Inflow velocity=0; 0" -D "Fluid/Kinematic viscosity=1e-3" -D "Fluid/Body force=20*sin(10*t)*y; 0" -D "Time/Step=0.03" -D "Time/End time=2"
residual=$(last "energy residual" results/statistics.txt)
external=$(last "external work" results/statistics.txt)
check "box: residual less than 1 % of the work" "($residual)^2 < (0.01 * $external)^2"

# The work of a gait counts what accelerates a body that is heavier than the fluid.
caudal "$CAUDAL_SOURCE_DIR/prm/eel.prm" -D "Output/Folder=heavy" -D "Output/Interval of fields=100" \
  -D "Domain/Cells=16,8" -D "Body eel/Shape/Elements=32,4" -D "Refinement/Vorticity threshold=0" \
  -D "Body eel/Density=2" -D "Time/Step=0.01" -D "Time/End time=0.4"
residual=$(last "energy residual" heavy/statistics.txt)
work=$(last "eel: muscle work" heavy/statistics.txt)
check "heavy eel: residual less than 2 % of the work" "($residual)^2 < (0.02 * $work)^2"
