# SPDX-License-Identifier: LGPL-2.1-or-later
# What --check and the start tell of a case that can be run: how fast and how thick it is for the
# grid, what bends more than it should, what has no effect, how much of the losses is numerical;
# and which cells fit if those that were given don't.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >strip.prm <<'END'
set Bodies = strip
subsection Time
  set End time = 0.02
  set Step     = 0.01
end
subsection Domain
  set Size   = 2, 1
  set Cells  = 4, 2
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-2
end
subsection Body strip
  subsection Shape
    set Type      = rectangle
    set Length    = 0.5
    set Thickness = 0.2
    set Elements  = 4, 2
    set Position  = 1, 0.5
  end
end
END
cat >fish.prm <<'END'
set Bodies = fish
subsection Time
  set End time = 0.06
  set Step     = 0.005
end
subsection Domain
  set Size   = 4, 2
  set Cells  = 8, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 1000
  set Kinematic viscosity = 1e-6
end
subsection Body fish
  set Regions = head, tail
  subsection Shape
    set Type              = naca
    set Elements          = 12, 4
    set Position          = 1.5, 1
    set Region boundaries = 0.5
    subsection Naca
      set Digits = 0024
    end
  end
  subsection Muscle
    set Type    = bang-bang
    set Regions = tail
    subsection Bang-bang
      set Maximum force density = 1e5
      set Switching position    = 0.02
    end
  end
end
subsection Output
  set Folder = results
end
END

# tell TEXT PATTERN ARGUMENTS: the lines of --check that have the pattern, from there on.
tell() {
  echo "* $1"
  pattern=$2
  shift 2
  "$CAUDAL" --check --fast "$@" >printed 2>&1
  sed -n "s/^Error/    &/p; s/.*\($pattern\)/    \1/p" printed
}

echo "= the flow"
tell "an inflow" "Flow:" strip.prm -D "Fluid/Inflow velocity=1; 0" -D "Fluid/Boundary conditions/left=inflow" \
  -D "Fluid/Boundary conditions/right=outflow"
tell "nothing that moves" "Flow:" strip.prm
tell "a fish that decides itself when its tail turns" "Flow:" "$CAUDAL_SOURCE_DIR/prm/fish.prm"
echo "* the gait of a fish with a muscle"
"$CAUDAL" --check --fast fish.prm -D "Body fish/Gait/Type=travelling wave" >printed 2>&1
grep "^Flow\|Muscle" printed | sed 's/^/    /'

echo "= most of the losses are numerical"
"$CAUDAL" fish.prm >printed 2>errors || cat errors
grep "boundary layer\|numerical part" results/log.txt | sed 's/is 0.99[0-9]* of/is 0.99... of/; s/^/    /'
rm -r results

echo "= a material that is stiffer in a fluid"
region="Body strip/Region body"
set -- strip.prm -D "$region/Material=St. Venant-Kirchhoff"
for ratio in 0.3 0.499; do
  tell "a Poisson ratio of $ratio" "resists bending.*times" "$@" -D "$region/Poisson ratio=$ratio" |
    sed 's/times.*/times/'
done
tell "0.3 of a real material" "resists" "$@" -D "$region/Poisson ratio=0.3" \
  -D "$region/St Venant-Kirchhoff/Keep bending stiffness=true"

echo "= thickness"
shape="Body strip/Shape"
tell "a strip" "thickness of" strip.prm
tell "slanted" "thickness of" strip.prm -D "$shape/Rotation=30"
tell "given by its corners" "thickness of" strip.prm -D "$shape/Type=quadrilateral" \
  -D "$shape/Quadrilateral/Vertices=0, 0; 0.4, 0.3; 0.28, 0.46; -0.12, 0.16"
tell "a wide body" "thickness of" strip.prm -D "$shape/Length=0.15" -D "$shape/Thickness=0.6"
tell "a strip of 0.1 cm" "thickness of" strip.prm -D "$shape/Thickness=0.001"
for cells in "4, 4" "8, 2"; do
  tell "in cells that are not square, $cells" "thickness of" strip.prm -D "Domain/Cells=$cells"
  tell "slanted" "thickness of" strip.prm -D "Domain/Cells=$cells" -D "$shape/Rotation=30"
done
cat >box.prm <<'END'
set Dimension = 3
set Bodies    = box
subsection Domain
  set Lower corner = 0, 0, 0
  set Size         = 2, 1, 1
  set Cells        = 2, 1, 1
  set Levels       = 2
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-2
end
subsection Body box
  subsection Shape
    set Type      = rectangle
    set Length    = 0.5
    set Thickness = 0.3
    set Width     = 0.2
    set Elements  = 2, 1, 1
    set Position  = 1, 0.5, 0.5
    set Rotation  = 30
  end
end
END
tell "a box" "thickness of" box.prm

echo "= cells that don't fit"
for size in "5, 1" "0.3, 1" "2, 8"; do
  refuse "4, 2 in $size m" strip.prm -D "Domain/Size=$size"
  cells=$(sed -n 's/.* Give \([0-9, ]*\)\.$/\1/p' errors)
  tell "$cells" "The case can be run" strip.prm -D "Domain/Size=$size" -D "Domain/Cells=$cells" \
    -D "$shape/Position=0.15, 0.5" -D "$shape/Length=0.1" -D "$shape/Thickness=0.05"
done
