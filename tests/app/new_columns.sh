# SPDX-License-Identifier: LGPL-2.1-or-later
# A run is resumed with other probes, monitored points and another format of the fields: the table
# with the new columns begins there, and the old one is kept.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

write_fluid_and_disc
"$CAUDAL" disc.prm -D "Time/End time=0.05" >printed 2>errors || cat errors

# resume TEXT OVERRIDES
resume() {
  echo "* $1"
  shift
  "$CAUDAL" --resume results "$@" >printed 2>errors
  echo "    exit code $?"
  sed 's/^/    /' errors
  grep -E "^(Changed|Warning|The columns)" printed | grep -v Elements | sed 's/^/    /'
  for table in results/statistics*.txt; do
    echo "    $(basename "$table"): $(column time "$table" | wc -l) rows," \
      "$(grep -c '^#' "$table") columns, until $(column time "$table" | tail -n 1 | awk '{ print $1 + 0 }')"
  done
}

resume "a probe and a monitored point" -D "Time/End time=0.1" -D "Fluid/Probes=0.5, 0.5" \
  -D "Body disc/Monitored points=0.05, 0"
column "p at probe 1" results/statistics.txt | wc -l
resume "no more of them" -D "Time/End time=0.15" -D "Fluid/Probes=" -D "Body disc/Monitored points="
resume "another format" -D "Time/End time=0.2" -D "Output/Format=hdf5"
ls results/solution.*
resume "a probe outside of the domain" -D "Time/End time=0.25" -D "Fluid/Probes=2, 0.5"
