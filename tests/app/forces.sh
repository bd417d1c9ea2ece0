# The force on a cylinder in a channel, which starts to flow, by its three accounts.
# The momentum balance has surfaces with and without hanging nodes.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

for ranks in 1 2; do
  mpirun -np $ranks "$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/benchmarks/dfg_2d1.prm" -D "Output/Folder=$ranks" \
    -D "Domain/Cells=22,4" -D "Time/End time=0.6" -D "Time/Step=0.03" \
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
