# An elastic disc in a decaying vortex: both schemes are of second order and
# converge to the same motion. When the vortex has gone, the disc is round again
# and has kept its area.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >vortex.prm <<'END'
set Bodies = disc
subsection Time
  set End time = 0.2
end
subsection Domain
  set Cells  = 3, 3
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.05
  set Initial velocity    = sin(pi*x)^2*sin(2*pi*y); -sin(2*pi*x)*sin(pi*y)^2
end
subsection Body disc
  set Monitored points = 0.1, 0
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.6, 0.5
  end
  subsection Region body
    set Young's modulus = 30
  end
end
subsection Coupling
  set Kernel = dirac
end
subsection Refinement
  set Level expression = 2
end
subsection Output
  set Folder             = results
  set Interval of fields = 1e6
end
END

# converge SCHEME STEP: the order, and the position for a vanishing step in `limits`.
converge() {
  rm -f positions
  for factor in 1 0.5 0.25; do
    caudal vortex.prm -D "Time/Scheme=$1" -D "Time/Step=$(awk "BEGIN { print $factor * $2 }")"
    last "disc: x of point 1" results/statistics.txt >>positions
  done
  order=$(awk '{ x[NR] = $1 } END { print log((x[2] - x[1]) / (x[3] - x[2])) / log(2) }' positions)
  check "$1: second order" "$order > 1.8 && $order < 2.4"
  awk '{ x[NR] = $1 } END { print x[3] + (x[3] - x[2]) / 3 }' positions >>limits
}
converge semi-implicit 0.02
converge explicit 0.005
check "the same limit" "$(awk '{ x[NR] = $1 } END { print (x[2] - x[1])^2 }' limits) < 1e-5^2"
check "power identity" "$(last "power identity" results/statistics.txt) < 1e-10"

caudal vortex.prm -D "Time/Step=0.01" -D "Time/End time=1" -D "Fluid/Kinematic viscosity=0.1" \
  -D "Body disc/Region body/Young's modulus=3"
largest() {
  column "$1" results/statistics.txt |
    awk '{ x = $1 < 0 ? -$1 : $1; if (x > largest) largest = x } END { print largest }'
}
check "the disc was strained" \
  "$(largest "disc: elastic energy") > 4 * $(last "disc: elastic energy" results/statistics.txt)"
check "its area has changed by less than 0.5 %" "$(largest "disc: area change") < 0.005"
check "no element by more than 5 %" \
  "$(last "disc: min J" results/statistics.txt) > 0.95 && $(last "disc: max J" results/statistics.txt) < 1.05"
