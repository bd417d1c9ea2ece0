# SPDX-License-Identifier: LGPL-2.1-or-later
# Each rank uses one BLAS thread, whoever has started it, unless the environment says otherwise.
cat >case.prm <<'END'
set Bodies =
subsection Time
  set Step     = 0.01
  set End time = 0.01
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 1
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-2
end
subsection Output
  set Folder = results
end
END
unset OPENBLAS_NUM_THREADS OMP_NUM_THREADS MKL_NUM_THREADS

# show TEXT COMMAND: runs it and prints the number of threads that its log tells.
show() {
  echo "$1: $(shift; "$@" >/dev/null; sed -n 's/^ *BLAS.*, \([0-9]* threads\{0,1\} a rank\)$/\1/p' results/log.txt)"
}
show "two ranks" mpirun -np 2 "$CAUDAL" case.prm
show "by itself" "$CAUDAL" case.prm
show "OMP_NUM_THREADS=2" env OMP_NUM_THREADS=2 "$CAUDAL" case.prm
