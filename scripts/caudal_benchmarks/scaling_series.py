# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of scripts/benchmark scaling: one size on all ranks, and sizes in proportion to them."""

import dataclasses
import re

from caudal_plots.program import ROOT

from .runs import read_with_includes
from .timed_run import get_step

# Grids follow the bodies alone, so that they are the same on all ranks; each step factorises.
STEADY = ("Refinement/Vorticity threshold=0", "Refinement/Vorticity levels=0",
          "Refinement/Largest number of cells=1000000",
          "Solver/Reuse factorisation=never", "Output/Interval of fields=1e6",
          "Coupling/Accept unresolved bodies=true")


@dataclasses.dataclass
class Series:
    name: str
    title: str
    prm: str
    size: tuple  # of the domain of one rank [m]
    cells: tuple  # of its coarsest level
    levels: int
    grows: str  # in proportion to the ranks: "nothing", "water" or "bodies"
    steps: tuple  # of the shorter and the longer run

    @property
    def dim(self):
        return len(self.size)

    def get_overrides(self, ranks, steps):
        """Domains are put one behind the other along x."""
        pieces = 1 if self.grows == "nothing" else ranks
        join = ",".join
        return (*STEADY, f"Domain/Size={join(map(str, (pieces * self.size[0], *self.size[1:])))}",
                f"Domain/Cells={join(map(str, (pieces * self.cells[0], *self.cells[1:])))}",
                f"Domain/Levels={self.levels}", f"Time/End time={steps * get_step(self.prm)}")

    def write_case(self, folder, ranks):
        """The .prm file of a run: that of the series, or one with a body in each piece."""
        if self.grows != "bodies" or ranks == 1:
            return ROOT / self.prm
        path = folder / f"{self.name}_{ranks}.prm"
        lines = repeat_body(read_with_includes(ROOT / self.prm), ranks, self.size[0])
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path


def find_end(lines, begin):
    """The line behind the `end` of the subsection that begins there."""
    depth = 0
    for number in range(begin, len(lines)):
        words = lines[number].split()
        depth += {"subsection": 1, "end": -1}.get(words[0] if words else "", 0)
        if depth == 0:
            return number + 1
    raise ValueError(f"a subsection has no end: {lines[begin]}")


def repeat_body(lines, number, distance):
    """A case with one body, as one with so many, each @p distance behind the one before it."""
    begin = next(k for k, line in enumerate(lines) if line.split()[:2] == ["subsection", "Body"])
    end = find_end(lines, begin)
    name = lines[begin].split()[2]
    names = [f"{name}{k}" for k in range(number)]
    result = [re.sub(r"(set Bodies\s*=).*", rf"\1 {', '.join(names)}", line)
              for line in lines[:begin]]
    for k, new_name in enumerate(names):
        result.append(f"subsection Body {new_name}")
        for line in lines[begin + 1:end]:
            if match := re.match(r"(\s*set Position\s*=)\s*([^,]+)(,.*)", line):
                line = f"{match.group(1)} {float(match.group(2)) + k * distance:.12g}{match.group(3)}"
            result.append(line)
    return result + lines[end:]


FISH, ELLIPSOID = "prm/fish.prm", "prm/benchmarks/ellipsoid.prm"
SERIES = {series.name: series for series in (
    Series("plane", "One size, 2D: a fish, direct method", FISH, (20, 3), (280, 42), 4, "nothing",
           (2, 12)),
    Series("plane_water", "Water in proportion, 2D: a fish in a longer and longer channel", FISH,
           (20, 3), (180, 27), 4, "water", (2, 12)),
    Series("plane_bodies", "Bodies in proportion, 2D: a fish in each piece of the channel", FISH,
           (20, 3), (180, 27), 4, "bodies", (2, 12)),
    Series("space", "One size, 3D: an ellipsoid, iterative method", ELLIPSOID, (2, 1, 1), (4, 2, 2),
           5, "nothing", (2, 3)),
    Series("space_water", "Water in proportion, 3D: an ellipsoid in a longer and longer channel",
           ELLIPSOID, (2, 1, 1), (16, 8, 8), 2, "water", (2, 3)),
    Series("space_bodies", "Bodies in proportion, 3D: an ellipsoid in each piece of the channel",
           ELLIPSOID, (2, 1, 1), (4, 2, 2), 4, "bodies", (2, 3)))}
