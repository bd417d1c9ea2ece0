# SPDX-License-Identifier: LGPL-2.1-or-later
# What is refused of slices, surfaces and additional fields; slices in a grid that moves, which are
# where the fluid's fields are; lists of a run that was stopped and resumed, which are those of the
# run that was not.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
write_fluid_and_disc

cat >good.prm <<'END'
include disc.prm
subsection Time
  set End time = 0.06
  set Step     = 0.02
end
subsection Output
  set Additional fields = Q
  subsection Slices
    set Planes   = 0.5, 0.5 : 0, 1
    set Interval = 0
  end
  subsection Surfaces
    set Write    = true
    set Interval = 0.03
  end
end
END

override "Output/Additional fields" "Q, vortices"
override "Output/Slices/Planes" "0.5, 0.5 : 0, 0"
override "Output/Slices/Planes" "0.5, 1.5 : 0, 1"
override "Output/Slices/Planes" "0.5, 0.5, 0.5 : 0, 1, 0"
override "Output/Slices/Interval" "often"
override "Output/Slices/Interval" "-1"
override "Output/Surfaces/Interval" "-1"
override "Output/Surfaces/Distance" "-1"

# list FILE: times and blocks of a list.
list() {
  echo "  $1:" $(sed -n 's/.*timestep="\([^"]*\)" name="\([^"]*\)".*/\2 at \1,/p' $1)
}

echo "* a whole run"
caudal good.prm -D "Output/Folder=whole"
list whole/surfaces.pvd
list whole/slices.pvd
echo "* stopped after two steps and resumed"
caudal good.prm -D "Output/Folder=parts" -D "Time/End time=0.04"
caudal --resume parts -D "Time/End time=0.06"
cmp whole/slices.pvd parts/slices.pvd && echo "  equal slices.pvd"
for file in whole/fields/slice* whole/fields/surface_disc-00001.vtu; do
  cmp "$file" "parts/fields/$(basename "$file")" && echo "  equal $(basename "$file")"
done
echo "* surfaces only since it was resumed"
caudal good.prm -D "Output/Folder=later" -D "Time/End time=0.04" -D "Output/Surfaces/Write=false"
ls later/surfaces.pvd 2>/dev/null
caudal --resume later -D "Time/End time=0.06" -D "Output/Surfaces/Write=true"
list later/surfaces.pvd

echo "* in a grid that moves"
caudal good.prm -D "Output/Folder=moved" -D "Domain/Frame=moving" -D "Domain/Frame velocity=1; 0"
PYTHONPATH=$CAUDAL_SOURCE_DIR/python /usr/bin/python3 - <<'END'
from caudal import fields

for name in ("fluid-00001", "slice_1-00003"):
    bounds = fields.read_grid(__import__("pathlib").Path(f"moved/fields/{name}.vtu")).GetBounds()
    print(f"  {name}:", *(f"{bound:.3f}" for bound in bounds[:4]))
END
