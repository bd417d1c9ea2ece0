# SPDX-License-Identifier: LGPL-2.1-or-later
# What can be wrong with a case of the potential model is said in a sentence before anything is
# written.

. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >good.prm <<'PRM'
set Model = potential
subsection Time
  set End time   = 1
  set Step       = 0.1
  set First part = 0
end
subsection Surface
  set Cells along  = 2
  set Cells across = 2
end
subsection Body fish
  subsection Shape
    subsection Stations
      set Table = 0.1, 3e-3, 4e-3; 0.5, 5e-3, 9e-3; 0.9, 1e-3, 8e-3
    end
  end
end
subsection Integration
  set Phases  = 8
  set Torques = false
end
subsection Output
  set Folder             = results
  set Interval of fields = 1
end
PRM

override "Model" sailing
printf 'include good.prm\nsubsection Body fish\n  subsection Gait\n    set Frequenzy = 3\n  end\nend\n' >unknown.prm
refuse "an unknown entry" unknown.prm
override "Body fish/Gait/Type" carling
override "Body fish/Gait/Frequency" 0
override "Body fish/Gait/Frequency" "1, -2"
override "Body fish/Gait/Bias" 60
override "Fluid/Density" 0
override "Body fish/Density" -1
override "Time/End time" 0
override "Time/Step" -1
override "Integration/Tolerance" 0
override "Resistance/Cross-flow coefficient" -1
override "Surface/Cells along" 0
override "Surface/Cells across" 100

override "Body fish/Shape/Length" -0.1
override "Body fish/Shape/Stations/Table" ""
override "Body fish/Shape/Stations/Table" "0.1, 3e-3, 4e-3; 0.9, 1e-3, 8e-3"
override "Body fish/Shape/Stations/Table" "0.1, 3e-3, 4e-3; 0.9, 1e-3, 8e-3; 0.5, 5e-3, 9e-3"
override "Body fish/Shape/Stations/Table" "0.1, 3e-3, 4e-3; 0.5, 0, 9e-3; 0.9, 1e-3, 8e-3"
override "Body fish/Shape/Stations/Table" "0, 3e-3, 4e-3; 0.5, 1e-3, 9e-3; 0.9, 1e-3, 8e-3"
override "Body fish/Shape/Stations/Table" "0.1, 3e-3; 0.5, 1e-3, 9e-3; 0.9, 1e-3, 8e-3"
override "Body fish/Shape/Stations/Table" "0.1, 3e-3, nan; 0.5, 1e-3, 9e-3; 0.9, 1e-3, 8e-3"
refuse "two tables of stations" good.prm -D "Body fish/Shape/Stations/File=stations.csv"
refuse "stations that are not there" good.prm -D "Body fish/Shape/Stations/Table=" -D "Body fish/Shape/Stations/File=none.csv"
printf 's,a,b\n0.1,3e-3,4e-3\n0.5,5e-3,\n0.9,1e-3,8e-3\n' >stations.csv
refuse "stations with a gap" good.prm -D "Body fish/Shape/Stations/Table=" -D "Body fish/Shape/Stations/File=stations.csv"
refuse "an ellipsoid without width" good.prm -D "Body fish/Shape/Type=ellipsoid" -D "Body fish/Shape/Ellipsoid/Axes=1, 0, 1"
refuse "a body that is too wide for its bend" good.prm \
  -D "Body fish/Shape/Stations/Table=0.1, 3e-3, 4e-3; 0.5, 30e-3, 9e-3; 0.9, 1e-3, 8e-3"

# table NAME ROWS: with these rows after four good ones.
table() {
  { printf 'time,1,2,3,4,5,6\n0,0,0,0,0,0,0\n1,5,5,5,5,5,5\n2,0,0,0,0,0,0\n3,-5,-5,-5,-5,-5,-5\n'
    printf "$2"; } >control.csv
  refuse "$1" good.prm -D "Body fish/Gait/Type=table" -D "Body fish/Gait/Table/File=control.csv"
}
refuse "a control file that is not there" good.prm -D "Body fish/Gait/Type=table"
table "a control file with NaN" '4,nan,0,0,0,0,0\n'
table "a control file with decreasing times" '2.5,0,0,0,0,0,0\n'
table "a control file with a missing entry" '4,0,0,0,0,0\n'
table "a control file with a gap" '40,0,0,0,0,0,0\n'
table "a control file that is not periodic" '4,1,0,0,0,0,0\n'
printf '0,0,0,0,0,0,0\n' >control.csv
refuse "a control file with one row" good.prm -D "Body fish/Gait/Type=table" -D "Body fish/Gait/Table/File=control.csv"
printf '0,0,0,0,0,0,0\n.2,5,5,5,5,5,5\n.4,0,0,0,0,0,0\n.5,-5,-5,-5,-5,-5,-5\n' >control.csv
refuse "a control file that is too short" good.prm -D "Body fish/Gait/Type=table" \
  -D "Body fish/Gait/Table/File=control.csv" -D "Body fish/Gait/Table/Periodic=false"

# mesh NAME CELLS: a cube of these.
mesh() {
  { printf '8 %s 0 0 0\n' "$(printf "$2" | wc -l)"
    printf '1 2 -1 -1\n2 4 -1 -1\n3 4 1 -1\n4 2 1 -1\n5 2 -1 1\n6 4 -1 1\n7 4 1 1\n8 2 1 1\n'
    printf "$2"; } >cube.ucd
  refuse "$1" good.prm -D "Body fish/Shape/Type=file" -D "Body fish/Shape/File/Name=cube.ucd" -D "Body fish/Gait/Type=none"
}
refuse "a shape without a mesh" good.prm -D "Body fish/Shape/Type=file"
five='1 0 quad 1 4 3 2\n2 0 quad 5 6 7 8\n3 0 quad 1 2 6 5\n4 0 quad 3 4 8 7\n5 0 quad 1 5 8 4\n'
mesh "an open mesh" "$five"
mesh "a mesh inverted in a part" "${five}6 0 quad 2 6 7 3\n"
mesh "an inverted mesh" '1 0 quad 1 2 3 4\n2 0 quad 5 8 7 6\n3 0 quad 1 5 6 2\n4 0 quad 3 7 8 4\n5 0 quad 1 4 8 5\n6 0 quad 2 6 7 3\n'
echo "no mesh" >cube.ucd
refuse "no mesh at all" good.prm -D "Body fish/Shape/Type=file" -D "Body fish/Shape/File/Name=cube.ucd"

echo "* a mesh without a shape is told"
"$CAUDAL" --check good.prm -D "Body fish/Shape/File/Name=cube.ucd" | grep cube.ucd

echo "* a reciprocal stroke is allowed, and the log says that it can't swim"
"$CAUDAL" --check good.prm -D "Body fish/Gait/Wave number=0" | sed -n '/^Warning/,$p'
