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

resume() {
  "$CAUDAL" --resume results -D "Time/End time=0.01" >printed 2>errors || cat errors
  grep -o "Resumed from" printed
}

# end TEXT FILES: what was said by the run that has ended
say() {
  sed 's/step [0-9]*/step .../; s/^/    /' errors | grep Error
  echo "    exit code $1"
}

echo "* files may have 64 kB only: no checkpoint"
(ulimit -f 64; "$CAUDAL" disc.prm >printed 2>errors; say $?)
echo "* the table of statistics exceeds the size"
"$CAUDAL" disc.prm -D "Time/End time=0.1" >printed 2>errors || cat errors
(ulimit -f 256; "$CAUDAL" --resume results -D "Time/End time=1000" -D "Checkpoint/Interval of steps=100" \
  >printed 2>errors; say $?)
resume
echo "* fields on every step, and the folder of fields is removed"
"$CAUDAL" disc.prm -D "Output/Interval of fields=0" >printed 2>errors &
run=$!
while ! [ -e results/restart/step-00000010 ]; do sleep 0.1; done
rm -r results/fields
wait $run
say $?
resume
echo "* the folder of results is removed"
"$CAUDAL" disc.prm >printed 2>errors &
run=$!
while ! [ -e results/restart/step-00000010 ]; do sleep 0.1; done
mv results moved
wait $run
say $?
mv moved results
resume
