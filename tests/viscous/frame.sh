# SPDX-License-Identifier: LGPL-2.1-or-later
# An eel in still water, and the same in a uniform stream on a grid that is carried along: what is
# left of the stream comes from the skew-symmetric form of the convection, in cells that the eel cuts.
# And on a grid that follows it, where other cells are cut. Its fields are where it is.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

# swim NAME STREAM ENTRIES: speed over the stream and work, into the file NAME.figures.
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
  sed -n 's/^.* = \([-0-9.]*\)$/\1/p' caudal.log >"$1.figures"
}

# compare NAME PART: whether speed and work are those in still water within this part.
compare() {
  paste still.figures "$1.figures" | while read -r value other; do
    check "$1: within $2" "($other / $value - 1)^2 < $2^2"
  done
}

swim still 0 ""
swim carried 0.5 "subsection Domain
  set Frame          = moving
  set Frame velocity = 0.5; 0
end"
compare carried 0.001
swim followed 0 "subsection Domain
  set Frame      = eel
  set Frame time = 0.1
end"
compare followed 0.05
moved=$(awk "BEGIN { print $(last 'eel: x of centre of mass' followed/statistics.txt) - \
  $(column 'eel: x of centre of mass' followed/statistics.txt | head -n 1) }")
check "the grid comes after the eel" "$(last 'x of the grid' followed/statistics.txt) / ($moved) > 0.3"

# The fields of a grid that has moved are all where it is now: so is the centre of its cells.
PYTHONPATH=$CAUDAL_SOURCE_DIR/python /usr/bin/python3 - <<'END'
import caudal


def get_centre(field):
    return field.areas @ field.points[field.triangles].mean(axis=1) / field.areas.sum()


run = caudal.Run("carried")
first, last = run.times[0], run.times[-1]
way = get_centre(run.read_fluid(last)) - get_centre(run.read_fluid(first))
print(f"the fields have gone as far as was told, times {way[0] / (0.5 * last):.4f}")
END

# Free slip where the grid meets fluid is told: of that side, and of none with another condition.
"$CAUDAL" --check --fast followed.prm -D "Fluid/Boundary conditions/top=free slip" \
  -D "Fluid/Boundary conditions/right=outflow" | grep -o "through a side (.*), free slip"
