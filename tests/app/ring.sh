# A ring of fibres under tension is at rest: the pressure inside and outside is the
# exact one within 0.5 %, and what moves nevertheless is an error that falls with the
# grid's spacing, at an order of 1.5 or more.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

ring() { # LEVELS ELEMENTS
  caudal "$CAUDAL_SOURCE_DIR/prm/benchmarks/ring.prm" -D "Output/Folder=results" \
    -D "Time/End time=0.05" -D "Domain/Levels=$1" -D "Refinement/Level expression=$(($1 - 1))" \
    -D "Body ring/Shape/Elements=$2"
}
ring 2 "48, 2"
coarse=$(last "kinetic energy" results/statistics.txt)
ring 3 "96, 4"
fine=$(last "kinetic energy" results/statistics.txt)
check "pressure inside" "($(last "p at probe 1" results/statistics.txt) / 0.167920 - 1)^2 < 0.005^2"
check "pressure outside" "($(last "p at probe 2" results/statistics.txt) / -0.055223 - 1)^2 < 0.005^2"
check "area kept" "($(last "ring: area change" results/statistics.txt))^2 < 1e-5^2"
check "velocities fall with the spacing" "0.5 * log($coarse / $fine) / log(2) > 1.5"
