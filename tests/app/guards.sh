# Each limit of section Guards warns once and is counted at the end; 0 switches it off.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >disc.prm <<'EOF'
set Bodies = disc
subsection Time
  set End time = 0.2
  set Step     = 0.02
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.02
  set Initial velocity    = sin(pi*x)^2*sin(2*pi*y); -sin(2*pi*x)*sin(pi*y)^2
end
subsection Body disc
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.6, 0.5
  end
  subsection Region body
    set Young's modulus    = 3
    set Feedback stiffness = 0.1
  end
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
EOF

# warn WHAT OPTIONS: each line that is said, without the value, and the summary.
warn() {
  echo "* $1"
  shift
  "$CAUDAL" disc.prm "$@" >printed
  grep -i "^warning" printed | sed 's/at t = [0-9.]* s/at t = .../; s/ is [-0-9][-0-9.e]*/ is .../; s/^/    /' || true
}
warn "with the default limits"
tighten() {
  warn "$@" -D "Guards/Largest area change=1e-9" -D "Guards/Smallest J=0.9999" \
    -D "Guards/Largest J=1.0001" -D "Guards/Largest tether displacement=0.01" \
    -D "Guards/Largest power identity=0" -D "Guards/Largest energy residual=1e-6"
}
tighten "with tight limits"
# A resumed run warns of what is new and counts on.
tighten "with tight limits, to the middle" -D "Time/End time=0.1" >half
echo "* resumed from the middle"
"$CAUDAL" --resume results -D "Time/End time=0.2" >printed
grep "^Warning" printed | sed 's/at t = [0-9.]* s/at t = .../; s/ is [-0-9][-0-9.e]*/ is .../; s/^/    /'
# In which steps the powers agree to the last bit is chance.
warn "powers equal but for round-off" -D "Guards/Largest tether displacement=0" \
  -D "Guards/Largest power identity=1e-30" | sed 's/in [1-9][0-9]* steps/in some steps/'
warn "without limits" -D "Guards/Largest area change=0" -D "Guards/Smallest J=0" -D "Guards/Largest J=0" \
  -D "Guards/Largest tether displacement=0" -D "Guards/Largest power identity=0" \
  -D "Guards/Largest energy residual=0"
