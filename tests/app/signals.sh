# SPDX-License-Identifier: LGPL-2.1-or-later
# Whatever asks a run to end, users, terminals, pipes or batch systems: the step is finished, there
# is a checkpoint, and the exit code is 2.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc

for signal in INT TERM HUP QUIT USR1 USR2 XCPU PIPE; do
  rm -rf results
  # A shell's background command ignores SIGINT and SIGQUIT, unless job control is on.
  set -m 2>/dev/null
  "$CAUDAL" disc.prm -D "Time/End time=1000" >printed 2>errors &
  run=$!
  set +m
  while [ "$(cat results/statistics.txt 2>/dev/null | wc -l)" -lt 60 ]; do sleep 0.05; done
  kill -$signal $run
  wait $run
  echo "SIG$signal: exit code $?, $(ls results/restart | grep -c step) checkpoint"
done

for signal in USR1 USR2; do
  rm -rf results
  mpirun -np 2 "$CAUDAL" disc.prm -D "Time/End time=1000" >printed 2>errors &
  run=$!
  while [ "$(cat results/statistics.txt 2>/dev/null | wc -l)" -lt 60 ]; do sleep 0.05; done
  kill -$signal $run
  wait $run
  echo "SIG$signal to mpirun: exit code $?, $(ls results/restart | grep -c step) checkpoint"
done

# nohup, as one who leaves asks for it: the run goes on, and SIGTERM ends it.
rm -rf results
nohup "$CAUDAL" disc.prm -D "Time/End time=1000" >printed 2>errors &
run=$!
while [ "$(cat results/statistics.txt 2>/dev/null | wc -l)" -lt 60 ]; do sleep 0.05; done
kill -HUP $run
sleep 1
kill -TERM $run && echo "nohup: it goes on"
wait $run
echo "then exit code $?"

# What only prints ends quietly when nobody reads on.
"$CAUDAL" --print-parameters disc.prm 2>errors | true
cat errors
"$CAUDAL" --check --fast disc.prm 2>errors | true
cat errors
