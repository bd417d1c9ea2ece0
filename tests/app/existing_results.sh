# SPDX-License-Identifier: LGPL-2.1-or-later
# What a run does with a folder that is not empty: nothing that it has not written is removed, no
# run that can be resumed is set aside, no two runs write to one folder, and names are kept as
# they are given.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc

# run ARGUMENTS: runs the program; its exit code and its error.
run() {
  "$CAUDAL" "$@" >printed 2>errors
  echo "    exit code $?"
  sed 's/^/    /; s/process [0-9]* on [^ ]*\./process ... on .../' errors
}

# list FOLDER: its files but for those of fields and checkpoints, sorted.
list() {
  (cd "$1" && find . -type f ! -path "./fields/*.vtu" ! -path "./restart/step*" | sort | tr '\n' ' ')
  echo
}

last_time() {
  tail -n 1 "$1/statistics.txt" | awk '{ print $1 + 0 }'
}

echo "* an unfinished run is not started again"
"$CAUDAL" disc.prm -D "Checkpoint/Interval of steps=5" -D "Checkpoint/Wall time limit=1e-9" >printed 2>errors
echo "    exit code $?, $(sed -n 1p results/manifest.txt)"
cp -r results before
run disc.prm
diff -r before results && echo "    nothing has changed"

echo "* --resume-or-start goes on with it"
run --resume-or-start disc.prm -D "Time/End time=0.04"
echo "    $(grep -c "^Resumed" printed), at $(last_time results), $(sed -n 1p results/manifest.txt)"
run --resume-or-start disc.prm -D "Time/End time=0.04"
echo "    at $(last_time results)"

echo "* a finished run is kept, refused or replaced"
run disc.prm -D "Time/End time=0.02"
for file in printed results/log.txt; do
  grep "earlier run" $file | sed 's/^/    /'
done
echo "    $(ls -d results*), at $(last_time results) and $(last_time results.1)"
list results.1
run disc.prm -D "Time/End time=0.02" -D "Output/Existing results=refuse"
echo mine >results/notes.txt
echo mine >results/restart/notes.txt
echo mine >results/fields/picture.png
run disc.prm -D "Time/End time=0.01" -D "Output/Existing results=replace"
echo "    $(ls -d results*), at $(last_time results)"
list results
cat results/notes.txt results/restart/notes.txt results/fields/picture.png

echo "* a folder whose name ends with a slash"
run disc.prm -D "Output/Folder=slash/" -D "Time/End time=0.01"
run disc.prm -D "Output/Folder=slash/" -D "Time/End time=0.02"
echo "    $(ls -d slash*), at $(last_time slash) and $(last_time slash.1)"

echo "* the working directory can't be kept as another one"
mkdir here
for i in 1 2; do
  (cd here && "$CAUDAL" ../disc.prm -D Output/Folder=. -D "Time/End time=0.01" >../printed 2>../errors)
  echo "    exit code $?: $(grep ^Error errors)"
done

echo "* an unfinished run is replaced on demand"
"$CAUDAL" --resume results -D "Time/End time=5" -D "Checkpoint/Wall time limit=1e-9" >printed 2>errors
run disc.prm -D "Time/End time=0.02" -D "Output/Existing results=replace"

echo "* a folder of somebody else"
mkdir mine
echo data >mine/statistics.txt
cp results/parameters.prm mine
run disc.prm -D "Output/Folder=mine" -D "Output/Existing results=replace"
cat mine/statistics.txt

echo "* a run that was killed before it had anything to show"
mkdir killed
sed 's/finished/unfinished/' results/manifest.txt >killed/manifest.txt
: >killed/lock
run disc.prm -D "Output/Folder=killed" -D "Time/End time=0.01"

echo "* two runs in one folder"
"$CAUDAL" disc.prm -D "Output/Folder=shared" -D "Time/End time=1000" -D "Checkpoint/Interval of steps=5" >first 2>&1 &
first=$!
while [ "$(cat shared/statistics.txt 2>/dev/null | wc -l)" -lt 60 ]; do sleep 0.05; done
run disc.prm -D "Output/Folder=shared" -D "Output/Existing results=replace"
run --resume shared
kill -TERM $first
wait $first
echo "    the first one: exit code $?; the lock is gone: $([ ! -e shared/lock ] && echo yes || echo no)"

echo "* names as they are given"
for name in "run#1" "run#2" "two  blanks"; do
  run disc.prm -D "Output/Folder=$name" -D "Time/End time=0.02"
  run --resume "$name" -D "Time/End time=0.03"
  echo "    at $(last_time "$name")"
done
ls -d run* two*
run disc.prm -D "Output/Folder=run # 1"
for name in "fish&chips" "a/b" "fish1.5" 'a"b'; do
  run disc.prm -D "Bodies=$name"
done
