# Orders of convergence, against exact solutions of the Navier-Stokes equations:
# in space 3 for the velocity and 2 for the pressure, in time 2.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >common.prm <<'END'
set Dimension = 2
subsection Fluid
  set Density = 2
  subsection Boundary conditions
    set left   = inflow
    set right  = inflow
    set bottom = inflow
    set top    = inflow
  end
end
subsection Output
  set Interval of fields = 1e6
end
END

# Decaying vortices.
cat >taylor_green.prm <<'END'
include common.prm
subsection Time
  set End time = 0.02
  set Step     = 0.001
end
subsection Domain
  set Levels = 2
end
subsection Fluid
  set Kinematic viscosity = 0.02
  set Initial velocity = -sin(2*pi*y); sin(2*pi*x)
  set Inflow velocity  = -sin(2*pi*y)*exp(-0.08*pi^2*t); sin(2*pi*x)*exp(-0.08*pi^2*t)
  set Exact solution   = -sin(2*pi*y)*exp(-0.08*pi^2*t); sin(2*pi*x)*exp(-0.08*pi^2*t); \
                         -2*cos(2*pi*x)*cos(2*pi*y)*exp(-0.16*pi^2*t)
end
END

# Flow behind a row of obstacles, Reynolds number 40, here to its steady state.
cat >kovasznay.prm <<'END'
include common.prm
subsection Time
  set End time = 20
  set Step     = 1
end
subsection Domain
  set Lower corner = -0.5, -0.5
  set Levels       = 2
end
subsection Fluid
  set Kinematic viscosity = 0.025
  set Inflow velocity = 1-exp((20-sqrt(400+4*pi^2))*x)*cos(2*pi*y); \
                        (20-sqrt(400+4*pi^2))/(2*pi)*exp((20-sqrt(400+4*pi^2))*x)*sin(2*pi*y)
  set Exact solution  = 1-exp((20-sqrt(400+4*pi^2))*x)*cos(2*pi*y); \
                        (20-sqrt(400+4*pi^2))/(2*pi)*exp((20-sqrt(400+4*pi^2))*x)*sin(2*pi*y); \
                        -exp(2*(20-sqrt(400+4*pi^2))*x)
end
END

# Vortices that move through all sides while they decay.
cat >moving_vortices.prm <<'END'
include common.prm
subsection Time
  set End time = 0.4
end
subsection Domain
  set Cells  = 20, 20
  set Levels = 1
end
subsection Fluid
  set Kinematic viscosity = 0.02
  set Initial velocity = 1-sin(2*pi*y); sin(2*pi*x)
  set Inflow velocity  = 1-sin(2*pi*y)*exp(-0.08*pi^2*t); sin(2*pi*(x-t))*exp(-0.08*pi^2*t)
  set Exact solution   = 1-sin(2*pi*y)*exp(-0.08*pi^2*t); sin(2*pi*(x-t))*exp(-0.08*pi^2*t); \
                         -2*cos(2*pi*(x-t))*cos(2*pi*y)*exp(-0.16*pi^2*t)
end
END

# add_errors FILE OPTIONS: a run; its errors in velocity and pressure go to `errors`.
add_errors() {
  caudal "$@" -D "Output/Folder=results"
  echo "$(last "velocity error" results/statistics.txt)" \
       "$(last "pressure error" results/statistics.txt)" >>errors
}

# print_orders NAME VELOCITY PRESSURE: whether the last halving has reached these orders.
print_orders() {
  set -- "$@" $(awk '{ u = log(u0 / $1) / log(2); p = log(p0 / $2) / log(2); u0 = $1; p0 = $2 }
                     END { print u, p }' errors)
  check "$1: velocity of order $2" "$4 >= $2 - 0.1"
  check "$1: pressure of order $3" "$5 >= $3 - 0.1"
  rm errors
}

for flow in taylor_green kovasznay; do
  for level in 0 "if(x>0.3,1,0)"; do
    for n in 6 12; do
      add_errors $flow.prm -D "Domain/Cells=$n,$n" -D "Refinement/Level expression=$level"
    done
    print_orders "$flow, levels $level" 3 2
  done
done

for step in 0.04 0.02; do
  add_errors moving_vortices.prm -D "Time/Step=$step" -D "Domain/Cells=24,24"
done
print_orders "semi-implicit" 2 1.5 # its pressure's error in space is not small

# The explicit scheme is stable only where its error in time is smaller than the
# one in space: the order is that of the change of the kinetic energy.
for step in 0.01 0.005 0.0025; do
  add_errors moving_vortices.prm -D "Time/Step=$step" -D "Time/Scheme=explicit" -D "Domain/Cells=8,8"
  last "kinetic energy" results/statistics.txt >>energies
done
check "explicit: kinetic energy of order 2" "$(awk '{ e[NR] = $1 }
  END { print log((e[2] - e[1]) / (e[3] - e[2])) / log(2) }' energies) >= 1.9"
add_errors moving_vortices.prm -D "Time/Step=0.0025" -D "Domain/Cells=8,8"
check "both schemes: the same pressure" \
  "$(tail -n 2 errors | awk '{ p[NR] = $2 } END { print p[1] / p[2] }') < 1.1"
