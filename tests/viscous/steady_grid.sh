# SPDX-License-Identifier: LGPL-2.1-or-later
# A body that is held leaves the grid alone, also where no cells round it are asked for: each step
# has one preconditioner, and no projection of the velocity onto a new grid.
"$CAUDAL" "$CAUDAL_SOURCE_DIR/prm/benchmarks/ellipsoid.prm" -D Domain/Levels=5 -D "Time/End time=0.01" \
  -D "Body body/Region body/Material=none" -D "Body body/Region body/Motion=fixed" \
  -D "Body body/Region body/Feedback damping=1e9" -D Output/Folder=results >printed 2>errors || cat errors
grep -o "[0-9]* steps in" printed
grep -o "[0-9]* factorisations" printed
