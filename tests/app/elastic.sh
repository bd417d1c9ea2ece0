# The body without fluid: the equilibrium under its weight against Turek and Hron's
# CSM1, and free vibration, which keeps the energy.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

for case in csm1 csm3; do
  caudal "$CAUDAL_SOURCE_DIR/prm/benchmarks/$case.prm" -D "Output/Folder=$case" \
    -D "Time/End time=0.2" -D "Time/Step=0.02" -D "Body flag/Shape/Elements=24,2"
done

x=$(last "flag: x of point 1" csm1/statistics.txt)
y=$(last "flag: y of point 1" csm1/statistics.txt)
check "CSM1: x of point A" "(1e3 * ($x - 0.6) / -7.187 - 1)^2 < 0.01^2"
check "CSM1: y of point A" "(1e3 * ($y - 0.2) / -66.10 - 1)^2 < 0.01^2"

work=$(last "flag: work of gravity" csm3/statistics.txt)
kinetic=$(last "flag: kinetic energy" csm3/statistics.txt)
elastic=$(last "flag: elastic energy" csm3/statistics.txt)
check "CSM3: the flag moves" "$kinetic > 0.1 * $work"
check "CSM3: the energy is kept" "(($kinetic + $elastic) / $work - 1)^2 < 0.001^2"

! "$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/benchmarks/csm1.prm" -D "Body flag/Density=0" 2>&1 >/dev/null
for option in --resume --verify-restart; do
  [ $option = --resume ] && case=csm1 || case="$CAUDAL_SOURCE_DIR/prm/benchmarks/csm1.prm"
  ! "$CAUDAL" $option "$case" 2>&1 >/dev/null
done
! "$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/benchmarks/csm1.prm" -D "Body flag/Region flag/Feedback damping=1" 2>&1 >/dev/null
! "$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/benchmarks/csm1.prm" -D "Body flag/Region flag/Thin direction=y" 2>&1 >/dev/null
! "$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/benchmarks/csm1.prm" -D "Body flag/Traction=1; 0" 2>&1 >/dev/null
