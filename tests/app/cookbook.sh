# SPDX-License-Identifier: LGPL-2.1-or-later
# The recipes of doc/cookbook: each command that runs or sweeps a case is accepted with its options,
# files and links are there, and short runs of the cheap cases do what the recipes say.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
for folder in prm scripts python; do
  ln -s "$CAUDAL_SOURCE_DIR/$folder" $folder
done
export CAUDAL_RANKS=1

for recipe in "$CAUDAL_SOURCE_DIR"/doc/cookbook/*.md; do
  name=$(basename "$recipe" .md)
  # The commands, those that go on in the next line as one, without what stands behind them.
  sed -n '/^```sh$/,/^```$/{/^```/!p}' "$recipe" | sed -e ':a' -e '/\\$/{N; s/\\\n//; ba}' -e 's/ \{2,\}#.*//' >commands
  sed -n 's|^\(CAUDAL_RANKS=. \)\{0,1\}scripts/swim |"$CAUDAL" --check --fast |p' commands |
    grep -v -e '--resume' | sed 's/--check --fast --check/--check --fast/' >checks
  grep '^scripts/sweep.*--dry-run' commands >>checks
  while read -r command; do
    eval "$command" >printed 2>&1 || { echo "$name: $command"; cat printed; }
  done <checks
  echo "$name: $(wc -l <checks) commands"
  for link in $(sed -n 's/.*](\([^)#]*\)).*/\1/p' "$recipe"); do
    [ -e "$CAUDAL_SOURCE_DIR/doc/cookbook/$link" ] || echo "$name: there is no $link"
  done
done

# Both fluids swim the measured midline and the robot's joints.
for case in midline robot; do
  caudal prm/cookbook/${case}_ideal.prm -D "Output/Folder=ideal_$case" -D "Time/End time=0.9" \
    -D "Surface/Cells along=1" -D "Surface/Cells across=1" -D "Integration/Torques=false" \
    -D "Output/Interval of fields=1"
  place="x of centre of mass"
  before=$(column "$place" ideal_$case/statistics.txt | head -n 1)
  check "$case in an ideal fluid: it swims forward" "$(last "$place" ideal_$case/statistics.txt) < $before"
  caudal prm/cookbook/$case.prm -D "Output/Folder=viscous_$case" -D "Domain/Levels=4" \
    -D "Time/End time=0.02" -D "Time/Step=5e-3" -D "Output/Interval of fields=1"
  check "$case in a viscous fluid: it follows its gait" \
    "$(last "fish: distance from the gait" viscous_$case/statistics.txt) < 0.01"
done

# The mesh from gmsh has its two regions, and its head turns.
caudal prm/cookbook/gmsh.prm -D "Output/Folder=foil" -D "Domain/Levels=4" -D "Time/End time=0.05" \
  -D "Output/Interval of fields=1" -D "Coupling/Accept unresolved bodies=true"
check "the foil's tail has moved" "$(last "foil: y of point 1" foil/statistics.txt) != 0.2"

# The flag: drag by two accounts has one sign.
caudal prm/benchmarks/fsi3_fast.prm -D "Output/Folder=flag" -D "Time/End time=0.02" -D "Time/Step=0.01"
check "drag on the flag" "$(last "flag: force x of the fluid" flag/statistics.txt) > 0"
