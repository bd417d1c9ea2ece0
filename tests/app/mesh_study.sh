# SPDX-License-Identifier: LGPL-2.1-or-later
# Mesh studies by scripts/sweep --mesh: observed order, limit and error bar of known series, and of
# runs on three grids; a grid that does not change is no proof of anything.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
write_fluid_and_disc
write_salmon

sweep() {
  code=0
  "$CAUDAL_SOURCE_DIR/scripts/sweep" "$@" >printed 2>&1 || code=$?
  grep -v "^$PWD/\|^\[\|=.*: finished\|^[0-9]* running: " printed | sed 's/, [0-9]* at a time//; s/^\([^ ]\)/  \1/'
  echo "  exit code $code"
}

/usr/bin/python3 - <<'END'
import os
import sys

sys.path.insert(0, os.environ["CAUDAL_SOURCE_DIR"] + "/scripts")
import caudal_setup  # noqa: F401
from caudal_sweep import mesh

# 1 + h^p on unequal grids: the order is p, the limit 1, and with an order of 2 at most the bar holds it.
for p in (1., 2., 3.5):
    h = [4., 2., 1.]
    order, limit, bar, remark = mesh.judge(h, [1 + 0.01 * x**p for x in h])
    print(f"  order {order:.2f}, limit {limit:.4f}, bar {bar:.4f} >= 0.01", remark)
order, limit, bar, remark = mesh.judge([3., 2., 1.], [1 + 0.01 * x**2 for x in (3., 2., 1.)])
print(f"  order {order:.2f}, limit {limit:.4f} on unequal grids")
print("  ", *mesh.judge([4., 2., 1.], [1., 1.2, 1.1])[2:])
END
sweep salmon.prm --mesh --folder grids --no-pages -D "Time/End time=0.2" --figures "distance" \
  -D "Body fish/Gait/Frequency=5" | sed 's/±.*cm/± BAR cm/'
sweep disc.prm --mesh --grids=-1,0,1 --folder disc --figures "kinetic energy,iterations" \
  -D "Time/End time=0.05" -D "Body disc/Shape/Elements=6,4" | sed 's/±.*J/± BAR J/'
# The grid of a fluid without a body and without refinement is the coarsest one.
sweep fluid.prm --mesh --grids=-1,0,1 --folder fluid --no-pages --figures "kinetic energy" \
  -D "Refinement/Vorticity threshold=0" -D "Time/End time=0.05" -D "Time/Adaptive=false"
# What is doubtful of each grid is known before it is run.
sweep disc.prm --mesh --grids=-1,0,1 --folder dry --dry-run -D "Time/End time=0.05" -D "Body disc/Shape/Elements=6,4" |
  grep -v "Time: about" | cut -c 1-110
head -n 1 disc/mesh.csv
grep -c "Grid convergence" disc/report.html
