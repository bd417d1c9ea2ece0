# SPDX-License-Identifier: LGPL-2.1-or-later
# A run is resumed whose files were damaged, moved or lost: what is missing is told, what can be
# rebuilt is rebuilt, and good rows stay.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc
"$CAUDAL" disc.prm -D "Time/End time=0.05" -D "Output/Folder=half" >printed 2>errors || cat errors
cp -r half whole
"$CAUDAL" --resume whole -D "Time/End time=0.1" >printed 2>errors || cat errors

# resume TEXT: resumes the run in results, which the text says something about.
resume() {
  echo "* $1"
  "$CAUDAL" --resume results -D "Time/End time=0.1" >printed 2>errors
  echo "    exit code $?"
  sed 's/^/    /' errors
  grep "^Warning" printed | grep -v Elements | sed 's/^/    /'
  cmp results/statistics.txt whole/statistics.txt >/dev/null && echo "    the same table"
  cmp results/solution.pvd whole/solution.pvd >/dev/null && echo "    the same list of fields"
  [ "$2" = keep ] || new
}

new() {
  rm -rf results
  cp -r half results
}

cp -r half results
resume "nothing is wrong"
rm results/statistics.txt
resume "the table is gone"
: >results/statistics.txt
resume "the table is empty"
sed -i '$ d' results/statistics.txt
resume "the last row is lost, and written again"
sed -i '$ s/.$//' results/statistics.txt
printf 'half a row' >>results/statistics.txt
resume "the last row was cut off"
sed -i '/^ *2.0*e-02/ s/.*/nonsense/' results/statistics.txt
resume "a row in the middle is damaged"
echo "    rows: $(grep -cv '^#' results/statistics.txt)"
rm results/solution.pvd
resume "the list of fields is gone"
rm results/fields/disc-00001.vtu
resume "a file of fields is gone"
rm results/parameters.prm
resume "the parameters are gone"
: >results/parameters.prm
resume "the parameters are emptied"
head -n 40 results/parameters.prm >cut && mv cut results/parameters.prm
resume "the parameters were cut off"
rm results/manifest.txt
resume "the list of what was written is gone"
sed -i 1,5d results/statistics.txt
resume "the head of the table is damaged" keep
echo "    rows that are kept beside it: $(grep -cv '^#' results/statistics-1.txt)"
new
printf 'X' | dd of=results/restart/step-00000005/parameters.prm bs=1 seek=50 conv=notrunc 2>/dev/null
resume "the only checkpoint is damaged"

echo "* the table is emptied while the run writes to it"
rm -rf results
"$CAUDAL" disc.prm -D "Time/End time=1000" >printed 2>errors &
run=$!
while [ "$(cat results/statistics.txt 2>/dev/null | wc -l)" -lt 60 ]; do sleep 0.05; done
: >results/statistics.txt
wait $run
echo "    exit code $?: $(grep ^Error errors)"
