# SPDX-License-Identifier: LGPL-2.1-or-later
# A disk that takes no more: said at once, exit code 1, the last whole checkpoint intact.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >disc.prm <<'EOF'
set Bodies = disc
subsection Time
  set End time = 100
  set Step     = 0.01
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-2
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
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
subsection Checkpoint
  set Interval of steps = 5
end
EOF

# What the run said, without what depends on the moment.
say() {
  sed "s/: <results.\(fields[^>]*\|solution.pvd.tmp\)> can't be written/: a file can't be written/
       s/step [0-9]*/step .../; s/fields.[a-z]*-[0-9]*/fields.../; s/: the folder <results> is gone/: .../
       s/: <results.restart.*No such file or directory/: .../; s/>: No such file or directory/>: .../; s/^/    /
       s/\(<results.restart>: \)\(<results.restart.* \)\{0,1\}\(File exists\|Not a directory\)\. /\1not a folder. /" errors
}

# start OPTIONS: starts the run, waits for its second checkpoint and stops it between two.
start() {
  rm -rf results
  $without_override "$CAUDAL" disc.prm "$@" >printed 2>errors &
  run=$!
  while ! [ -e results/restart ] || [ "$(ls results/restart | tail -n 1)" = step-00000005 ]; do
    kill -0 $run || break
    sleep 0.1
  done
  while kill -STOP $run && sleep 0.1 && [ -e results/restart/unfinished ]; do
    kill -CONT $run
  done
}

# Root may write everywhere, but not without this capability.
without_override=
[ "$(id -u)" -ne 0 ] || ! setpriv --bounding-set -dac_override true ||
  without_override="setpriv --bounding-set -dac_override"

# end: what was said by the run that has ended, and whether it can go on
end() {
  kill -CONT $run
  wait $run
  code=$?
  say
  echo "    exit code $code"
  [ ! -e moved ] || mv moved results
  chmod -R u+w results
  "$CAUDAL" --resume results -D "Time/End time=0.01" >printed 2>errors || cat errors
  grep -o "Resumed from" printed || cat printed
}

# The table of statistics would be, too, where steps are fast.
echo "* no file may be longer than 16 kB any more: a checkpoint is"
start -D "Output/Interval of statistics=1000000"
prlimit --pid $run --fsize=16384
end
echo "* nor the table of statistics"
start -D "Checkpoint/Interval of steps=50"
prlimit --pid $run --fsize=2000
end
echo "* nor a picture of the fields, which are written in each step"
start -D "Output/Interval of fields=0" -D "Output/Interval of statistics=1000000" \
  -D "Checkpoint/Interval of steps=50"
prlimit --pid $run --fsize=4000
end
echo "* the folder of the fields is removed"
start -D "Output/Interval of fields=0"
mv results/fields gone
end
echo "* the folder of the results is removed, long before the next checkpoint"
start -D "Checkpoint/Interval of steps=50"
mv results moved
end
# stop: what was said by the run that has nothing left to go on from
stop() {
  kill -CONT $run
  wait $run
  echo "    exit code $?"
  say
}

echo "* nothing may be written to the folders any more"
mkdir -p closed
chmod a-w closed
if $without_override sh -c '[ ! -w closed ]'; then
  start
  chmod a-w results results/*/
  end
else
  # It can't be taken from this user: nothing to see here.
  sed -n '/^. nothing may/ { n; N; N; p }' "$CAUDAL_SOURCE_DIR/tests/app/disk.expected"
fi
echo "* the folder of the results is removed for good, with few rows of statistics"
start -D "Output/Interval of statistics=1000000"
mv results gone_for_good
rm -r gone_for_good
stop
echo "* the folder of checkpoints becomes a file"
start
mv results/restart kept
touch results/restart
stop
