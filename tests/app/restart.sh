# A resumed run is the one that was not interrupted, bit by bit; signals, the wall-time limit
# and changed parameters; another number of ranks; damaged checkpoints.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >fluid.prm <<'EOF'
subsection Time
  set End time     = 0.2
  set Step         = 0.01
  set Adaptive     = true
  set Largest step = 0.02
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-3
  set Initial velocity    = sin(pi*x)^2*sin(2*pi*y); -sin(2*pi*x)*sin(pi*y)^2
end
subsection Refinement
  set Interval            = 3
  set Vorticity threshold = 0.2
end
subsection Output
  set Folder             = results
  set Interval of fields = 0.05
end
EOF

cat >disc.prm <<'EOF'
include fluid.prm
set Bodies = disc
subsection Time
  set Adaptive = false
end
subsection Body disc
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.6, 0.5
  end
  subsection Region body
    set Young's modulus = 3
  end
end
EOF

cat >fish.prm <<EOF
include $CAUDAL_SOURCE_DIR/prm/fish.prm
subsection Time
  set Step = 0.004
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
      set Switching position    = 0.001
    end
  end
end
subsection Refinement
  set Interval         = 3
  set Vorticity levels = 3
end
subsection Output
  set Folder = results
end
EOF

cat >school.prm <<EOF
include $CAUDAL_SOURCE_DIR/prm/school.prm
subsection Time
  set Step = 0.004
end
subsection Domain
  set Size   = 4, 2
  set Cells  = 8, 4
  set Levels = 4
end
subsection Body fish
  subsection Shape
    set Elements = 40, 4
    set Position = 0.7, 1
  end
end
subsection Body follower
  subsection Shape
    set Elements = 40, 4
    set Position = 2.2, 1
  end
  subsection Controller
    set Type = heading
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Refinement
  set Interval         = 4
  set Vorticity levels = 3
end
subsection Output
  set Folder = results
  set Format = hdf5
end
EOF

# verify TEXT ARGUMENTS
verify() {
  echo "* $1"
  shift
  "$CAUDAL" --verify-restart "$@" >printed 2>errors && tail -n 1 printed | grep -o "equal, bit by bit" || cat errors
  mpirun -np 2 "$CAUDAL" --verify-restart "$@" >printed 2>errors &&
    tail -n 1 printed | grep -o "equal, bit by bit" | sed 's/$/, on two ranks/' || cat errors
  rm -rf results.verify
}
verify "only fluid" fluid.prm
verify "only fluid, explicit" fluid.prm -D Time/Scheme=explicit
verify "an elastic disc in a flow" disc.prm
verify "the fish" fish.prm
verify "a school" school.prm

# The same with programs that are stopped: the tables are the same, byte by byte.
echo "* stopped by the wall time, by a signal, and resumed"
steps="-D Checkpoint/Interval\ of\ steps=5"
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=5" >printed 2>errors || cat errors
cp results/statistics.txt whole.txt
sed -n 's/.*file="\(.*\)".*/\1/p' results/solution.pvd >whole_fields.txt
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=5" -D "Checkpoint/Wall time limit=1e-9" >printed 2>errors
echo "exit code $?, $(grep -o 'Stopped by Checkpoint/Wall time limit' printed)"
"$CAUDAL" --resume results -D "Checkpoint/Wall time limit=0" >printed 2>errors || cat errors
grep "Changed" printed
cmp results/statistics.txt whole.txt && echo "the same statistics"
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=5" -D "Time/End time=1000" >printed 2>errors &
run=$!
while ! [ -e results/restart/step-00000010 ]; do sleep 0.1; done
kill -TERM $run
wait $run
echo "exit code $?, $(grep -o 'Stopped on request' printed)"
"$CAUDAL" --resume results -D "Time/End time=0.2" >printed 2>errors || cat errors
echo "exit code $?: it was beyond the new end already"

echo "* killed during its eighth step, the newest checkpoint damaged"
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=5" -D "Time/End time=0.2" >printed 2>errors || cat errors
printf 'X' | dd of=results/restart/step-00000020/state bs=1 seek=500 conv=notrunc 2>/dev/null
echo "1.0e+9 garbage" >>results/statistics.txt
"$CAUDAL" --resume results >printed 2>errors || cat errors
grep -h "skipped\|Resumed" printed
cmp results/statistics.txt whole.txt && echo "the same statistics"
sed -n 's/.*file="\(.*\)".*/\1/p' results/solution.pvd | cmp - whole_fields.txt && echo "the same fields"

echo "* another number of ranks"
rm -r results/restart/step-00000020
mpirun -np 2 "$CAUDAL" --resume results >printed 2>errors || cat errors
x() { column "disc: x of centre of mass" "$1" | tail -n 1; }
check "the same place" "($(x results/statistics.txt) - $(x whole.txt))^2 < 1e-7^2"

echo "* what can't be resumed"
refuse_resume() {
  "$CAUDAL" --resume "$@" >printed 2>errors
  code=$?
  sed 's/^/    /' errors
  echo "    exit code $code"
}
refuse_resume results -D "Domain/Levels=4" -D "Body disc/Shape/Elements=8, 8" -D "Time/Step=0.005"
refuse_resume nothing
mkdir empty
refuse_resume empty
refuse_resume results disc.prm
rm -r results/restart/step-00000020
for slot in results/restart/*; do echo damaged >"$slot/manifest"; done
refuse_resume results
