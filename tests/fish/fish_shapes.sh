# SPDX-License-Identifier: LGPL-2.1-or-later
# A fish of elliptic sections, and an ellipsoid, are the same body as a grid in space, as the closed
# surface in an ideal fluid, and, in its middle section, as a plane grid; a gait of joints bends it in
# a viscous fluid, too. What a shape cannot give is said in a sentence.

. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >fish.inc <<'PRM'
set Bodies = salmon
subsection Body salmon
  subsection Shape
    set Type   = stations
    set Length = 0.1
    subsection Stations
      set Table = 0.0714, 2.5e-3, 3.5e-3; 0.2143, 5e-3, 9e-3; 0.3571, 6e-3, 11e-3; 0.5, 5e-3, 9.5e-3; \
                  0.6429, 3.2e-3, 6.5e-3; 0.7857, 1.7e-3, 3.5e-3; 0.9286, 1e-3, 10e-3
    end
    subsection Ellipsoid
      set Axes = 0.05, 0.01, 0.015
    end
  end
  subsection Gait
    set Type = arctangent
  end
end
PRM
cat >plane.prm <<'PRM'
set Dimension = 2
include fish.inc
subsection Domain
  set Size  = 0.3, 0.1
  set Cells = 24, 8
end
subsection Body salmon
  subsection Shape
    set Elements = 40, 10
    set Position = 0.08, 0.05
  end
end
PRM
sed 's/Dimension = 2/Dimension = 3/; s/Size  = .*/Size  = 0.3, 0.1, 0.1/; s/Cells = .*/Cells = 24, 8, 8/
     s/Elements = .*/Elements = 40, 8, 10/; s/Position = .*/Position = 0.08, 0.05, 0.05/' plane.prm >space.prm
printf 'set Model = potential\ninclude fish.inc\n' >ideal.prm

# volume FILE OPTIONS: of the body, in SI units.
volume() { "$CAUDAL" --check "$@" >printed 2>errors || cat errors; grep -o "volume [0-9.e+-]*" printed | head -n 1 | cut -d ' ' -f 2; }
compute_ratio() { awk "BEGIN { printf \"%.4f\", $1 / $2 }"; }
show() { "$CAUDAL" --check --fast "$@" 2>&1 | grep "^Body.*cells,\|^Error" | sed 's/, volume.*//'; }

for type in stations ellipsoid; do
  echo "* $type"
  show plane.prm -D "Body salmon/Shape/Type=$type"
  show space.prm -D "Body salmon/Shape/Type=$type"
  exact=$(volume ideal.prm -D "Body salmon/Shape/Type=$type")
  grid=$(volume space.prm --fast -D "Body salmon/Shape/Type=$type")
  echo "the grid in space has $(compute_ratio "$grid" "$exact") of the surface's volume"
done
area=$(volume plane.prm --fast -D "Body salmon/Shape/Type=ellipsoid")
echo "a plane ellipsoid has $(compute_ratio "$area" 1.5707963e-3) of the ellipse's area"

echo "* what a shape cannot give"
show space.prm -D "Body salmon/Shape/Type=eel"
"$CAUDAL" --check ideal.prm -D "Body salmon/Shape/Type=eel"
show space.prm -D "Body salmon/Shape/Elements=40, 2, 10"
