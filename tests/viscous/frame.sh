# SPDX-License-Identifier: LGPL-2.1-or-later
# An eel in still water, and the same in a uniform stream on a grid that is carried along: where the
# stream does not count, the figures are the same within the solver's tolerance. And on a grid that
# follows it, which moves: the same within what the grid's cells cut differently.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

figures="1e3*last([eel: u of centre of mass] - U); 1e3*last([eel: v of centre of mass]);"
figures="$figures 1e3*last([eel: muscle work]); 1e3*(last([eel: x of centre of mass]) - 0.2*U)"

# swim NAME STREAM ENTRIES: swims in a stream, whose velocity the figures are counted from.
swim() {
  name=$1
  cat >"$name.prm" <<END
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
subsection Solver
  set Tolerance = 1e-11
end
subsection Output
  set Folder = $name
  subsection Figures
    set Print    = $(echo "$figures" | sed "s/U/$2/g")
    set Decimals = $4
  end
end
$3
END
  echo "$name"
  "$CAUDAL" "$name.prm" 2>&1 | sed -n 's/^.* = \([-0-9.]*\)$/  \1/p'
}

swim still 0 "" 4
swim carried 0.5 "subsection Domain
  set Frame          = moving
  set Frame velocity = 0.5; 0
end" 4
swim followed 0 "subsection Domain
  set Frame      = eel
  set Frame time = 0.1
end" 2
