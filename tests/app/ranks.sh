# SPDX-License-Identifier: LGPL-2.1-or-later
# How scripts/swim calls the program: with a case, and on how many ranks; on a machine that others use
# on one, which it says.
root=$CAUDAL_SOURCE_DIR
. "$root/scripts/environment"

echo "* what others want"
# load TEXT: the load that this text of /proc/loadavg tells.
load() {
  echo "$1" >loadavg
  echo "$(count_load loadavg) of $1"
}
load "0.40 2.00 3.00 1/100 4711"
load "8.20 2.00 3.00 10/100 4711"
load "8.20 2.00 3.00 3/100 4711"
load "2.00 2.00 3.00 1/100 4711"
echo "$(count_load nothing) where the system does not tell"

echo "* cores, load, ranks"
for case in "1 9" "2 0" "2 1" "2 8" "8 4" "8 5"; do
  echo "$case: $(choose_ranks $case 2>said) $(cat said)"
done

echo "* how the program is called"
cat >fake <<'END'
#!/bin/sh
echo "$@, yields: $OMPI_MCA_mpi_yield_when_idle"
END
chmod +x fake
echo "set Model = passage" >passage.prm
unset OMPI_MCA_mpi_yield_when_idle
export CAUDAL=program MPIRUN=$PWD/fake
CAUDAL_RANKS=3 "$root/scripts/swim" case.prm
OMPI_MCA_mpi_yield_when_idle=0 CAUDAL_RANKS=3 "$root/scripts/swim" --resume folder
CAUDAL=$PWD/fake "$root/scripts/swim" passage.prm
export CAUDAL_RANKS=2
"$root/scripts/swim" -D "Time/End time=2"
"$root/scripts/swim" first_fish -D "Time/End time=2"
"$root/scripts/swim" output/first_fish
CAUDAL=$PWD/fake "$root/scripts/swim" --help
