# SPDX-License-Identifier: LGPL-2.1-or-later
"""The small run that the campaigns interrupt: kill, faults, power."""

import re

from caudal_plots.program import ENVIRONMENT

# Else the run starts a process beside it, which may outlive it.
ENVIRONMENT["OMPI_MCA_ess_singleton_isolated"] = "1"

STEP = 0.01  # [s]


def make_case(interval, slots=2):
    """Its parameters, with a checkpoint every so many steps; a body in a vortex, fields every two."""
    return f"""
set Bodies = disc
subsection Time
  set Step     = {STEP}
  set End time = {8 * STEP}
end
subsection Domain
  set Cells  = 4, 4
  set Levels = 3
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 1e-2
  set Initial velocity    = sin(pi*x)^2*sin(2*pi*y); -sin(2*pi*x)*sin(pi*y)^2
end
subsection Body disc
  subsection Shape
    set Type     = disc
    set Elements = 6, 8
    set Position = 0.6, 0.5
  end
  subsection Region body
    set Young's modulus = 3
  end
end
subsection Output
  set Folder             = results
  set Interval of fields = 0.02
end
subsection Checkpoint
  set Interval of steps = {interval}
  set Slots             = {slots}
end
"""


def read_results(results):
    """The table, the list of fields, and what it lists."""
    pvd = (results / "solution.pvd").read_text()
    return [(results / "statistics.txt").read_bytes(), pvd.encode(),
            *((results / name).read_bytes() for name in sorted(re.findall('file="(.*?)"', pvd)))]
