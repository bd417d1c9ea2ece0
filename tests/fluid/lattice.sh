# The beginning of the lattice flow at Reynolds 1e6: neither blown up nor damped,
# on a grid that follows the vorticity.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
caudal "$CAUDAL_SOURCE_DIR/prm/benchmarks/lattice.prm" -D "Output/Folder=results" \
  -D "Time/End time=0.2" -D "Time/Step=0.02" -D "Output/Interval of fields=1"
check "cells: 500 to 700" "$(last cells results/statistics.txt) > 500 && $(last cells results/statistics.txt) < 700"
check "velocity error below 0.5 %" "$(last "velocity error" results/statistics.txt) / sqrt(0.5) < 0.005"
check "kinetic energy within 2e-4" \
  "$(last "kinetic energy" results/statistics.txt) / 0.25 - 1 < 2e-4 && $(last "kinetic energy" results/statistics.txt) / 0.25 - 1 > -2e-4"
