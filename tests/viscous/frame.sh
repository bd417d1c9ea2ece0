# SPDX-License-Identifier: LGPL-2.1-or-later
# An eel in still water, and the same in a uniform stream on a grid that is carried along: what is
# left of the stream comes from the skew-symmetric form of the convection, in cells that the eel cuts.
# And on a grid that follows it, where other cells are cut.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

# swim NAME STREAM ENTRIES: prints speed over the stream and work.
swim() {
  cat >"$1.prm" <<END
include $CAUDAL_SOURCE_DIR/tests/viscous/eel.prm
subsection Fluid
  set Initial velocity = $2; 0
  set Inflow velocity  = $2; 0
  subsection Boundary conditions
    set left   = inflow
    set right  = inflow
    set bottom = inflow
    set top    = inflow
  end
end
subsection Output
  set Folder = $1
  subsection Figures
    set Print    = last([eel: u of centre of mass] - $2); last([eel: muscle work])
    set Decimals = 9
  end
end
$3
END
  caudal "$1.prm"
  sed -n 's/^.* = \([-0-9.]*\)$/\1/p' caudal.log | tr '\n' ' '
}

read -r speed work < <(swim still 0 "")
read -r carried_speed carried_work < <(swim carried 0.5 "subsection Domain
  set Frame          = moving
  set Frame velocity = 0.5; 0
end")
read -r followed_speed followed_work < <(swim followed 0 "subsection Domain
  set Frame      = eel
  set Frame time = 0.1
end")
check "carried: the same speed within 0.1 %" "($carried_speed / $speed - 1)^2 < 1e-6"
check "carried: the same work within 0.1 %" "($carried_work / $work - 1)^2 < 1e-6"
check "followed: the same speed within 5 %" "($followed_speed / $speed - 1)^2 < 25e-4"
check "followed: the same work within 5 %" "($followed_work / $work - 1)^2 < 25e-4"
check "followed: the grid has moved with it, but for the lag" \
  "$(last 'x of the grid' followed/statistics.txt) / ($(last 'eel: x of centre of mass' followed/statistics.txt) - $(column 'eel: x of centre of mass' followed/statistics.txt | head -1)) > 0.3"
