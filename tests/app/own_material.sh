# SPDX-License-Identifier: LGPL-2.1-or-later
# A material from a user's own library, built against the installed package: a beam that is
# three times as stiff at its tip as at its root bends under its weight like Euler's and
# Bernoulli's, w = int (L - x) M/(E I) dx with M = rho g h (L - x)^2/2.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cmake --install "$(dirname "$CAUDAL")" --prefix "$PWD/prefix" >install.log || cat install.log
cp -r "$CAUDAL_SOURCE_DIR/examples/own_material" example
cd example
{ cmake -S . -B build -D CMAKE_PREFIX_PATH="$PWD/../prefix" && cmake --build build; } >build.log 2>&1 ||
  cat build.log
CAUDAL=$PWD/../prefix/bin/caudal

# bend MODULUS_AT_THE_TIP: by how much the tip sinks over Euler's and Bernoulli's w. The
# modulus of plane strain is 4 mu (kappa + mu)/(kappa + 2 mu), the free part 0.95 m long.
bend() {
  caudal beam.prm -D "Body beam/Region beam/Graded neo-Hookean/Modulus at the tip=$1"
  awk -v sunk="$(last "beam: y of point 1" results/statistics.txt)" -v tip="$1" 'BEGIN {
    n = 10000; h = 0.05; kappa = 1e7
    for (i = 0; i < n; ++i)
    {
      x  = 0.05 + 0.95 * (i + 0.5) / n
      mu = 1e5 + (tip - 1e5) * x
      moment    = 1000 * 0.02 * h * (1 - x)^2 / 2
      stiffness = 4 * mu * (kappa + mu) / (kappa + 2 * mu) * h^3 / 12
      w += 0.95 / n * (1 - x) * moment / stiffness
    }
    printf "tip %.1f mm, over the theory %.2f\n", 1e3 * sunk, -sunk / w }'
}
bend 3e5
bend 1e5

deny() {
  "$CAUDAL" --check beam.prm -D "$1" 2>&1 | sed -n "/^Error/ s| (.*)| (...)|p"
}
deny "Body beam/Region beam/Graded neo-Hookean/Length=-1"
deny "Libraries="
deny "Libraries=build/libnone.so"
deny "Libraries=beam.prm"
"$CAUDAL" --check beam.prm -D "Body beam/Region root/Graded neo-Hookean/Length=2" |
  sed -n "/^Warning/p"
