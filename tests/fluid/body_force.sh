# A channel in which the body force alone drives the flow u = (1 + t) y (1 - y), whose pressure is zero:
# Q2 and BDF2 have it exactly, on hanging nodes, too. What enters at one end leaves at the other, and the
# force's work is
#   2 rho int int ((1 + t) (y (1 - y))^2 + 2 nu (1 + t)^2 y (1 - y)) dy dt
#     = 4 ((t + t^2 / 2) / 30 + 0.1 ((1 + t)^3 - 1) / 18),
# and dt^2/180 more by the trapezoidal rule until t = 0.5.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
cat >channel.prm <<'END_OF_FILE'
subsection Time
  set End time = 0.5
  set Step     = 0.05
end
subsection Domain
  set Size   = 2, 1
  set Cells  = 4, 2
  set Levels = 2
end
subsection Fluid
  set Density             = 2
  set Kinematic viscosity = 0.05
  set Body force          = 2*(y*(1-y)+0.1*(1+t)); 0
  set Initial velocity    = y*(1-y); 0
  set Inflow velocity     = (1+t)*y*(1-y); 0
  set Exact solution      = (1+t)*y*(1-y); 0; 0
  subsection Boundary conditions
    set left  = inflow
    set right = outflow
  end
end
subsection Refinement
  set Level expression = if(y < 0.5, 1, 0)
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END_OF_FILE
caudal channel.prm
check "velocity error" "$(last "velocity error" results/statistics.txt) < 1e-7"
check "pressure error" "$(last "pressure error" results/statistics.txt) < 1e-6"
exact=$(awk 'BEGIN { t = 0.5; printf "%.12f", 4 * ((t + t^2 / 2) / 30 + 0.1 * ((1 + t)^3 - 1) / 18) + 0.05^2 / 180 }')
ratio=$(awk "BEGIN { printf \"%.9f\", $(last "external work" results/statistics.txt) / $exact }")
check "external work within 1e-6 of the exact one" "($ratio - 1)^2 < 1e-12"
