# SPDX-License-Identifier: LGPL-2.1-or-later
# Files as users bring them: parameters and tables as editors and spreadsheets write them, meshes
# in millimetres and with names, files that include what they should not, and files that have
# become other ones when a run is resumed.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

# Whoever opens a pipe waits for its other end: a run that does so is ended here.
cat >in_time <<END
#!/bin/sh
exec timeout 60 "$CAUDAL" "\$@"
END
chmod +x in_time
CAUDAL=$PWD/in_time

cat >plain.prm <<'END'
set Bodies = fish
subsection Time
  set End time = 0.02
  set Step     = 0.01
end
subsection Domain
  set Lower corner = -1, -0.5
  set Size         = 2, 1
  set Cells        = 4, 2
  set Levels       = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-2
  set Initial velocity    = 1-4*y^2; 0
end
subsection Body fish
  set Regions = head, tail
  subsection Shape
    set Type              = rectangle
    set Length            = 0.6
    set Thickness         = 0.2
    set Elements          = 4, 2
    set Position          = -0.05, 0.02
    set Region boundaries = 0.5
  end
  subsection Region head
    set Young's modulus = 10
  end
  subsection Region tail
    set Young's modulus = 10
  end
end
subsection Refinement
  set Vorticity threshold     = 0.5
  set Largest number of cells = 10000
end
subsection Output
  set Folder = results
end
END

echo "= files of parameters"
"$CAUDAL" --check --fast plain.prm >plain.txt 2>&1
grep "^Fluid\|^Body.*volume" plain.txt

# compare TEXT FILE: whether this file says the same as the plain one.
compare() {
  "$CAUDAL" --check --fast "$2" >checked.txt 2>&1
  echo "* $1: exit code $?, $(cmp plain.txt checked.txt && echo "the same case")"
}

# as_on_windows: with its byte order mark and its ends of lines.
as_on_windows() {
  printf '\357\273\277'
  awk '{ printf "%s\r\n", $0 }'
}

as_on_windows <plain.prm >windows.prm
compare "a byte order mark and ends of lines of Windows" windows.prm
tr '\n' '\r' <plain.prm >mac.prm
compare "ends of lines of an old Mac" mac.prm
sed "s/ /$(printf '\302\240')/g; s/-/$(printf '\342\210\222')/g" plain.prm >copied.prm
compare "blanks that don't break and Unicode's minus" copied.prm
sed 's/10000/1e4/; s/= 4, 2$/= 4e0, 0.2E+1/; s/= 3$/= 3.0e0/' plain.prm >whole.prm
compare "whole numbers with exponents" whole.prm
awk -v comment="$(printf '# L\344nge')" '/Length/ { $0 = $0 " " comment } 1' plain.prm >latin.prm
refuse "letters in another encoding than UTF-8" latin.prm
sed 's/y^2;/z^2;/' plain.prm >formula.prm
"$CAUDAL" formula.prm >errors 2>&1
echo "* a wrong formula: exit code $?, $(grep -c Error errors) message, $(grep -c . errors) line"
cat errors

echo "= tables of forces"
cat >driven.prm <<'END'
include plain.prm
subsection Body fish
  subsection Shape
    set Type     = beam
    set Position = -0.3, 0.02
  end
  subsection Muscle
    set Type = table
    subsection Table
      set File = force.csv
    end
  end
end
END
cat >force.csv <<'END'
time, 0, 0.5, 1
0, 0, 0, 2e1
0.01, 10, -5, 2.5
1, 0, -1, -2
END
echo "* a plain table"
"$CAUDAL" driven.prm >printed 2>&1 || cat printed
mv results plain
check "the fish is driven upwards" "$(last "fish: v of centre of mass" plain/statistics.txt) > 1e-3"

# drive TEXT FILE: whether this table moves the fish as the plain one does.
drive() {
  echo "* $1"
  "$CAUDAL" driven.prm -D "Body fish/Muscle/Table/File=$2" >printed 2>&1 || cat printed
  cmp results/statistics.txt plain/statistics.txt && echo "    the same run"
  rm -rf results
}

awk -F ', *' '{ print "\"" $1 "\";\"" $2 "\";\"" $3 "\";\"" $4 "\"" }' force.csv >quotes.csv
as_on_windows <quotes.csv >windows.csv
drive "quotes and semicolons, of Windows" windows.csv
{ echo "sep=;"; sed 's/, */;/g; s/$/;/' force.csv; } >ends.csv
drive "a line that names the separator, which ends each row" ends.csv
sed "s/^time/Time [s]/; s/, */;/g; s/-/$(printf '\342\210\222')/g" force.csv | tr '\n' '\r' >mac.csv
drive "a unit in the head and Unicode's minus, of an old Mac" mac.csv

