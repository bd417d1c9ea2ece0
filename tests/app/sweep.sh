# SPDX-License-Identifier: LGPL-2.1-or-later
# scripts/sweep: all combinations, or a list; nothing twice; a run that fails is told and the others
# go on; what was stopped goes on; other parameters leave older results where they are; grids.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
write_eel
write_fluid_and_disc
write_salmon

# sweep ARGUMENTS: what it says, without the files that it names, sorted as runs end in any order.
sweep() {
  code=0
  "$CAUDAL_SOURCE_DIR/scripts/sweep" "$@" >printed 2>&1 || code=$?
  grep -v "^$PWD/" printed | sed 's/^\[[0-9/]*\]/ /; s/^\([^ ]\)/  \1/; s/Caudal [0-9].*/VERSION/' | LC_ALL=C sort
  echo "  exit code $code"
}

# table FILE: its columns without their units, and its rows with numbers of three digits.
table() {
  /usr/bin/python3 - "$1" <<'END'
import sys

import pandas as pd

table = pd.read_csv(sys.argv[1])
shown = table.drop(columns="run")
print(shown.to_string(index=False, na_rep="-", float_format=lambda x: f"{x:.3g}"))
END
}

echo "* two entries, the frequencies from one run"
sweep salmon.prm "Body fish/Gait/Frequency=2.5:5:2" "Body fish/Gait/Wave number=1,1.2" --folder both \
  --figures "distance,displacement a stroke,largest of speed"
sweep salmon.prm "Body fish/Gait/Frequency=2.5:5:2" "Body fish/Gait/Wave number=1,1.2" --folder both \
  --figures "distance,displacement a stroke"
table both/sweep.csv
ls both/runs
head -c 4 both/sweep.png | tail -c 3
echo " picture"
sed -n 's/.*<p class="subtitle">/  /p' both/report.html | sed 's/<.*//'
for page in $(grep -o 'href="runs[^"]*' both/report.html | sed 's/href="//; s/%2C/,/g; s/%3D/=/g'); do
  [ -s "both/$page" ] && echo "  a page that is there"
done

echo "* one of two fails; it is made again only if that is asked for"
sweep salmon.prm "Surface/Cells along=1,0" --folder fails --no-pages
sweep salmon.prm "Surface/Cells along=1,0" --folder fails --no-pages
sweep salmon.prm "Surface/Cells along=1,0" --folder fails --no-pages --retry | grep "0: failed"
/usr/bin/python3 -c 'import pandas
print(pandas.read_csv("fails/sweep.csv")[["Surface/Cells along", "state", "remark"]].drop_duplicates().to_string())' |
  cut -c 1-110

echo "* a fish whose beats are not steady, and one that has made none"
sweep eel.prm "Time/End time=0.8|0.1" --folder beats --no-pages --figures speed
sweep eel.prm "Time/End time=0.8|0.1" --folder beats --no-pages --figures speed --steady-only
# A speed of so few steps has no digits that are the same everywhere.
table beats/sweep.csv | sed 's/-[0-9.e-]* \( *0 finished\)/SPEED \1/'
[ ! -e beats/sweep.png ] || ls beats

echo "* a list"
cat >list.csv <<'END'
Body fish/Gait/Wave number, Time/End time
1, 0.4
1.2, 0.8
END
sweep salmon.prm --list list.csv --folder listed --no-pages --figures "duration"
table listed/sweep.csv
# The case has changed: older results stay beside the new ones.
sed 's/First part = 0/First part = 0.1/' salmon.prm >changed.prm
sweep changed.prm --list list.csv --folder listed --no-pages --figures "duration"
ls -d listed/runs/*/results*

echo "* stopped, and gone on, as if it had not been"
set -- disc.prm "Body disc/Region body/Young's modulus=3|30" --no-pages -D "Time/End time=3" --jobs 1 \
  --figures "kinetic energy,least of disc: min J"
"$CAUDAL_SOURCE_DIR/scripts/sweep" "$@" --folder straight >/dev/null
"$CAUDAL_SOURCE_DIR/scripts/sweep" "$@" --folder stopped >printed 2>&1 &
for k in $(seq 300); do
  [ -s "stopped/runs/Young_s_modulus=3/results/statistics.txt" ] && break
  sleep 0.1
done
kill -TERM $!
code=0
wait $! || code=$?
grep -v "^$PWD/" printed | sed 's/^/  /'
echo "  exit code $code"
sweep "$@" --folder stopped
for run in straight/runs/*/results; do
  cmp "$run/statistics.txt" "stopped/${run#straight/}/statistics.txt" && echo "  the same"
done
cat stopped/runs/*/results/log.txt | grep -c "^Resumed from"
table stopped/sweep.csv

echo "* what it would cost"
sweep eel.prm "Body eel/Gait damping=1e4,2e4,-1" --folder dry --dry-run |
  sed 's/about [0-9:]* /about TIME /; s/about [0-9]* MiB/about MEMORY/; s/up to [0-9.]* MiB/up to SOME MiB/'

echo "* what can't be done"
printf 'Time/Step\n0.1,0.2\n' >short.csv
/usr/bin/python3 - <<'END' 2>&1 >/dev/null | sed "s|$PWD/||g"
import os
import sys

sys.path.insert(0, os.environ["CAUDAL_SOURCE_DIR"] + "/scripts")
import caudal_setup  # noqa: F401
from caudal_sweep.main import main

for arguments in (
        ["nothing.prm", "Time/Step=1,2"], ["salmon.prm"], ["salmon.prm", "Time/Step"],
        ["salmon.prm", "Time/Step=1:2:x"], ["salmon.prm", "Time/Step=1,1"],
        ["salmon.prm", "Time/Stop=1,2"], ["salmon.prm", "Time/Step=0.1", "Time/Step=0.3"],
        ["salmon.prm", "Time/Step=0.1,0.2", "--jobs", "0"], ["salmon.prm", "--mesh", "--grids", "3,2,1"],
        ["salmon.prm", "Time/Step=1,2", "--grids", "1,2,3"], ["eel.prm", "--mesh"],
        ["salmon.prm", "--list", "short.csv"], ["salmon.prm", "Time/Step=0.1", "-D", "Time"],
        ["salmon.prm", "--list", "list.csv", "--folder", "listed", "--no-pages", "--figures", "glee"]):
    if main([*arguments, *([] if "--folder" in arguments else ["--folder", "none"])]) != 1:
        print("not an error:", *arguments, file=sys.stderr)
END
[ ! -e none ] || ls none
