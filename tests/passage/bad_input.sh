# SPDX-License-Identifier: LGPL-2.1-or-later
# What can be wrong with a case of the model passage is said in a sentence before anything is
# written; what is beyond the data is answered, but marked.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >good.prm <<'PRM'
set Model = passage
subsection Fish
  set Species = Salmon & Walleye
  set Length  = 0.5
end
subsection Passage
  set Type = profile
  subsection Profile
    set Table = 0, 1, 0.4; 10, 1.2, 0.3
  end
end
subsection Output
  set Folder = results
end
PRM

override "Fish/Species" "Atlantic samon"
override "Fish/Species" "brown bear"
override "Fish/Length" 50
override "Fish/Length" 0
override "Fish/Standard deviation of length" 0.4
override "Fish/Length classes" "0.4, 10; 0.5, -2"
override "Fish/Minimum depth" -0.1
override "Endurance/Law" Brett
override "Endurance/Katopodis-Gervais/Longest duration" 2
refuse "a species that the law does not know" good.prm -D Endurance/Law=Hunter-Mayor
refuse "coefficients of another species" good.prm -D Endurance/Law=Castro-Santos
refuse "no table of endurances" good.prm -D Endurance/Law=table
printf 'speed [m/s],endurance [s]\n1,100\n2,200\n' >endurance.csv
refuse "a fish that swims longer when faster" good.prm -D Endurance/Law=table -D Endurance/Table/File=endurance.csv

override "Passage/Profile/Table" "0, 1, 0.4; 10, 1.2, 0.3; 5, 1, 0.3"
override "Passage/Profile/Table" "0, 1, 0.4; 10, -1.2, 0.3"
override "Passage/Profile/Table" "0, 1, 0.4; 10, 120, 0.3"
override "Passage/Profile/Table" "0, 1, 0.4; 10, 1, -0.3"
override "Passage/Profile/Table" "0, 1, 0.4; 10, 1"
override "Passage/Profile/Table" "0, 1, 0.4; 10, nan, 1"
override "Passage/Profile/Table" "0, 1, 0.4"
override "Passage/Profile/Table" ""
override "Passage/Velocity factor" 0
override "Passage/Drops" "12, 0.3"
override "Passage/Drops" "2, -0.3"
override "Passage/Drops" "2"
override "Passage/Rests" "5, 30"
override "Passage/Rest spacing" -1
refuse "a burst that takes no time" good.prm -D "Strategy/Type=FishXing" -D "Strategy/FishXing/Burst time=0"
override "Design/Share of fish" 90
override "Design/Solve for" "largest slope"

# table NAME ROWS OPTIONS: a profile from a file.
table() {
  printf "$2" >profile.csv
  name=$1
  shift 2
  refuse "$name" good.prm -D Passage/Profile/Table= -D Passage/Profile/File=profile.csv "$@"
}
rm -f profile.csv
refuse "no such file" good.prm -D Passage/Profile/Table= -D Passage/Profile/File=profile.csv
table "no header" '0,1,0.4\n10,1,0.4\n'
table "no column of velocities" 'distance,speed,depth\n0,1,0.4\n10,1,0.4\n'
table "a missing velocity" 'distance,velocity,depth\n0,1,0.4\n10,,0.4\n'
table "a word for a velocity" 'distance,velocity,depth\n0,1,0.4\n10,fast,0.4\n'
table "centimetres a second" 'distance,velocity,depth\n0,100,0.4\n10,120,0.4\n'
table "a unit in the header that the entry contradicts" 'distance,velocity [ft/s],depth\n0,3,0.4\n10,4,0.4\n'
table "a unit that is not known" 'distance,velocity [knots],depth\n0,3,0.4\n10,4,0.4\n'
table "feet in the row of units below the header" 'distance,velocity,depth\n(m),(ft/s),(m)\n0,3,0.4\n10,4,0.4\n'
table "no column of depths of that name" 'distance,velocity,depth\n0,1,0.4\n10,1,0.4\n' -D "Passage/Profile/Column of depth=Hydr Depth"
table "a discharge that changes along the way" 'distance,velocity,discharge\n0,1,2\n20,1,2\n30,1,1\n50,1,1\n'
table "a profile from downstream rows" 'distance,velocity,depth\n10,1,0.4\n0,1.2,0.4\n'
table "depths that nobody knows" 'distance,velocity\n0,1\n10,1.2\n' -D "Fish/Minimum depth=0.2"
table "one place only" 'distance,velocity\n0,1\n'

channel() {
  name=$1
  shift
  refuse "$name" good.prm -D Passage/Type=channel "$@"
}
channel "a slope in per cent" -D Passage/Channel/Slope=2
channel "more water than the pipe carries" -D Passage/Channel/Discharges=10
channel "a drain" -D Passage/Channel/Width=0
printf 'species,length\nsalmon & walleye,0.4\ncarp,0.3\n' >fish.csv
refuse "an unknown fish in a batch" good.prm -D Batch/File=fish.csv
printf 'species,length\nEel,40\n' >fish.csv
refuse "a length in centimetres in a batch" good.prm -D Batch/File=fish.csv
refuse "a power of no run" good.prm -D Energy/Type=run -D "Energy/Run/Power curve=nothing"
"$CAUDAL" --resume results 2>&1 | cut -c1-60
caudal good.prm && "$CAUDAL" --resume results 2>&1
rm -r results

echo "answered, but marked:"
for change in "Fish/Length=1.5" "Passage/Profile/Table=0, 1, 0.4; 10, 3.5, 0.3" "Passage/Profile/Table=0, 0.05, 1; 2000, 0.05, 1"; do
  "$CAUDAL" --check good.prm -D "$change" | sed -n "s|^Warning|  ${change%%=*}: warning|p"
done
"$CAUDAL" --check good.prm -D "Strategy/Type=constant ground speed" -D "Strategy/Constant ground speed/Speed=0.1" \
  -D "Passage/Profile/Table=0, 0.1, 0.4; 10, 0.1, 0.3" | sed -n "s|^Warning|  a slow fish: warning|p"
