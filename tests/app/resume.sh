# SPDX-License-Identifier: LGPL-2.1-or-later
# A run that is stopped by a signal or by its wall time goes on as if it had not been; changed
# parameters; another number of ranks; damaged checkpoints.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc
write_salmon

echo "* a checkpoint after each step, or none"
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=1" >printed 2>errors || cat errors
cp results/statistics.txt often.txt
"$CAUDAL" disc.prm >printed 2>errors || cat errors
cp results/statistics.txt whole.txt
cmp often.txt whole.txt && echo "the same statistics"

echo "* stopped by the wall time, by a signal, and resumed"
sed -n 's/.*file="\(.*\)".*/\1/p' results/solution.pvd >whole_fields.txt
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=5" -D "Checkpoint/Wall time limit=1e-9" >printed 2>errors
echo "exit code $?, $(grep -o 'Stopped by Checkpoint/Wall time limit' printed)"
"$CAUDAL" --resume results -D "Checkpoint/Wall time limit=0" >printed 2>errors || cat errors
grep "Changed" printed
cmp results/statistics.txt whole.txt && echo "the same statistics"
rm -r results
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=5" -D "Time/End time=1000" >printed 2>errors &
run=$!
# Older checkpoints are removed meanwhile: any newer one will do.
newest() { ls results/restart 2>/dev/null | sed -n '$ s/step-0*//p'; }
while ! [ "0$(newest)" -ge 25 ]; do sleep 0.1; done
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

echo "* two ranks lost a part of their newest checkpoint; three go on with the one before"
mpirun -np 2 "$CAUDAL" disc.prm -D "Output/Folder=two" -D "Checkpoint/Interval of steps=5" \
  -D "Time/End time=0.2" >printed 2>errors || cat errors
ls two/restart/*
rm two/restart/step-00000020/part-00001
mpirun -np 3 --oversubscribe "$CAUDAL" --resume two >printed 2>errors || cat errors
grep -h "skipped\|Resumed" printed
check "the same place" "($(x two/statistics.txt) - $(x whole.txt))^2 < 1e-7^2"

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

echo "* the salmon, in the second swim, in the first one, and beyond its end"
# swim FOLDER OPTIONS: with all checkpoints.
swim() {
  folder=$1
  shift
  caudal salmon.prm -D "Output/Folder=$folder" -D "Checkpoint/Interval of steps=1" \
    -D "Checkpoint/Slots=20" "$@"
}
# compare FOLDER: with the whole run.
compare() {
  for file in statistics_2.5Hz.txt statistics_5Hz.txt summary.txt summary.csv summary.json solution.pvd; do
    cmp "$1/$file" "whole/$file" || return
  done
  echo "the same tables, summary and fields"
}
swim whole
ls whole/restart
for last in 5 2; do
  rm -rf salmon
  cp -r whole salmon
  for slot in salmon/restart/*; do [ "${slot#*step-}" -le 0000000$last ] || rm -r "$slot"; done
  "$CAUDAL" --resume salmon >printed 2>errors || cat errors
  grep -h "Resumed" printed
  compare salmon
done
swim longer -D "Time/End time=0.8"
caudal --resume salmon -D "Time/End time=0.8"
for file in statistics_2.5Hz.txt statistics_5Hz.txt summary.csv; do
  cmp salmon/$file longer/$file && echo "the same $file as of a run that was planned longer"
done

echo "* the salmon, stopped by the wall time, by a signal, and resumed"
"$CAUDAL" salmon.prm -D "Output/Folder=salmon" -D "Checkpoint/Wall time limit=1e-9" >printed 2>errors
echo "exit code $?, $(grep -o 'Stopped by Checkpoint/Wall time limit' printed)"
ls salmon/restart salmon | grep "step\|summary"
"$CAUDAL" --resume salmon -D "Checkpoint/Wall time limit=0" >printed 2>errors || cat errors
compare salmon
rm -r salmon
"$CAUDAL" salmon.prm -D "Output/Folder=salmon" -D "Time/End time=1e5" -D "Checkpoint/Interval of steps=10" >printed 2>errors &
run=$!
while ! [ -e salmon/restart ]; do sleep 0.1; done
kill -TERM $run
wait $run
echo "exit code $?, $(grep -o 'Stopped on request' printed)"
refuse_resume salmon -D "Gait/Frequency=3" -D "Surface/Cells along=3" -D "Integration/Tolerance=1e-8"
