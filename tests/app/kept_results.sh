# SPDX-License-Identifier: LGPL-2.1-or-later
# Whatever ends a run, nothing of it is lost: it goes on from its only checkpoint as if nothing had
# been, the list of fields stays whole, and the lock of a dead process hinders nobody. A signal
# before the first step leaves nothing behind.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc
cat >slot.prm <<'END'
include disc.prm
subsection Output
  set Interval of fields = 0.01
end
subsection Checkpoint
  set Slots             = 1
  set Interval of steps = 1
end
END
"$CAUDAL" slot.prm -D "Output/Folder=whole" >printed 2>&1 || cat printed

# run ARGUMENTS: runs the program; its exit code and its errors.
run() {
  "$CAUDAL" "$@" >printed 2>errors
  echo "    exit code $?"
  sed 's/^/    /' errors
}

# rows UNTIL FOLDER: those of its table of statistics until this time.
rows() {
  awk -v until="$1" '!/^#/ && $1 < until + 1e-9' "$2/statistics.txt"
}

# fields UNTIL FOLDER: its list of fields.
fields() {
  sed -n 's/.*timestep="\([^"]*\)".*file="\([^"]*\)".*/\1 \2/p' "$2/solution.pvd" |
    awk -v until="$1" '$1 < until + 1e-9 { print $2 }'
}

# compare UNTIL FOLDER: whether it holds what the run holds that nothing has disturbed.
compare() {
  for what in rows fields; do
    $what "$1" whole >expected
    $what "$1" "$2" | cmp - expected && echo "    the same $(wc -l <expected) $what until $1 s"
  done
  fields "$1" "$2" | (cd "$2" && xargs ls) >/dev/null # complains of files that are missing
}

echo "= one checkpoint"
echo "* stopped by the limit of the wall time, twice, before the first step"
run slot.prm -D "Checkpoint/Wall time limit=1e-9"
cp -r results begun
run --resume results
ls results/restart
run --resume results -D "Checkpoint/Wall time limit=0"
ls results/restart
compare 0.2 results

# Between the moves of the old one out of the way and of the new one to its name
echo "* killed while a checkpoint was written once more"
mv results/restart/step-00000020 results/restart/step-00000020-copy
mkdir results/restart/unfinished
echo "half of it" >results/restart/unfinished/state
run --resume results
ls results/restart
compare 0.2 results
rm -r results

# Later ends of the run change no row before them.
echo "* killed at any time, twice, and stopped by an alarm"
"$CAUDAL" slot.prm -D "Time/End time=1000" >printed 2>&1 &
before=0
for signal in KILL KILL ALRM; do
  run=$!
  while kill -0 $run && ! [ "$(rows 1000 results 2>/dev/null | wc -l)" -ge $((before + 4)) ]; do
    sleep 0.05
  done
  owner="process $run on $(uname -n)"
  [ "$(cat results/lock)" = "$owner" ] && echo "    the lock names process and host"
  kill -$signal $run
  wait $run 2>/dev/null
  echo "    exit code $?"
  if [ $signal = KILL ]; then
    [ "$(cat results/lock)" = "$owner" ] && echo "    the lock is left"
    "$CAUDAL" --resume results >printed 2>&1 &
    before=$(rows 1000 results | wc -l)
  fi
done
ls results/lock 2>/dev/null
ls results/restart | sed 's/step-[0-9]*$/    one checkpoint/'
compare 0.12 results

echo "* locks of processes that are gone, here and on another machine"
for owner in "process 99999999 on $(uname -n)" "process 1 on elsewhere"; do
  rm -rf finished
  cp -r whole finished
  echo "$owner" >finished/lock
  run slot.prm -D "Output/Folder=finished" -D "Time/End time=0.01"
  ls finished/lock finished.1/lock 2>/dev/null
  rm -r finished.1
done

echo "= a file of fields that can't be written"
mkdir begun/fields/fluid-00007.vtu
echo "* a folder has its name"
run --resume begun -D "Checkpoint/Wall time limit=0"
compare 0.06 begun
echo "* and still has it"
run --resume begun
compare 0.06 begun
echo "* and no longer"
rmdir begun/fields/fluid-00007.vtu
run --resume begun
compare 0.2 begun

echo "= a signal before the first step"
# caught PROCESS: whether it has an answer to SIGTERM.
caught() {
  mask=$(sed -n 's/^SigCgt:[[:blank:]]*//p' "/proc/$1/status")
  [ $((0x${mask:-0} & 0x4000)) -ne 0 ]
}
# Such a grid takes some seconds.
"$CAUDAL" fluid.prm -D "Output/Folder=large" -D "Domain/Cells=400, 400" -D "Domain/Levels=1" >printed 2>errors &
run=$!
while kill -0 $run && ! caught $run; do sleep 0.05; done
sleep 0.3
kill -TERM $run
wait $run
echo "    exit code $?"
cat printed errors
[ ! -e large ] || echo "    there is a folder of results"
