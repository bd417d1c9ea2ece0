# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which outputs of the fields show a tail beat, or the start, at even distances in time."""

import numpy as np

from . import MissingData

SEQUENCE = (6, 5, 4)             # numbers of pictures, the most first
OUTLINES = (12, 11, 10, 9, 8)    # of outlines
EVEN = 0.02                      # of the period: what a phase may be off
START_UP = 0.5                   # [s] that show the start of a run without a whole beat


def choose_phases(times, start, period, counts):
    """The outputs at the most evenly distributed phases of the beat, as many as the first of the
    counts that are even; all of the beat if there are fewer, and the nearest to its start if
    there is none."""
    times = np.asarray(times)
    inside = times[(times > start - 1e-9 * period) & (times < start + period * (1 - 1e-9))]
    if len(inside) == 0:
        return [times[np.argmin(abs(times - start))]]
    choices = []
    for count in (n for n in counts if n <= len(inside)):
        for first in inside[inside < start + period / count]:
            wanted = first + period * np.arange(count) / count
            nearest = inside[np.argmin(abs(inside[:, None] - wanted), axis=0)]
            error = abs(nearest - wanted).max() / period
            choices.append((max(error, EVEN), -count, sorted(set(nearest))))
    return min(choices, key=lambda choice: choice[:2])[2] if choices else list(inside)


def choose_start(run):
    """The outputs that show the start, up to the end of the first whole beat, and the period of
    that beat [s], None if there is none. At time 0 nothing moves yet."""
    try:
        beat = run.get_swim(run.bodies[0])["beats"][0]
        end, period = beat["start"] + beat["period"], beat["period"]
    except (MissingData, IndexError, KeyError, OSError):
        end, period = START_UP, None
    times = [time for time in run.times if 0 < time <= end * (1 + 1e-9)]
    if not times:
        return run.times[-1:], period
    stride = max(len(times) // SEQUENCE[0], 1)
    return times[::-1][:SEQUENCE[0] * stride:stride][::-1], period
