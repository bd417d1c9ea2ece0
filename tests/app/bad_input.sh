# SPDX-License-Identifier: LGPL-2.1-or-later
# What can be wrong with a case is said in a sentence before anything is written.

. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >good.prm <<'END'
set Bodies = fish
subsection Time
  set End time = 0.02
  set Step     = 0.01
end
subsection Domain
  set Size   = 4, 2
  set Cells  = 8, 4
  set Levels = 3
end
subsection Body fish
  set Regions = head, tail
  subsection Shape
    set Elements          = 20, 4
    set Position          = 1.5, 1
    set Region boundaries = 0.5
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Output
  set Folder = results
end
END

refuse "no file"
refuse "a file that is not there" nothing.prm
refuse "an unknown option" --chek good.prm
printf 'include good.prm\nsubsection Fluid\n  set Densitty = 3\nend\nsubsection Fuild\nend\n' >unknown.prm
refuse "unknown entry and section" unknown.prm
printf 'include good.prm\nsubsection Body shark\n  set Density = 3\nend\n' >shark.prm
refuse "an entry without its sections" good.prm -D "End time=2"
refuse "an entry of several regions" good.prm -D "Young's modulus=2"
refuse "a section without the one around it" good.prm -D "Region tail/Young's modulus=2"
mkdir -p prm/deep
cp good.prm prm/deep/good_case.prm
refuse "a case without its folder and ending" good_case
refuse "a case without its ending" good
refuse "a case that is nowhere" bad_case
refuse "a body that is not listed" shark.prm
override "Fluid/Density" much
override "Time/Scheme" leapfrog
override "Coupling/Kernel" five-point
override "Body fish/Muscle/Type" strong
override "Body fish/Region head/Material" rubber
override "Body fish/Shape/Type" shark
override "Body fish/Gait/Type" carling
override "Body fish/Controller/Type" autopilot
override "Dimension" 4

override "Fluid/Density" -1
override "Fluid/Kinematic viscosity" 0
override "Time/Step" -0.1
override "Time/End time" 0
override "Domain/Size" "4, -2"
override "Domain/Cells" "8, 1"
override "Domain/Levels" 0
override "Refinement/Interior levels" 4
override "Body fish/Density" -3
override "Body fish/Shape/Length" -1
override "Body fish/Shape/Elements" "20, 2"
override "Body fish/Shape/Region boundaries" "0.3, 0.5"
override "Body fish/Region head/Young's modulus" -1
override "Body fish/Region head/Thin direction" z
override "Body fish/Monitored points" "7, 0"
refuse "a muscle in an unknown region" good.prm -D "Body fish/Muscle/Type=bang-bang" -D "Body fish/Muscle/Regions=fin"
override "Refinement/Interval" 0
override "Solver/Largest number of iterations" -1
override "Body fish/Controller/Type" heading
override "Body fish/Region head/Feedback directions" z
override "Fluid/Inflow velocity" "1; 0"
refuse "a gait on a shape whose origin is its centre" good.prm -D "Body fish/Shape/Type=ellipse" \
  -D "Body fish/Shape/Region boundaries=" -D "Body fish/Regions=head" -D "Body fish/Gait/Type=curvature"
sed 's/fish/fluid/' good.prm >fluid.prm
refuse "a body that is called like the flow" fluid.prm
override "Output/Folder" ""

override "Fluid/Initial velocity" "1/0; 0"
override "Fluid/Initial velocity" "sqrt(x-1); 0"
override "Fluid/Initial velocity" "x"
override "Fluid/Body force" "2*velocity; 0"
override "Refinement/Level expression" "1/(x-x)"
override "Body fish/Muscle/Force distribution" "sqrt(s-0.5)"
refuse "an inflow that is not finite" good.prm -D "Fluid/Boundary conditions/left=inflow" \
  -D "Fluid/Inflow velocity=log(-1-y); 0"

override "Body fish/Shape/Position" "3.5, 1"
refuse "a kernel that reaches over the domain's side" good.prm -D "Coupling/Kernel=four-point" \
  -D "Body fish/Shape/Position=1.5, 0.08"
