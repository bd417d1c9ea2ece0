# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs of the potential model: their files and what they say, for one frequency and for two.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >fish.prm <<'PRM'
set Model = potential
subsection Time
  set End time   = 2.2
  set Step       = 0.1
  set First step = 0.05
  set First part = 0.5
end
subsection Surface
  set Cells along  = 3
  set Cells across = 2
end
subsection Body fish
  subsection Shape
    subsection Stations
      set Table = 0.1, 3e-3, 4e-3; 0.5, 5e-3, 9e-3; 0.9, 1e-3, 8e-3
    end
  end
  subsection Gait
    set Frequency = 1
  end
end
subsection Integration
  set Phases = 24
end
subsection Output
  set Folder             = fish
  set Interval of fields = 1
end
PRM

caudal fish.prm
check "rows of the schedule" "$(column time fish/statistics.txt | wc -l) == 28"
ls fish fish/fields
grep -c "DataSet timestep" fish/solution.pvd
grep -q "no viscous drag" fish/summary.txt && grep -q "no viscous drag" fish/log.txt && echo "the ideal fluid is explained"
/usr/bin/python3 - <<'PY' && echo "the summary for programs is the same table"
import csv, json
table = list(csv.reader(open("fish/summary.csv")))
summary = json.load(open("fish/summary.json"))
names = [f"{name} [{entry['unit']}]" for name, entry in summary["quantities"].items()]
assert names == table[0] and "no viscous drag" in summary["note"]
assert [list(swim.values()) for swim in summary["swims"]] == [list(map(float, row)) for row in table[1:]]
assert 0.0999 < summary["constants"]["length"]["value"] < 0.1001
PY
caudal fish.prm -D "Output/Folder=two" -D "Body fish/Gait/Frequency=1, 2"
ls two

"$CAUDAL" --check fish.prm -D "Body fish/Linear impulse=-1e-4, 0, 0" | grep -q "take several times as long" &&
  echo "the cost of torques of a pushed fish is told"

# The sections and entries of earlier versions, before bodies had names.
cat >former.prm <<'PRM'
include fish.prm
subsection Shape
  set Type          = stations
  set Interpolation = limited
end
subsection Gait
  set Type      = sine
  set Amplitude = 20
end
subsection Body
  set Density = 1100
end
PRM
"$CAUDAL" --check former.prm | grep "is now called"
caudal former.prm -D "Output/Folder=former" -D "Integration/Torques=false"
caudal fish.prm -D "Output/Folder=present" -D "Integration/Torques=false" -D "Body fish/Density=1100" \
  -D "Body fish/Gait/Type=sine" -D "Body fish/Gait/Sine/Amplitude=20"
cmp former/statistics.txt present/statistics.txt && echo "former names of entries mean the same"

"$CAUDAL" --print-parameters fish.prm | grep -q "set Cells across" && echo "its own parameters are printed"

# A motion that can't go on: its last state is kept.
"$CAUDAL" fish.prm -D "Output/Folder=stiff" -D "Integration/Method=brute force" -D "Time/End time=1" \
  -D Resistance/Active=true -D "Resistance/Friction coefficient=1e9" 2>errors >printed
echo "exit code $?: $(sed 's/[0-9][0-9.]* s\b/... s/g' errors)"
ls stiff/restart
