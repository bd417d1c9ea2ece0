# SPDX-License-Identifier: LGPL-2.1-or-later
# The Python package caudal: tables with names and units, tail beats, columns by phase, fields, runs
# below a folder, and what it says of results that are cut off.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
write_eel
write_salmon
caudal eel.prm
caudal salmon.prm -D Output/Folder=salmon

PYTHONPATH=$CAUDAL_SOURCE_DIR/python /usr/bin/python3 - <<'END'
import pathlib
import sys

import caudal

run = caudal.Run("eel")
print("statistics:", *run.statistics.shape, "-", run.find("max velocity"), "-", run.get_unit("time"))
print("without VTK so far:", not any(name.startswith("vtk") for name in sys.modules))

beats = run.beats()
print(beats[["period [s]", "speed [m/s]", "steady"]].round(2).to_string())

# The work of a beat is what the power does in it: the resampled column must have its mean.
by_phase = run.resample_beats(["muscle power"], count=200)
print("mean power by phase over that of the beat:",
      *(by_phase.groupby("beat").mean().squeeze() / beats["power [W/m]"]).round(2))
print("phases:", by_phase.index.get_level_values("phase").nunique())

time = run.times[-1]
fluid, body = run.read_fluid(time), run.read_bodies(time)["eel"]
print(f"fields at {time:g} s: area of the fluid {fluid.areas.sum():.3f} m^2, of the body",
      f"{body.areas.sum():.2f} m^2;", ", ".join(sorted(fluid.data)))

salmon = caudal.Run("salmon")
print(salmon.model, salmon.summary["frequency [Hz]"].tolist(),
      len(salmon.read_statistics(5.)), "rows at 5 Hz")
print(caudal.list_runs(".").to_string())


def trouble(action):
    try:
        action()
    except caudal.MissingData as reason:
        print("  " + str(reason))


# A row that is being written is left out; one that is damaged is not.
table, text = pathlib.Path("eel/statistics.txt"), pathlib.Path("eel/statistics.txt").read_text()
table.write_text(text[:-40])
print("a row that is being written:", len(caudal.Run("eel").statistics), "rows")
lines = text.splitlines(True)
table.write_text("".join(lines[:-5] + [lines[-5][:200] + "\n"] + lines[-4:]))
trouble(lambda: caudal.Run("eel").statistics)
trouble(lambda: run.get("speed of light"))
trouble(lambda: run.beats("cod"))
trouble(lambda: run.resample_beats(["power"]))
trouble(lambda: run.get("eel: muscel work"))
trouble(lambda: run.read_fluid(99))
trouble(lambda: run.read(run.times[0], "cod"))
trouble(lambda: caudal.Run("nothing"))
trouble(lambda: caudal.Run("eel/fields").parameters)
trouble(lambda: caudal.list_runs("eel/fields"))
END
