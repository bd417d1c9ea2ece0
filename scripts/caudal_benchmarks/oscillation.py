# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a signal does in the end: steady, periodic, or neither."""

import dataclasses

import numpy as np

PERIODS = 5  # at most, from the end, over which figures are averaged
UNEQUAL = 0.7  # of the swing of a beat: the next one, if smaller than this, belongs to its period
TOLERANCE = 0.02  # how much periods and amplitudes may differ and still count as periodic


@dataclasses.dataclass
class Oscillation:
    """Mean (max + min)/2, amplitude (max - min)/2 and frequency of the last whole periods."""

    mean: float
    amplitude: float
    frequency: float
    begin: float
    maximum: float
    state: str  # a sentence on whether the signal is steady or periodic

    @property
    def is_settled(self):
        return self.state.startswith(("steady", "periodic"))


def find_rises(time, values):
    """The times at which the signal passes its mean upwards, after having been well below it."""
    middle, least = (values.max() + values.min()) / 2, 0.1 * np.ptp(values)
    rises, is_low, candidate = [], False, None
    for i in range(1, len(values)):
        if values[i - 1] < middle <= values[i]:
            weight = (middle - values[i - 1]) / (values[i] - values[i - 1])
            candidate = time[i - 1] + weight * (time[i] - time[i - 1])
        if values[i] < middle - least:
            is_low = True
        elif is_low and values[i] > middle + least:
            is_low = False
            rises.append(candidate)
    return rises


def join_unequal_beats(time, values, rises):
    """Every second rise, if one beat swings far less than the next: then both make a period."""
    swings = [np.ptp(values[(time >= a) & (time <= b)]) for a, b in zip(rises, rises[1:])]
    if len(swings) < 4:
        return rises
    odd, even = np.median(swings[-1::-2]), np.median(swings[-2::-2])
    return rises if min(odd, even) > UNEQUAL * max(odd, even) else rises[-1::-2][::-1]


def analyse(time, values, scale, n_periods=PERIODS):
    """The end of a signal whose changes matter if they are not small beside `scale`."""
    late = time >= time[-1] - 0.1 * (time[-1] - time[0])
    if np.ptp(values[late]) < 2e-3 * scale:
        change = np.ptp(values[late])
        return Oscillation(values[-1], 0., 0., time[late][0], values[-1],
                           f"steady: changes by {change:.1e} in the last {np.ptp(time[late]):.3g} s")
    half = time >= time[0] + 0.5 * (time[-1] - time[0])
    # A signal whose amplitude still grows is judged by its end.
    rises = find_rises(time[half], values[half])
    if len(rises) > n_periods + 1:
        last = time >= rises[-n_periods - 2]
        rises = find_rises(time[last], values[last])
    rises = join_unequal_beats(time, values, rises)[-n_periods - 1:]
    if len(rises) < 2:
        return Oscillation((values[half].max() + values[half].min()) / 2, np.ptp(values[half]) / 2,
                           0., time[half][0], values[half].max(),
                           "neither steady nor periodic: no whole period")
    # Drag and x of a flag have two periods a swing, one for each side, which differ by its
    # mean deflection; the references give the extremes of both.
    swings = list(zip(rises, rises[2:])) or [tuple(rises)]
    pairs = [values[(time >= a) & (time <= b)] for a, b in swings]
    tops = np.array([pair.max() for pair in pairs])
    bottoms = np.array([pair.min() for pair in pairs])
    lengths = np.diff(rises)
    amplitudes = (tops - bottoms) / 2
    spread = max(np.ptp(lengths) / lengths.mean(), np.ptp(amplitudes) / amplitudes.mean())
    word = "periodic" if spread < TOLERANCE else "not periodic"
    return Oscillation(((tops + bottoms) / 2).mean(), amplitudes.mean(), 1 / lengths.mean(),
                       rises[0], tops.mean(), f"{word}: periods and amplitudes of the last "
                       f"{len(rises) - 1} periods differ by {100 * spread:.2g} %")
