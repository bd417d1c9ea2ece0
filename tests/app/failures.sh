# SPDX-License-Identifier: LGPL-2.1-or-later
# A run that cannot go on writes the last good state, says why and ends with 1.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >base.prm <<'END'
set Bodies = disc
subsection Time
  set End time                 = 1
  set Step                     = 0.05
  set Largest number of retries = 2
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 2
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.1
end
subsection Body disc
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.5, 0.5
  end
  subsection Region body
    set Young's modulus = 3
  end
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END

# fail TEXT OPTIONS: what is said, and whether the last state can be looked at.
fail() {
  echo "* $1"
  shift
  "$CAUDAL" base.prm "$@" >printed 2>errors
  code=$?
  sed 's/([-0-9.e+ ]*)/(...)/g; s/determinant [-0-9.e]*/determinant .../; s/residual [-0-9.e+]*/residual .../
       s/it leaves [-0-9.e+]* of/it leaves ... of/
       s/down to [0-9.e-]* s/down to ... s/; s/[-0-9.e+]* m.s, is in/... m\/s, is in/; s/J, [-0-9.e+]*,/J, ...,/g
       s/step [-0-9.e+]* in element/step ... in element/; s/element [0-9][0-9]*/element .../g
       s/[-0-9.e+]* m from it/... m from it/g; s/^/    /' errors
  echo "    exit code $code"
  ls results/restart/step-*/state >/dev/null && echo "    a checkpoint"
  [ "$(tail -n +2 results/statistics.csv | wc -l)" = "$(grep -vc "^#" results/statistics.txt)" ] &&
    echo "    statistics.csv has all rows"
  grep -o "The last good state.* is written" results/log.txt | sed 's/t = [^ ]*/t = .../; s/^/    /'
  for name in fluid disc; do
    n=$(grep -c "<DataSet.*name=\"$name\"" results/solution.pvd)
    [ -s "results/fields/$name-0000$((n - 1)).vtu" ] && echo "    fields of $name at $n times"
  done
}

leave() {
  fail "$@" -D "Fluid/Initial velocity=1;0" -D "Fluid/Inflow velocity=1;0" \
    -D "Fluid/Boundary conditions/left=inflow" -D "Fluid/Boundary conditions/right=outflow" \
    -D "Fluid/Boundary conditions/bottom=free slip" -D "Fluid/Boundary conditions/top=free slip"
}

leave "a body that leaves through the side"
leave "a kernel that leaves through the side" -D "Coupling/Kernel=four-point"
fail "an inverted element" -D "Coupling/Accept unresolved bodies=true" -D "Body disc/Shape/Type=naca" -D "Body disc/Shape/Elements=12,4" \
  -D "Body disc/Shape/Length=0.5" -D "Body disc/Shape/Position=0.25,0.5" -D "Body disc/Muscle/Type=bang-bang" \
  -D "Body disc/Muscle/Force distribution=if(s>0.5,1,-1)" -D "Body disc/Muscle/Bang-bang/Maximum force density=1e6"
fail "a body force that ceases to be a number" -D "Fluid/Body force=sqrt(0.12-t);0"
fail "an inflow that ceases to be a number" -D "Fluid/Boundary conditions/left=inflow" \
  -D "Fluid/Inflow velocity=sqrt(if(t > 0.12 && t < 0.2, -1, 1));0" -D "Fluid/Boundary conditions/right=outflow"
fail "a velocity that overflows" -D "Fluid/Body force=y*1e308;0"
fail "a solver that does not converge" -D "Solver/Largest number of iterations=2" -D "Solver/Tolerance=1e-15"
fail "an iterative solver that stalls" -D "Solver/Method=iterative" -D "Solver/Limit of the iterative method=3" \
  -D "Fluid/Body force=y;0"

# An error of one rank alone, the one that has the upper half, is one of all.
fail_on_one_rank() {
  echo "* one of two ranks meets an error in $1"
  timeout 60 mpirun -np 2 "$CAUDAL" base.prm -D "$1=$2" -D "Time/Step=0.01" \
    -D "Fluid/Boundary conditions/right=inflow" -D "Fluid/Boundary conditions/left=outflow" >printed 2>errors
  echo "    exit code $?"
  grep -m 1 -o "$1.*not a finite number" errors | sed 's/^/    /'
}
fail_on_one_rank "Fluid/Body force" "if(y > 0.7, sqrt(0.12-t), 0);0"
fail_on_one_rank "Fluid/Inflow velocity" "if(y > 0.7, sqrt(0.12-t), 0);0"
fail_on_one_rank "Refinement/Level expression" "if(y > 0.7, sqrt(-y), 1)"
