# SPDX-License-Identifier: LGPL-2.1-or-later
# A run by the iterative method that is stopped and resumed is the undisturbed one, bit by bit, on
# one rank and on two: its preconditioner is a function of the matrix alone.
cat >ball.prm <<END
include $CAUDAL_SOURCE_DIR/tests/viscous/iterative_ball.prm
subsection Time
  set End time = 10
end
subsection Solver
  set Tolerance = 1e-8
end
END

for ranks in 1 2; do
  mpirun -np $ranks "$CAUDAL" --verify-restart ball.prm >printed 2>errors || cat errors
  grep -o "tables and the list of fields are equal, bit by bit" printed
done