printf 'include good.prm\nset Bodies = fish, twin\nsubsection Body twin\n  subsection Shape\n' >two.prm
printf '    set Type = disc\n    set Position = 2, 1.1\n  end\nend\n' >>two.prm
refuse "overlapping bodies" two.prm
refuse "a probe outside of the domain" good.prm -D "Fluid/Probes=1, 1; 1, 7"

refuse "corners in the wrong order" good.prm -D "Body fish/Shape/Type=quadrilateral" \
  -D "Body fish/Shape/Quadrilateral/Vertices=0, 0; 0, 1; 1, 1; 1, 0"
refuse "a control volume that does not hold the body" good.prm -D "Fluid/Control volume=0.1, 0.1; 2, 1.5"
override "Body fish/Traction" "1"
override "Body fish/Shape/Type" file
refuse "a mesh that is not there" good.prm -D "Body fish/Shape/Type=file" -D "Body fish/Shape/File/Name=no.msh" \
  -D "Body fish/Shape/Region boundaries="
echo '$MeshFormat' >broken.msh
refuse "a broken mesh" good.prm -D "Body fish/Shape/Type=file" -D "Body fish/Shape/File/Name=broken.msh" \
  -D "Body fish/Shape/Region boundaries="
cat >square.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
1
1 3 2 7 1 1 2 3 4
$EndElements
END
refuse "a mesh with other regions" good.prm -D "Body fish/Shape/Type=file" -D "Body fish/Shape/File/Name=square.msh" \
  -D "Body fish/Shape/Region boundaries="
refuse "a force table that is not there" good.prm -D "Body fish/Muscle/Type=table" \
  -D "Body fish/Muscle/Table/File=no.txt"
refuse "another density with the explicit scheme" good.prm -D "Time/Scheme=explicit" -D "Body fish/Density=900"
refuse "a gait with the explicit scheme" good.prm -D "Time/Scheme=explicit" -D "Body fish/Gait/Type=curvature"

echo "no folder" >file
refuse "an output folder below a file" good.prm -D "Output/Folder=file/results"
mkdir full
touch full/thesis.tex
refuse "an output folder with other files" good.prm -D "Output/Folder=full"

override "Output/Figures/Print" "last(3)"
override "Output/Figures/Print" "last([time"

echo "* more ranks than cells"
mpirun -np 3 "$CAUDAL" good.prm -D "Domain/Cells=2,1" -D "Domain/Levels=5" 2>&1 | grep -m 1 Error
[ ! -e results ] || echo "    there is a folder of results"

# figure EXPRESSION: what is said at the end of a run
"$CAUDAL" good.prm -D "Output/Folder=run" >printed
figure() {
  echo "* the figure $1"
  "$CAUDAL" --resume run -D "Output/Figures/Print=$1" 2>errors | sed 's/^/    /'
  sed -n '/^Error/,$ s/^/    /p' errors
}
figure "last([fish: z of point 1])"
figure "last([time]) + foo"
figure "[time]"
figure "last([time]"
figure "last([time]/0)"
figure "1e3*last([time]); 100*largest([time] - t); mean(2*[cells]/[cells])"

echo "* the case is good, with warnings"
"$CAUDAL" --check --fast good.prm
"$CAUDAL" --check --fast good.prm -D "Coupling/Kernel=four-point" | grep -o "Warning.* kernel:"
"$CAUDAL" --check good.prm | sed -n 's/^Trial: 2 steps, .* MiB. 2 steps on these cells take about .*/    two trial steps/p'
# A fish in a narrow tank, with more cells across than the fluid has, that beats too fast for the step
"$CAUDAL" --check --fast good.prm -D "Body fish/Gait/Type=travelling wave" -D "Body fish/Shape/Elements=80,12" \
  -D "Time/End time=10" -D "Time/Step=0.05" | grep "Warning\|room"
"$CAUDAL" --check --fast good.prm -D "Body fish/Gait/Type=travelling wave" -D "Refinement/Vorticity threshold=0.1" \
  -D "Refinement/Largest number of cells=200" -D "Domain/Cells=16,16" -D "Domain/Size=8,8" \
  -D "Body fish/Shape/Position=3,4" | grep "Refinement"
"$CAUDAL" --check --fast good.prm -D "Body fish/Gait/Type=travelling wave" -D "Domain/Frame=fish" | grep "room" &&
  echo "    room, where the grid follows the fish"
[ ! -e results ] || echo "    there is a folder of results"
