# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs of the model passage: their files, a batch, the design, profiles in other units, an endurance
# table, the power of a run, drag and acceleration, and what comes out the same by two ways.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

# value NAME FOLDER: of the first row of summary.csv, by the column's name without its unit.
value() {
  /usr/bin/python3 -c '
import csv, sys
header, row = list(csv.reader(open(sys.argv[2] + "/summary.csv")))[:2]
print(float(dict(zip((name.partition(" [")[0] for name in header), row))[sys.argv[1]]))' "$1" "$2"
}

caudal "$CAUDAL_SOURCE_DIR/prm/passage/ramp_batch.prm" -D Output/Folder=ramp
ls ramp
head -n 1 ramp/batch.csv
cut -d, -f 1-3,5,7 ramp/batch.csv | sed 1d
/usr/bin/python3 - <<'PY' && echo "all numbers are finite"
import csv, json, math
facts = json.load(open("ramp/passage.json"))
assert len(facts["verdicts"]) == 2 and all(len(v["bands"]) == 5 for v in facts["verdicts"])
for row in list(csv.reader(open("ramp/summary.csv")))[1:]:
    assert all(math.isfinite(float(cell)) for cell in row)
for row in csv.DictReader(open("ramp/way.csv")):
    assert all(math.isfinite(float(value)) for name, value in row.items() if name != "fish")
PY

# The design is met by what it finds, and not by a little more.
cat >reach.prm <<'PRM'
set Model = passage
subsection Fish
  set Species = Eel
  set Length  = 0.6
end
subsection Passage
  set Type = profile
  subsection Profile
    set Table = 0, 0.6, 0.4; 100, 0.6, 0.4
  end
end
subsection Output
  set Folder           = reach
  set Existing results = replace
end
PRM
caudal reach.prm -D "Design/Solve for=longest reach"
longest=$(value "longest reach" reach)
for factor in 0.999 1.001; do
  caudal reach.prm -D "Passage/Profile/Table=0, 0.6, 0.4; $(echo "$longest $factor" | awk '{ print $1 * $2 }'), 0.6, 0.4"
  echo "a reach of $factor of the longest: $(value "share that passes" reach | awk '{ print ($1 >= 0.875 ? "enough" : "too few") }') pass"
done
caudal reach.prm -D "Design/Solve for=resting distance"
spacing=$(value "resting distance" reach)
check "the resting distance divides the way, and is at most the longest reach" "$spacing <= $longest && (100 / $spacing - int(100 / $spacing + 0.5))^2 < 1e-12"
caudal reach.prm -D "Passage/Rest spacing=$spacing"
check "with it enough fish pass" "$(value "share that passes" reach) >= 0.875"

# The same profile in other units, by other names, from downstream, with words in it.
cat >feet.csv <<'CSV'
River,Station,Q Total,Vel Chnl [ft/s]
(name),(ft),(cfs),(ft/s)
Brook,300,35,4.0
Brook,150,35,3.0
Brook,0,35,3.5
CSV
cat >feet.prm <<'PRM'
include reach.prm
subsection Passage
  subsection Profile
    set Table               =
    set File                = feet.csv
    set Column of distance  = Station
    set Unit of distance    = ft
    set Column of velocity  = vel chnl
    set Unit of velocity    = ft/s
    set Column of discharge = Q Total
    set Unit of discharge   = ft^3/s
    set Rows                = downstream
  end
end
PRM
caudal feet.prm
feet=$(value "fatigue of the median" reach)
caudal reach.prm -D "Passage/Profile/Table=0, 1.0668, 0; 45.72, 0.9144, 0; 91.44, 1.2192, 0"
check "a profile in feet is that in metres" "$feet / $(value "fatigue of the median" reach) - 1 < 1e-12 && $feet / $(value "fatigue of the median" reach) - 1 > -1e-12"

# A table of endurances that is taken from a law is that law between its rows.
/usr/bin/python3 - <<'PY'
print("speed [cm/s],endurance [min]", *(f"{100 * 3.722 * (9.81 * 0.6)**0.5 * (t / (0.6 / 9.81)**0.5)**-0.367:.15g},{t / 60:.15g}"
      for t in (3, 10, 60, 300, 1000, 1800)), sep="\n", file=open("eel.csv", "w"))
PY
caudal reach.prm
law=$(value "fatigue of the median" reach)
caudal reach.prm -D Endurance/Law=table -D Endurance/Table/File=eel.csv -D "Endurance/Table/Unit of speed=cm/s" \
  -D "Endurance/Table/Unit of endurance=min"
check "an endurance table is the law that it is from" "($(value "fatigue of the median" reach) / $law - 1)^2 < 1e-16"

# A constant speed over ground in uniform water is the best speed; half as fast tires more.
caudal reach.prm -D "Strategy/Type=constant ground speed"
check "in uniform water the best ground speed is the best speed" "($(value "fatigue of the median" reach) / $law - 1)^2 < 1e-16"
caudal reach.prm -D "Strategy/Type=constant ground speed" -D "Strategy/Constant ground speed/Speed=0.2"
check "another one tires more" "$(value "fatigue of the median" reach) > $law"

# Where no speed gets it on, it comes to the barrier with the speed that tires least up to there.
caudal reach.prm -D "Strategy/Type=constant ground speed" -D "Passage/Profile/Table=0, 0.6, 0.4; 10, 0.6, 0.4; 10, 0.6, 0.1; 20, 0.6, 0.1" \
  -D "Fish/Minimum depth=0.2"
grep -o "The median fish finds.*" reach/verdict.txt

# One that does not enter has a row of its way, too.
caudal reach.prm -D "Passage/Profile/Table=0, 9, 0.4; 20, 9, 0.4"
head -n 2 reach/way.csv
grep -o "^On the way.*pass\." reach/verdict.txt

# Power: a table of P = 2 U^3, and drag.
printf 'speed,power\n0.5,0.25\n1,2\n' >power.csv
caudal reach.prm -D Energy/Type=table -D Energy/Table/File=power.csv -D "Energy/Table/Meaning=a test"
check "energy is power times time" "($(value "energy of the median" reach) / (2 * (0.6 / 0.633)^3 * 100 / (0.6 / 0.633 - 0.6)) - 1)^2 < 1e-12"
caudal "$CAUDAL_SOURCE_DIR/prm/passage/slot_fishway.prm" -D Output/Folder=slots
grep "energy  \|spends" slots/verdict.txt
caudal "$CAUDAL_SOURCE_DIR/prm/salmon/salmon.prm" -D "Output/Folder=salmon" -D "Time/End time=3" \
  -D "Surface/Cells along=2" -D "Surface/Cells across=2" -D "Output/Interval of fields=3"
caudal reach.prm -D Energy/Type=run -D "Energy/Run/Power curve=salmon"
grep "energy  " reach/verdict.txt
check "a swum fish spends energy" "$(value "energy of the median" reach) > 0"

"$CAUDAL" --check reach.prm | tail -n 1
"$CAUDAL" --print-parameters reach.prm | grep -c "set Solve for"

# What is not known is left blank: the largest velocity of still water, a depth that is not given.
printf 'distance,velocity\n0,0\n100,0\n' >still.csv
sed -e 's/Table = .*/File = still.csv/' reach.prm >still.prm
caudal still.prm -D Output/Folder=still
/usr/bin/python3 - <<'PY'
import csv
row = next(csv.DictReader(open("still/summary.csv")))
print("blank:", ", ".join(name for name, value in row.items() if value == ""))
print("depths:", {row["depth [m]"] for row in csv.DictReader(open("still/way.csv"))})
PY
