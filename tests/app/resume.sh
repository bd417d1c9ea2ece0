# A run that is stopped by a signal or by its wall time goes on as if it had not been; changed
# parameters; another number of ranks; damaged checkpoints.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc

echo "* stopped by the wall time, by a signal, and resumed"
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

echo "* the newest checkpoint is damaged, and a row was cut off"
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
