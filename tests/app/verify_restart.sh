# SPDX-License-Identifier: LGPL-2.1-or-later
# A resumed run is the one that was not interrupted, bit by bit, on one and on two ranks.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc
write_salmon

cat >fish.prm <<EOF
include $CAUDAL_SOURCE_DIR/prm/fish.prm
subsection Time
  set Step = 0.004
end
subsection Domain
  set Size   = 3, 2
  set Cells  = 6, 4
  set Levels = 4
end
subsection Body fish
  subsection Shape
    set Elements = 40, 4
    set Position = 1, 1
  end
  subsection Muscle
    set Force distribution = if(s>0.7,1,0)
    subsection Bang-bang
      set Maximum force density = 2e5
      set Switching position    = 0.001
    end
  end
end
subsection Fluid
  set Control volume = 0.4, 0.4; 2.6, 1.6
end
subsection Refinement
  set Interval         = 3
  set Vorticity levels = 3
end
subsection Output
  set Folder = results
end
EOF

cat >school.prm <<EOF
include $CAUDAL_SOURCE_DIR/prm/school_tandem.prm
subsection Time
  set Step = 0.01
end
subsection Domain
  set Size   = 0.2, 0.1
  set Cells  = 8, 4
  set Levels = 5
end
subsection Body fish
  subsection Shape
    set Position = 0.035, 0.05
  end
end
subsection Body follower
  subsection Shape
    set Position = 0.11, 0.05
  end
  subsection Controller
    set Type = none
  end
end
subsection Coupling
  set Accept unresolved bodies = true
end
subsection Refinement
  set Interval         = 4
  set Vorticity levels = 3
end
subsection Output
  set Folder = results
  set Format = hdf5
end
EOF

# verify TEXT ARGUMENTS
verify() {
  echo "* $1"
  shift
  "$CAUDAL" --verify-restart "$@" >printed 2>errors && tail -n 1 printed | grep -o "equal, bit by bit" || cat errors
  mpirun -np 2 "$CAUDAL" --verify-restart "$@" >printed 2>errors &&
    tail -n 1 printed | grep -o "equal, bit by bit" | sed 's/$/, on two ranks/' || cat errors
  rm -rf results.verify
}
verify "only fluid" fluid.prm -D "Time/End time=10"
verify "only fluid, explicit" fluid.prm -D Time/Scheme=explicit -D "Time/End time=10"
verify "an elastic disc in a flow" disc.prm -D "Time/End time=10"
verify "the fish" fish.prm -D "Time/End time=10"
verify "a school" school.prm -D "Time/End time=10"

verify "the salmon" salmon.prm -D "Time/End time=1.2" -D "Body/Linear impulse=0, 0, 0" -D "Integration/Torques=true"
verify "the salmon, brute force" salmon.prm -D "Time/End time=1.2" -D "Integration/Method=brute force" -D "Resistance/Active=true"
