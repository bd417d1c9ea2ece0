# SPDX-License-Identifier: LGPL-2.1-or-later
# scripts/sweep: all combinations, or a list; nothing twice; a run that fails is told and the others
# go on; what was stopped goes on, and what is to swim longer; other settings and bad values are
# refused before any run.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
write_eel
write_fluid_and_disc
write_salmon

# sweep ARGUMENTS: what it says, without the files that it names, sorted as runs end in any order.
sweep() {
  code=0
  "$CAUDAL_SOURCE_DIR/scripts/sweep" "$@" >printed 2>&1 || code=$?
  grep -v "^$PWD/\|^[0-9]* running: " printed | sed "s|$PWD/||g"'; s/^\[[0-9/]*\]/ /; s/ ([0-9]* of [0-9]*)//; s/, [0-9]* at a time//
    s/^\([^ ]\)/  \1/; s/Caudal [0-9].*/VERSION/' | LC_ALL=C sort
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
mkdir -p "fails/runs/Cells_along=2/results"
echo "not of a run" >"fails/runs/Cells_along=2/results/notes"
sweep salmon.prm "Surface/Cells along=1,2" --folder fails --no-pages
sweep salmon.prm "Surface/Cells along=1,2" --folder fails --no-pages
sweep salmon.prm "Surface/Cells along=1,2" --folder fails --no-pages --retry | grep "2: failed"
/usr/bin/python3 -c 'import pandas
print(pandas.read_csv("fails/sweep.csv")[["Surface/Cells along", "state", "remark"]].drop_duplicates().to_string())' |
  sed "s|$PWD/||; s/  */ /g" | cut -c 1-110

echo "* a value that the program refuses"
sweep salmon.prm "Surface/Cells along=1,0" --folder refused
[ ! -e refused ] || ls refused

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
# The case has changed.
sed 's/First part = 0/First part = 0.1/' salmon.prm >changed.prm
sweep changed.prm --list list.csv --folder listed --no-pages --figures "duration"
# Said in other words it is the same.
sweep salmon.prm --list list.csv --folder listed --no-pages --figures "duration" -D "Time/First part=0.0"
ls -d listed/runs/*/results*

echo "* a figure that there is not: told, and known runs are not made again"
sweep salmon.prm "Body fish/Gait/Wave number=1,1.2" --folder glee --no-pages --figures "speed,glee" | cut -c 1-80
head -n 1 glee/sweep.csv
sweep salmon.prm "Body fish/Gait/Wave number=1,1.2,1.4" --folder glee --figures "glee" | cut -c 1-80

echo "* stopped, and gone on, as if it had not been"
set -- disc.prm "Body disc/Region body/Young's modulus=3|30" --no-pages -D "Time/End time=1" --jobs 1 \
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
grep -v "^$PWD/\|^[0-9]* running: " printed | sed 's/^/  /; s/, [0-9]* at a time//'
echo "  exit code $code"
# Other settings leave it as it is, and so does a dry run.
find stopped -type f -exec md5sum {} + | sort >before
sweep "$@" --folder stopped -D "Time/End time=0.9"
sweep "$@" --folder stopped -D "Time/End time=0.9" --dry-run
sweep "$@" --folder stopped --dry-run | grep "goes on\|^  2 runs:" | sed 's/from [0-9.]*/from TIME/'
find stopped -type f -exec md5sum {} + | sort | cmp before - && echo "  untouched"
sweep "$@" --folder stopped | sed 's/from [0-9.]*/from TIME/'
for run in straight/runs/*/results; do
  cmp "$run/statistics.txt" "stopped/${run#straight/}/statistics.txt" && echo "  the same"
done
cat stopped/runs/*/results/log.txt | grep -c "^Resumed from"
table stopped/sweep.csv

echo "* longer"
sweep "$@" --folder stopped -D "Time/End time=1.05"
for run in stopped/runs/*/results; do
  last time "$run/statistics.txt"
done
ls -d stopped/runs/*/results*

echo "* how far runs are"
/usr/bin/python3 - <<'END'
import os
import pathlib
import sys
import time

import pandas

sys.path.insert(0, os.environ["CAUDAL_SOURCE_DIR"] + "/scripts")
import caudal_setup  # noqa: F401
from caudal_sweep import design, plot, progress

line = "t = {} of 4.00 s   45.0 %  step 720  2.08 steps/s  {} left  dt 0.0025 s, 2891 cells\n"
pathlib.Path("one.txt").write_text(line.format("0.2", "9:00") + line.format("1.80", "10:00"))
pathlib.Path("two.txt").write_text(line.format("2.04", "1:10:00"))
pathlib.Path("mute.txt").write_text("Caudal\n")
now = time.time()
print(" ", progress.describe(["one.txt"], [now - 600], 0, [], 2))
print(" ", progress.describe(["one.txt", "two.txt"], [now - 600, now - 4200], 0, [], 2))
print(" ", progress.describe(["one.txt", "mute.txt"], [now - 600, now], 2, [], 2))
print(" ", progress.describe(["mute.txt", "none.txt"], [now, now], 1, [], 2))

# The names of curves, of values as text and as numbers.
axes = design.name_axes([design.Axis(entry, ("1", "2")) for entry in ("A/Wave number", "A/Frequency", "B/Part")],
                        {"A/Frequency": "Hz"})
table = pandas.DataFrame({"A/Frequency": [2., 3.5], "B/Part": ["1e-4", "x"]})
curves = [name for name, _ in plot.find_curves(table, axes, "potential")]
print(" ", curves, plot.split_curve("Frequency 3.5 Hz"), axes[1].label)
END

echo "* what it would cost"
sweep eel.prm "Body eel/Gait damping=1e4,2e4,-1" --folder dry --dry-run |
  sed 's/about [0-9:]* /about TIME /; s/about [0-9]* MiB/about MEMORY/; s/up to [0-9.]* MiB/up to SOME MiB/' |
  cut -c 1-100
[ ! -e dry ] || ls dry

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
        ["salmon.prm", "Time/Step=1:2:x"], ["salmon.prm", "Time/Step=1:2"],
        ["salmon.prm", "Time/Step=2:1:1"], ["salmon.prm", "Time/Step=1,1"],
        ["salmon.prm", "Time/Stop=1,2"], ["salmon.prm", "Time/Step=0.1", "Time/Step=0.3"],
        ["salmon.prm", "Time/Step=0.1,0.2", "--jobs", "0"], ["salmon.prm", "--mesh", "--grids", "3,2,1"],
        ["salmon.prm", "Time/Step=1,2", "--grids", "1,2,3"], ["eel.prm", "--mesh"],
        ["salmon.prm", "--list", "short.csv"], ["salmon.prm", "Time/Step=0.1", "-D", "Time"],
        ["salmon.prm", "--list", "list.csv", "--folder", "listed", "--no-pages", "--figures", "glee"]):
    if main([*arguments, *([] if "--folder" in arguments else ["--folder", "none"])]) != 1:
        print("not an error:", *arguments, file=sys.stderr)
END
[ ! -e none ] || ls none
