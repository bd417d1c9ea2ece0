# SPDX-License-Identifier: LGPL-2.1-or-later
# A run that is stopped by signals and resumed, again and again, is bit by bit the run that nobody
# disturbed, which writes no checkpoint before its end: on one rank and on two, with a grid that
# changes; swim.prm with a muscle and springs and a grid that follows the fish, disc.prm with factorisations that serve several
# steps. It is stopped some steps after each start; which step that is depends on the machine.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >swim.prm <<END
include $CAUDAL_SOURCE_DIR/tests/viscous/fish.prm
subsection Time
  set End time = 0.2
end
subsection Domain
  set Frame = fish
end
subsection Output
  subsection Figures
    set Print =
  end
end
END

write_fluid_and_disc
cat >disc_in_short_steps.prm <<END
include disc.prm
subsection Time
  set Step = 0.002
end
END

count_rows() {
  cat results/statistics.txt 2>/dev/null | grep -cv "^#"
}

# disturb RANKS CASE: runs, stops and resumes until the end. A run that was stopped ends with 2.
disturb() {
  n_stops=0
  ranks=$1
  set -- "$2"
  while :; do
    n_rows=$(count_rows)
    mpirun -np "$ranks" "$CAUDAL" "$@" >printed 2>errors &
    while [ "$(count_rows)" -lt $((n_rows + 3 + 5 * n_stops)) ] && kill -0 $! 2>/dev/null; do
      sleep 0.02
    done
    kill -USR1 $! 2>/dev/null
    wait $!
    code=$?
    [ $code -eq 2 ] || break
    n_stops=$((n_stops + 1))
    set -- --resume results
  done
  [ $code -eq 0 ] || cat errors
  echo "exit code $code, stopped on the way: $([ $n_stops -gt 0 ] && echo yes || echo no)"
}

compare() {
  ranks=$1
  rm -rf results whole
  mpirun -np "$ranks" "$CAUDAL" "$2" -D "Output/Folder=whole" -D "Checkpoint/Interval of wall time=1e9" \
    >printed 2>errors || cat errors
  disturb "$ranks" "$2"
  for file in statistics.txt solution.pvd; do
    cmp whole/$file results/$file && echo "$2, $ranks rank(s), $file: the same bytes"
  done
}

for ranks in 1 2; do
  compare $ranks swim.prm
  compare $ranks disc_in_short_steps.prm
done
awk '/steps in/ { print "factorisations serve several steps: " ($1 > 1.5 * $7 ? "yes" : "no, " $0) }' whole/log.txt
