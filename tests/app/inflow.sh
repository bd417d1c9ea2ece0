# An inflow that grows with time accelerates all of the channel, u = 1 + 10 t, and the pressure falls by 10 Pa/m
# from the first step on: also where the grid changes, in steps 4 and 8, since the older velocity keeps its own inflow.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >channel.prm <<'END'
subsection Time
  set End time = 0.1
  set Step     = 0.01
end
subsection Domain
  set Size   = 2, 1
  set Cells  = 4, 2
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.01
  set Initial velocity    = 1; 0
  set Inflow velocity     = 1+10*t; 0
  set Probes              = 0.4, 0.4; 1.4, 0.4
  subsection Boundary conditions
    set left   = inflow
    set right  = outflow
    set bottom = free slip
    set top    = free slip
  end
end
subsection Refinement
  set Interval         = 1
  set Level expression = if(abs(t-0.05)<0.02, if(x<1, 2, 1), 1)
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END

"$CAUDAL" channel.prm >printed 2>&1 || cat printed
column "p at probe 1" results/statistics.txt >first
column "p at probe 2" results/statistics.txt | paste first - | awk '
  { d = $1 - $2 - 10; worst = d * d > worst ? d * d : worst }
  END { print NR " steps, pressure difference right: " (sqrt(worst) < 1e-3 ? "yes" : sqrt(worst)) }'
echo "grids: $(column cells results/statistics.txt | sort -n | uniq | wc -l)"
