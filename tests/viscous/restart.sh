# A run that is stopped by a signal, whenever, and resumed, again and again, is bit by bit the run
# that nobody disturbed, which writes no checkpoint before its end: on one rank and on two, with
# factorisations that are reused and a grid that changes.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >swim.prm <<END
include $CAUDAL_SOURCE_DIR/tests/viscous/fish.prm
subsection Time
  set End time = 0.6
end
subsection Output
  subsection Figures
    set Print =
  end
end
END

# disturb SIGNAL PROGRAM...: runs, stops by the signal and resumes until the end. A run that was
# stopped ends with 2.
disturb() {
  signal=$1
  shift
  n_stops=0
  rm -rf results
  "$@" swim.prm >printed 2>errors &
  while :; do
    # What it says, it says after it listens.
    while ! [ -s printed ] && kill -0 $! 2>/dev/null; do sleep 0.05; done
    sleep "0.$(($$ * (n_stops + 3) % 5 + 2))"
    kill -"$signal" $! 2>/dev/null
    wait $!
    code=$?
    [ $code -eq 2 ] || break
    n_stops=$((n_stops + 1))
    "$@" --resume results >printed 2>errors &
  done
  [ $code -eq 0 ] || cat errors
  [ $n_stops -gt 1 ] || echo "stopped $n_stops times only"
  echo "exit code $code"
}

# compare NAME: with the undisturbed run
compare() {
  cmp whole/statistics.txt results/statistics.txt && echo "$1: the same bytes"
}

"$CAUDAL" swim.prm -D "Output/Folder=whole" -D "Checkpoint/Interval of wall time=1e9" >printed 2>errors || cat errors
disturb TERM "$CAUDAL"
compare "one rank"
# mpirun hands this signal on to its ranks.
mpirun -np 2 "$CAUDAL" swim.prm -D "Output/Folder=whole" -D "Checkpoint/Interval of wall time=1e9" >printed 2>errors ||
  cat errors
disturb USR1 mpirun -np 2 "$CAUDAL"
compare "two ranks"
