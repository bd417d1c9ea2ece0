# Runs of the potential model: files and their contents, several frequencies from one table, two
# ranks, brute force, resistance, a control file, a body from a file.
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
result() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } END { print $c }' "$1/summary.csv"; }
/usr/bin/python3 - <<'PY' && echo "the summary for programs is the same table"
import csv, json
table = list(csv.reader(open("fish/summary.csv")))
summary = json.load(open("fish/summary.json"))
names = [f"{name} [{entry['unit']}]" for name, entry in summary["quantities"].items()]
assert names == table[0] and "no viscous drag" in summary["note"]
assert [list(swim.values()) for swim in summary["swims"]] == [list(map(float, row)) for row in table[1:]]
assert 0.0999 < summary["constants"]["length"]["value"] < 0.1001
PY
stroke=$(result fish "displacement a stroke [cm]")
check "it swims" "$stroke > 0.1"
check "distance and strokes agree" "($(result fish "distance [cm]") / 2.2 / $stroke - 1)^2 < 0.05"
check "some power is not returned at once" "$(result fish "mean gross power [W]") > $(result fish "mean positive power [W]")"
check "work of the joints is the energy's change" "($(column power fish/statistics.txt | tail -n 1))^2 < 1e-4"

caudal fish.prm -D "Output/Folder=two" -D "Body fish/Gait/Frequency=1, 2"
ls two
tail -n +2 two/summary.csv | awk -F, '{ printf "%.4f ", $7 / '"$stroke"' } END { print "" }'
ratio() { awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } NR == 2 { first = $c } END { print $c / first }' OFMT=%.12g two/summary.csv; }
check "energy grows with the frequency squared" "($(ratio "mean kinetic energy [J]") - 4)^2 < 1e-12"
check "torques, too" "($(ratio "largest torque of mode 4 [N m]") - 4)^2 < 1e-12"
check "power with its cube" "($(ratio "mean gross power [W]") - 8)^2 + ($(ratio "mean positive power [W]") - 8)^2 < 1e-12"

mpirun -np 2 "$CAUDAL" fish.prm -D "Output/Folder=ranks" >/dev/null
check "two ranks" "($(result ranks "displacement a stroke [cm]") / $stroke - 1)^2 < 1e-16"
caudal fish.prm -D "Output/Folder=brute" -D "Integration/Method=brute force" -D "Integration/Torques=false" -D "Time/Step=0.05"
check "brute force" "($(result brute "displacement a stroke [cm]") / $stroke - 1)^2 < 1e-8"
mpirun -np 2 "$CAUDAL" fish.prm -D "Output/Folder=brute2" -D "Integration/Method=brute force" \
  -D "Integration/Torques=false" -D "Time/Step=0.05" >/dev/null
check "brute force on two ranks" "($(result brute2 "displacement a stroke [cm]") / $(result brute "displacement a stroke [cm]") - 1)^2 < 1e-16"

caudal fish.prm -D "Output/Folder=heavy" -D "Integration/Torques=false" -D "Body fish/Density=2000"
check "a heavier body swims a different distance" "($(result heavy "displacement a stroke [cm]") / $stroke - 1)^2 > 1e-4"
caudal fish.prm -D "Output/Folder=impulse" -D "Integration/Torques=false" -D "Body fish/Linear impulse=-1e-4, 0, 0"
check "a pushed fish is faster" "$(result impulse "distance [cm]") > $(result fish "distance [cm]")"
caudal fish.prm -D "Output/Folder=drag" -D "Integration/Torques=false" -D "Body fish/Linear impulse=-1e-4, 0, 0" \
  -D "Resistance/Active=true" -D "Resistance/Drag coefficient=1" -D "Body fish/Gait/Type=none"
caudal fish.prm -D "Output/Folder=worked" -D "Body fish/Linear impulse=-1e-4, 0, 0" -D "Resistance/Active=true"
grep -q "take several times as long" worked/log.txt && echo "the cost of torques of a pushed fish is told"
check "its joints work more than it gets back" "$(result worked "mean positive power [W]") > $(result fish "mean positive power [W]")"
check "resistance takes impulse" "$(column "x of linear impulse in body frame" drag/statistics.txt | tail -n 1) > -0.9e-4"

awk 'BEGIN { for (k = 0; k <= 12; k++) { printf "%g", k / 10; for (i = 1; i <= 6; i++) printf " %g", 30 * sin(3.14159265 * k / 12) * sin(3.14159265 * (k / 6 - i / 7)); print "" } }' >control.txt
caudal fish.prm -D "Output/Folder=control" -D "Integration/Torques=false" -D "Body fish/Gait/Type=table" \
  -D "Body fish/Gait/Table/File=control.txt" -D "Body fish/Gait/Table/Periodic=false" -D "Time/End time=1.2" -D "Time/First part=0"
check "a C-start moves the fish" "$(result control "distance [cm]") > 0.1"

for bias in 5 -5; do
  caudal fish.prm -D "Output/Folder=bias$bias" -D "Integration/Torques=false" -D "Body fish/Gait/Bias=$bias"
done
turn=$(result bias5 "turn a stroke [degrees]")
check "a biased fish turns" "$turn < -5"
check "to the other side with the other bias" "($turn + $(result bias-5 "turn a stroke [degrees]"))^2 < 1e-8"
radius='radius of the circle (0: straight) [cm]'
check "on a circle of the same size" "($(result bias5 "$radius") / $(result bias-5 "$radius") - 1)^2 < 0.01"

caudal fish.prm -D "Output/Folder=still" -D "Integration/Torques=false" -D "Body fish/Gait/Wave number=0"
check "a reciprocal stroke does not swim" "$(result still "displacement a stroke [cm]") / $stroke < 1e-5"

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
