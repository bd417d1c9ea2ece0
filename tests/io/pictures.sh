# SPDX-License-Identifier: LGPL-2.1-or-later
# Pictures that can be shown: a film of all outputs, colours by what lies off the bodies, all bodies
# in view, pages that fit a telephone and a screen, and ParaView's view where it is installed.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
write_eel
caudal eel.prm
caudal "$CAUDAL_SOURCE_DIR/prm/salmon/salmon.prm" -D "Output/Folder=salmon" -D "Time/End time=3" \
  -D "Surface/Cells along=2" -D "Surface/Cells across=2" -D "Output/Interval of fields=0.5"

"$CAUDAL_SOURCE_DIR/scripts/plot" eel --only cruise,energy --only speed --movie

echo "* what can't be drawn"
mkdir empty sweep
echo >sweep/sweep.png
echo >sweep/sweep.csv
for folder in nothing empty sweep salmon .; do
  "$CAUDAL_SOURCE_DIR/scripts/plot" $folder 2>&1 | sed "s/^/  /"
done
"$CAUDAL_SOURCE_DIR/scripts/plot" eel --only cruise,sped 2>&1 | sed -n "s/.*error: /  /p"
echo "outputs: $(ls eel/fields/fluid-*.vtu | wc -l), pictures: $(ls eel/plots/movie | wc -l)"
ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 eel/plots/movie.mp4 |
  sed 's/^/frames of the mp4: /'
/usr/bin/python3 - <<'END'
import os
import sys

import numpy as np
from PIL import Image

sys.path.insert(0, os.environ["CAUDAL_SOURCE_DIR"] + "/scripts")
import caudal_setup  # noqa: F401: so that the package caudal is found
from caudal import Run
from caudal_plots import flow, history, phases

# A beat of 0.5 s from 3.77 s on: even phases, where the outputs allow it.
for gap in (0.025, 0.05, 0.07, 0.2, 1.):
    times = phases.choose_phases(np.arange(0, 5, gap), 3.77, 0.5, phases.SEQUENCE)
    print(f"outputs each {gap:g} s:", *(f"{(time - 3.77) / 0.5:.2f}" for time in times))


class Outputs:
    """A run with fields, whose first beat ends at 0.8 s, or one without a beat."""

    def __init__(self, gap, beats):
        self.times, self.beats, self.bodies = list(np.arange(0, 2, gap)), beats, ["eel"]

    def get_swim(self, body):
        return {"beats": self.beats}


for gap in (0.05, 0.1, 0.3):
    times, period = phases.choose_start(Outputs(gap, [{"start": 0.4, "period": 0.4}]))
    print("the start:", *(f"{time / period:.3f}" for time in times))
print("without a beat:", *(f"{time:.2f}" for time in phases.choose_start(Outputs(0.1, []))[0]))


class Points:
    bodies = ["eel", "cod"]

    def find(self, name):
        if name.startswith("cod"):
            raise flow.MissingData(name)


print("speed of:", history.find_point(Run("eel"))[0], "-", history.find_point(Points())[0])

film = Image.open("eel/plots/movie.gif")
print("frames of the gif:", film.n_frames)

# What is in the boundary layer decides nothing about the colours, what is in the wake does.
run = Run("eel")
fluid, bodies = run.read_fluid(run.times[-1]), run.read_bodies(run.times[-1])
limit = flow.get_vorticity_limit(fluid, bodies)
far = np.unique(fluid.triangles[flow.find_far_triangles(fluid, bodies)])
near = np.setdiff1d(np.arange(len(fluid.points)), far)
fluid.data["vorticity"][near] *= 100
print("points near the eel only, and others:", len(near) > 0, len(far) > 0)
print("limit with a stronger boundary layer:", flow.get_vorticity_limit(fluid, bodies) / limit)
fluid.data["vorticity"][far] *= 100
print("with a stronger wake:", flow.get_vorticity_limit(fluid, bodies) / limit)


class School:
    """The eel, and another one two lengths behind it."""

    def read_bodies(self, time):
        second = run.read(time, "eel")
        moved = type(second)(second.points + [2, 0], second.triangles, second.data, second.grid)
        return {"first": second, "second": moved}


width, height = flow.get_window(School(), run.times[-1:])
print("two eels fit into the picture:", 3 < width < 4, 0.8 < height < 1.2)
END

echo "* without ffmpeg"
mkdir tools
PATH=$PWD/tools "$CAUDAL_SOURCE_DIR/scripts/plot" eel --only energy --movie 2>&1 | sed 's/^/  /'
(PATH=$PWD/tools "$CAUDAL_SOURCE_DIR/scripts/plot" eel --only energy --movie >/dev/null 2>&1) || echo "  exit code $?"

# fit PAGE: what of it is beyond the right side of a window, but for tables that can be scrolled.
fit() {
  for width in 390 1280; do
    cat >frame.html <<END
<iframe src="file://$PWD/$1" style="width: ${width}px; height: 3000px; border: 0"></iframe><script>
onload = () => setTimeout(() => {
  const page = document.querySelector("iframe").contentDocument;
  const beyond = [...page.querySelectorAll("body *")].filter(
    part => part.getBoundingClientRect().right > $width + 1 && !part.closest(".wide, pre, svg"));
  document.body.dataset.result = [page.documentElement.scrollWidth <= $width, beyond.length,
    page.documentElement.dataset.drawn, page.querySelectorAll("details[open]").length];
}, 1500);
</script>
END
    open_page frame.html |
      sed -n "s/.*data-result=\"\([^\"]*\)\".*/$width pixels: fits, parts beyond, drawn, open details: \1/p"
  done
}
for run in eel salmon; do
  "$CAUDAL_SOURCE_DIR/scripts/report" $run --no-pictures --frames 3 >printed
  echo "* the page of $run"
  fit $run/report.html
  echo "joints: $(grep -c 'of joint 6' $run/report.html), modes: $(grep -c 'torque of mode' $run/report.html)"
  sed -n '/<h2>Next/,/<\/section/p' $run/report.html | sed -n 's/.*<code>\(scripts\/[a-z]*\).*/next: \1/p'
done

# view RUN COLOURS: a picture by ParaView has at least so many colours; true where there is none.
view() {
  "$CAUDAL_SOURCE_DIR/scripts/paraview" $1 >printed
  if command -v pvpython >/dev/null && command -v xvfb-run >/dev/null; then
    # A busy machine may start the display too late.
    for attempt in 1 2 3; do
      xvfb-run -a -s -noreset pvpython $1/view.py $1.png >printed 2>&1 && break
    done
    [ -s $1.png ] || cat printed
    /usr/bin/python3 -c '
import sys
from PIL import Image
colours = len(Image.open(sys.argv[1]).convert("RGB").getcolors(10**7))
print("a picture" if colours >= int(sys.argv[2]) else f"only {colours} colours")' $1.png $2
  else
    echo "a picture"
  fi
}
echo "* ParaView: $(view eel 500), $(view salmon 100)"
