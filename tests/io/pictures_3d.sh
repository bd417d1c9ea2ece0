# SPDX-License-Identifier: LGPL-2.1-or-later
# Pictures of three dimensions, drawn without a display: vortices coloured by vorticity, slices and
# the surface of the body, a film and a report; colours and the level of Q by what lies off the body;
# sentences on what is not there; ParaView's view where it is installed.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"
unset DISPLAY

cat >ball.prm <<END
include $CAUDAL_SOURCE_DIR/tests/viscous/iterative_ball.prm
subsection Body ball
  set Monitored points = 0, 0, 0
  subsection Shape
    set Radius = 0.15
  end
end
subsection Refinement
  set Body margin = 1
end
subsection Solver
  set Tolerance = 1e-6
end
subsection Output
  set Folder             = ball
  set Interval of fields = 0.01
  set Additional fields  = Q
  subsection Surfaces
    set Write = true
  end
  subsection Slices
    set Planes   = 0.5, 0.5, 0.5 : 0, 0, 1; 0.7, 0.5, 0.5 : 1, 1, 0
  end
end
END
caudal ball.prm

# count PICTURE: whether it has colours of both signs, and what is white.
count() {
  /usr/bin/python3 - "$@" <<'END'
import sys

import numpy as np
from PIL import Image

for path in sys.argv[1:]:
    pixels = np.asarray(Image.open(path).convert("RGB")).astype(int)
    red, green, blue = pixels[..., 0], pixels[..., 1], pixels[..., 2]
    shares = (red > blue + 60, blue > red + 60, pixels.min(axis=2) > 250, pixels.max(axis=2) < 90)
    print(f"  {path}:", *(f"{name} {share.mean() > 0.004}" for name, share in
                          zip(("red", "blue", "white", "dark"), shares)))
END
}

echo "* pictures"
"$CAUDAL_SOURCE_DIR/scripts/plot" ball
count ball/plots/vortices.png ball/plots/slices.png ball/plots/surface.png

/usr/bin/python3 - <<'END'
import os
import sys

import numpy as np

sys.path.insert(0, os.environ["CAUDAL_SOURCE_DIR"] + "/scripts")
import caudal_setup  # noqa: F401: so that the package caudal is found
from caudal import Run
from caudal_plots import flow, space

# What is in the boundary layer decides nothing about colours and level, what is in the wake does.
run = Run("ball")
flow.NEAR = 0.3  # the cells are large
time = run.times[-1]
fluid, bodies = run.read_volume(time, "fluid"), run.read_volumes(time)
print("* colours\n  outputs:", len(run.times))
centres = fluid.points[fluid.cells].mean(axis=1)
far = np.unique(fluid.cells[flow.find_far(centres, bodies)])
near = np.setdiff1d(np.arange(len(fluid.points)), far)
print("  points near the ball only, and others:", len(near) > 0, len(far) > 0)
limit = flow.get_vorticity_limit(fluid, bodies)
q = space.get_q(fluid)
again = space.fields.Volume(fluid.points, fluid.cells,
                            {name: values for name, values in fluid.data.items() if name != "Q"})
print("  Q of the run and from its velocities: correlation above 0.9:",
      np.corrcoef(q, space.get_q(again))[0, 1] > 0.9)
fluid.data["vorticity"][near] *= 3
print("  limit with a stronger boundary layer:", flow.get_vorticity_limit(fluid, bodies) / limit)
fluid.data["vorticity"][far] *= 100
print("  with a stronger wake:", flow.get_vorticity_limit(fluid, bodies) / limit)
fluid.smooth = lambda values: values  # it would carry them farther
level = space.find_level(fluid, bodies)
fluid.data["Q"][near] *= 3
print("  level with a larger Q in the boundary layer:", space.find_level(fluid, bodies) / level)
fluid.data["Q"] *= 100
print("  level with a Q that is 100 times as large:", space.find_level(fluid, bodies) / level)

# The camera: what is at a larger x is farther to the right, what is at a larger z higher.
scene = space.Scene(run, time)
for direction, up, name, *_ in (*space.VIEWS, (*space.PERSPECTIVE, "in perspective")):
    right, above = space.render.get_axes(direction, up)
    print(f"  {name}: right", *(f"{x:.3f}" for x in right), "up", *(f"{x:.3f}" for x in above))
print("  the ball is in the middle of the picture from above:", *(f"{x:.1f}" for x in scene.place.ravel()))
END

echo "* a film"
"$CAUDAL_SOURCE_DIR/scripts/plot" ball --only slices --movie
echo "  outputs: $(ls ball/fields/fluid-*.vtu | wc -l), pictures: $(ls ball/plots/movie | wc -l)"
count ball/plots/movie/00003.png

echo "* a report"
"$CAUDAL_SOURCE_DIR/scripts/report" ball --frames 2 >printed || cat printed
sed -n 's/.*<h2>\([^<]*\)<\/h2>.*/  \1/p' ball/report.html
grep -o '<img src="data:image/[a-z]*' ball/report.html | sort | uniq -c | sed 's/^ */  /'
grep -c "Vortices, Q = " ball/report.html | sed 's/^/  vortices: /'

echo "* without a display"
mkdir tools
PATH=$PWD/tools "$CAUDAL_SOURCE_DIR/scripts/plot" ball --only vortices --only slices 2>&1 | sed 's/^/  /'

echo "* what is not there"
cp -r ball plain
rm plain/surfaces.pvd plain/slices.pvd
"$CAUDAL_SOURCE_DIR/scripts/plot" plain --only surface --only slices --only cruise 2>&1 | sed "s|$PWD/||; s/^/  /"

# A busy machine may start the display too late.
view() {
  "$CAUDAL_SOURCE_DIR/scripts/paraview" $1 >printed || cat printed
  if command -v pvpython >/dev/null && command -v xvfb-run >/dev/null; then
    for attempt in 1 2 3; do
      xvfb-run -a -s -noreset pvpython $1/view.py $1.png >printed 2>&1 && break
    done
    [ -s $1.png ] || cat printed
    /usr/bin/python3 -c '
import sys
from PIL import Image
print("  a picture:", len(Image.open(sys.argv[1]).convert("RGB").getcolors(10**7)) > 500)' $1.png
  else
    echo "  a picture: True"
  fi
}
echo "* ParaView"
view ball
