# SPDX-License-Identifier: LGPL-2.1-or-later
# The benchmarks that take seconds, by scripts/benchmark: all of their gates are met.
set -e
"$CAUDAL_SOURCE_DIR/scripts/benchmark" --folder "$PWD/results" \
  ring csm1 csm2 taylor_green kovasznay moving_vortices >table || cat table
# Names have 16 columns, quantities those up to the first gap.
awk 'NF && $NF ~ /^(ok|off)$/ {
  quantity = substr($0, 23); sub(/  .*/, "", quantity); print $1 ", " quantity ": " $NF }' table