refuse_table() {
  refuse "$1" driven.prm -D "Body fish/Muscle/Table/File=$2"
}
sed 's/, */;/g; s/\./,/g' force.csv >decimal.csv
refuse_table "decimal commas" decimal.csv
sed 's/\./,/g' quotes.csv >decimal_quotes.csv
refuse_table "in quotes" decimal_quotes.csv
sed 's/0.5/fin/' force.csv >word.csv
refuse_table "a column that has no place" word.csv
mkdir folder
refuse_table "a folder" folder

echo "= meshes, and where files are looked for"
mkdir -p case/meshes
cat >case/meshes/body.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 2 "head"
2 1 "tail"
$EndPhysicalNames
$Nodes
15
1 200 -100 0
2 200 0 0
3 200 100 0
4 350 -100 0
5 350 0 0
6 350 100 0
7 500 -100 0
8 500 0 0
9 500 100 0
10 650 -50 0
11 650 0 0
12 650 50 0
13 800 -50 0
14 800 0 0
15 800 50 0
$EndNodes
$Elements
8
2 3 2 2 1 1 4 5 2
3 3 2 2 1 2 5 6 3
4 3 2 2 1 4 7 8 5
5 3 2 2 1 5 8 9 6
6 3 2 1 1 7 10 11 8
7 3 2 1 1 8 11 12 9
8 3 2 1 1 10 13 14 11
9 3 2 1 1 11 14 15 12
$EndElements
END
cat >case/mesh.prm <<'END'
include ../driven.prm
subsection Body fish
  subsection Shape
    set Type              = file
    set Region boundaries =
    subsection File
      set Name  = meshes/body.msh
      set Scale = 0.001
      set Shift = -0.2, 0
    end
  end
  subsection Muscle
    subsection Table
      set File = force.csv
    end
  end
end
END
cp force.csv case
# It is not to be read while there is one beside the file of parameters.
echo "0, nowhere" >force.csv

# show TEXT ARGUMENTS: the size of the body, and the thickness of its regions.
show() {
  echo "* $1"
  shift
  "$CAUDAL" --check --fast case/mesh.prm "$@" 2>&1 | grep "^Error\|^Body.*volume\|thickness of" |
    sed 's/^/    /; s/its nodes are.*apart; //'
}

show "a mesh in millimetres, its nose at 200 mm, the numbers of its groups in another order than regions"
show "the regions in another order" -D "Body fish/Regions=tail, head"
sed 's/"tail"/"fin"/' case/meshes/body.msh >case/meshes/fin.msh
refuse "names that are others" case/mesh.prm -D "Body fish/Shape/File/Name=case/meshes/fin.msh" |
  sed 's/Give Regions.*/.../'
refuse "a nose that is elsewhere" case/mesh.prm -D "Body fish/Shape/File/Shift=0, 0"
mv case/force.csv kept.csv
refuse "the table in the working directory, which is wrong" case/mesh.prm
cp kept.csv force.csv

echo "= other files when a run is resumed"
"$CAUDAL" case/mesh.prm >printed 2>&1 || cat printed

# resume TEXT OPTIONS: what a resumed run says, and whether it leaves the rows as they were.
resume() {
  echo "* $1"
  shift
  cp results/statistics.txt before.txt
  "$CAUDAL" --resume results "$@" >printed 2>errors
  echo "    exit code $?"
  cat printed errors | grep "^Nothing\|^Error\|^  Body.*before, now" | sed 's/^/    /'
  cmp -s results/statistics.txt before.txt && echo "    the same rows"
}
resume "the run has come to its end"
sed 's/2e1/20/' kept.csv >force.csv
resume "another table" -D "Time/End time=0.03"
cp kept.csv force.csv
cp case/meshes/body.msh kept.msh
sed 's/^15 800 50/15 800 49/' kept.msh >case/meshes/body.msh
resume "another mesh" -D "Time/End time=0.03"
cp kept.msh case/meshes/body.msh
resume "both as they were" -D "Time/End time=0.03"
echo "    until $(last time results/statistics.txt)"
rm -r results

echo "= files that are included"
include() {
  echo "include $2" >including.prm
  refuse "$1" including.prm
}
include "a device" /dev/zero
mkfifo pipe
include "a pipe" pipe
include "itself" including.prm
echo "include including.prm" >other.prm
include "one that includes it" other.prm
i=60
cp plain.prm deep$i.prm
while [ $i -gt 1 ]; do
  echo "include deep$i.prm" >deep$((i - 1)).prm
  i=$((i - 1))
done
include "files that include each other too often" deep1.prm
