# SPDX-License-Identifier: LGPL-2.1-or-later
# Functions for the tests that are shell scripts.

# caudal ARGUMENTS: runs the program and, only if it fails, shows what it said.
caudal() {
  "$CAUDAL" "$@" >caudal.log 2>&1 || { status=$?; cat caudal.log; return $status; }
}

# column NAME FILE: all values of the column with this name (without its unit).
column() {
  awk -v name="$1" '
    /^# / { number = $2 + 0; sub(/^# [0-9]+: /, ""); sub(/ \[[^[]*\]$/, "")
            if ($0 == name) column = number; next }
    { if (!column) exit 1; print $column }' "$2" ||
    { echo "$2 has no column <$1>" >&2; return 1; }
}

# last NAME FILE: its last value.
last() {
  column "$1" "$2" | tail -n 1
}

# compute EXPRESSION: its value by awk, with two digits after the point.
compute() {
  awk "BEGIN { printf \"%.2f\\n\", $1 }"
}

# open_page FILE: a page of this folder, which may read others there, after its script has run.
open_page() {
  chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --allow-file-access-from-files \
    --user-data-dir="$PWD/profile" --virtual-time-budget=8000 --dump-dom "file://$PWD/$1" 2>/dev/null
}

# check TEXT CONDITION: prints the text and whether the condition holds.
check() {
  awk "BEGIN { print \"$1: \" (($2) ? \"yes\" : \"no ($2)\") }"
}

# refuse TEXT ARGUMENTS: prints the text and what the program says as it refuses these.
# It must leave no folder called results.
refuse() {
  echo "* $1"
  shift
  "$CAUDAL" "$@" >printed 2>errors </dev/null
  code=$?
  sed -n '/^Error/,$ s/^/    /p' errors
  [ $code -eq 1 ] || echo "    exit code $code"
  [ ! -s printed ] || cat printed
  [ ! -e results ] || echo "    there is a folder of results"
  rm -rf results
}

# override ENTRY VALUE: the same for good.prm with this entry.
override() {
  refuse "$1 = $2" good.prm -D "$1=$2"
}

# write_fluid_and_disc: fluid.prm, a vortex on a grid that changes, and disc.prm, an elastic
# disc in it.
write_fluid_and_disc() {
  cat >fluid.prm <<'EOF'
subsection Time
  set End time     = 0.2
  set Step         = 0.01
  set Adaptive     = true
  set Largest step = 0.02
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-3
  set Initial velocity    = sin(pi*x)^2*sin(2*pi*y); -sin(2*pi*x)*sin(pi*y)^2
end
subsection Refinement
  set Interval            = 3
  set Vorticity threshold = 0.2
end
subsection Output
  set Folder             = results
  set Interval of fields = 0.05
end
EOF

  cat >disc.prm <<'EOF'
include fluid.prm
set Bodies = disc
subsection Time
  set Adaptive = false
end
subsection Body disc
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.6, 0.5
  end
  subsection Region body
    set Young's modulus = 3
  end
end
EOF
}

# write_salmon: salmon.prm, a pushed fish in an ideal fluid at two frequencies, whose times have
# more digits than the list of fields.
write_salmon() {
  cat >salmon.prm <<'EOF'
set Model = potential
subsection Time
  set End time   = 0.4
  set Step       = 0.1
  set First part = 0
end
subsection Surface
  set Cells along  = 1
  set Cells across = 1
end
subsection Shape
  set Stations = 0.1, 3e-3, 4e-3; 0.5, 5e-3, 9e-3; 0.9, 1e-3, 8e-3
end
subsection Gait
  set Frequency = 2.5, 5
end
subsection Body
  set Linear impulse = -1e-4, 1e-5, 0
end
subsection Integration
  set Phases  = 8
  set Torques = false
end
subsection Output
  set Folder             = results
  set Interval of fields = 0.1
end
EOF
}

# write_eel: eel.prm, a short swim of two tail beats, by a gait, with results in eel.
write_eel() {
  cat >eel.prm <<'EOF'
set Bodies = eel
subsection Time
  set End time = 0.8
  set Step     = 0.005
end
subsection Domain
  set Size   = 2, 1
  set Cells  = 6, 3
  set Levels = 2
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-3
  # By itself it would be smaller, as the beat of this gait is a result, and this grid is very coarse.
  set Grad-div stabilisation = 1
end
subsection Body eel
  set Gait damping     = 1e4
  set Monitored points = 1, 0
  subsection Shape
    set Type     = eel
    set Elements = 16, 4
    set Position = 0.5, 0.5
  end
  subsection Region body
    set Material = none
  end
  subsection Gait
    set Type          = curvature
    set Start-up ramp = 0.1
    set Curvature     = 3*s*sin(2*pi*(s-5*t))
  end
end
subsection Coupling
  set Kernel                   = dirac
  set Accept unresolved bodies = true
end
subsection Output
  set Folder             = eel
  set Interval of fields = 0.2
end
EOF
}
