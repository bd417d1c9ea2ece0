# The force on a cylinder in a channel, which starts to flow, by its three accounts.
# The momentum balance has surfaces with and without hanging nodes. The grid is coarse, so that
# the stabilisation has to be strong for the cells that the cylinder cuts.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

for ranks in 1 2; do
  mpirun -np $ranks "$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/benchmarks/dfg_2d1.prm" -D "Output/Folder=$ranks" \
    -D "Domain/Cells=22,4" -D "Fluid/Grad-div stabilisation=1" -D "Time/End time=0.6" -D "Time/Step=0.03" \
    -D "Fluid/Control volume=0.05,0.05;0.55,0.36" -D "Body cylinder/Shape/Elements=20,10" \
    -D "Refinement/Level expression=if(x<0.6,if(y<0.2,2,1),1)" -D "Refinement/Vorticity levels=0" \
    >log 2>&1 || cat log
  force=$(last "cylinder: force x of the fluid" $ranks/statistics.txt)
  feedback=$(last "cylinder: force x by feedback" $ranks/statistics.txt)
  volume=$(last "force x by control volume" $ranks/statistics.txt)
  check "$ranks rank(s): by feedback" "($feedback / $force - 1)^2 < 1e-6^2"
  check "$ranks rank(s): by control volume" "($volume / $force - 1)^2 < 0.01^2"
  check "$ranks rank(s): the cylinder stays" "$(last "cylinder: max J" $ranks/statistics.txt) - 1 < 1e-9"
  echo "$force" >>forces
done
set -- $(cat forces)
check "ranks agree" "($1 / $2 - 1)^2 < 1e-5^2"

# An eel that swims: the force on it by two accounts, over a tail beat and in each step. On its
# coarse grid the grid changes, which would show as spikes of a third of the largest force.
"$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/eel.prm" -D "Output/Folder=eel" -D "Output/Interval of fields=100" \
  -D "Domain/Cells=16,8" -D "Body eel/Shape/Elements=32,4" -D "Refinement/Largest number of cells=1250" \
  -D "Fluid/Control volume=1,0.5;7.5,3.5" -D "Time/Step=0.01" -D "Time/End time=1.95" \
  -D "Body eel/Gait/Start-up ramp=0.5" >log 2>&1 || cat log

# mean NAME: the quantity of the first tail beat.
mean() {
  sed -n "/^ *{\"start\"/ s/.*\"$1\": \([^,]*\),.*/\1/p" eel/swim.json | head -n 1
}

momentum=$(mean "momentum rate") body=$(mean "body force") thrust=$(mean "thrust")
check "no force from outside" "($body / $thrust)^2 < 1e-3^2"
check "means by momentum and by control volume" \
  "(($(mean "force by control volume") + $body - $momentum) / $thrust)^2 < 0.005^2"
grep -q "Fvol\[N/m\]" log && echo "the log has it"
column "eel: force x of the fluid" eel/statistics.txt >body
column "force x by control volume" eel/statistics.txt | paste body - | awk '
  NR > 50 { d = $1 - $2; worst = d * d > worst ? d * d : worst; most = $1 * $1 > most ? $1 * $1 : most }
  END { print "no spikes: " (sqrt(worst / most) < 0.02 ? "yes" : sqrt(worst / most)) }'
