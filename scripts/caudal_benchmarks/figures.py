# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures that benchmarks ask for, each with its reference and its gate."""

import dataclasses
import typing

import numpy as np

from . import oscillation

MILLIMETRE = 1e3


@dataclasses.dataclass
class Figure:
    """One line of the table: a value, its reference, and how far they may differ.

    The gate is a share of the reference (0.03), an interval (low, high) for the value,
    or None if nothing is demanded.
    """

    name: str
    value: float
    reference: typing.Optional[float] = None
    gate: typing.Union[float, tuple, None] = None
    note: str = ""

    @property
    def error(self):
        """(value - reference)/reference."""
        if self.reference is None or self.reference == 0:
            return None
        return self.value / self.reference - 1

    @property
    def is_ok(self):
        if self.gate is None:
            return True
        if isinstance(self.gate, tuple):
            return self.gate[0] <= self.value <= self.gate[1]
        return abs(self.error) <= self.gate


class Signal:
    """A column of the statistics, in units of `factor`, with its behaviour at the end."""

    def __init__(self, run, column, factor=1., scale=None, offset=0.,
                 n_periods=oscillation.PERIODS):
        self.name = column
        self.time = run.time
        self.values = factor * (run.get(column) - offset)
        largest = np.abs(self.values[len(self.values) // 2:]).max()
        self.end = oscillation.analyse(self.time, self.values, scale or largest or 1., n_periods)

    def get_mean_of_last_periods(self):
        """The mean over time, not (max + min)/2, from the begin of the last whole periods on."""
        last = self.time >= self.end.begin
        return np.trapz(self.values[last], self.time[last]) / np.ptp(self.time[last])


def describe(signal, label, mean=None, amplitude=None, frequency=None):
    """The figures of an oscillation. Each of the three arguments is (reference, gate)."""
    figures = []
    for name, value, wanted in (("mean", signal.end.mean, mean),
                                ("amplitude", signal.end.amplitude, amplitude),
                                ("frequency [Hz]", signal.end.frequency, frequency)):
        if wanted is not None:
            figures.append(Figure(f"{label} {name}", value, *wanted, note=signal.end.state))
    return figures


def check_body(run, gate=None, label=""):
    """How well the first body keeps its volumes in the second half of the run."""
    late = run.time >= 0.5 * run.time[-1]
    body = run.bodies[0]
    return [Figure(f"largest |area change|{label}",
                   abs(run.get(f"{body}: area change")[late]).max(), gate=gate),
            Figure(f"min J{label}", run.get(f"{body}: min J")[late].min()),
            Figure(f"max J{label}", run.get(f"{body}: max J")[late].max())]


def check_ledger(run, period, n_periods=oscillation.PERIODS):
    """The energy that nothing accounts for, of the work done in the last periods: within 1 %."""
    begin = run.time[-1] - n_periods * period
    change = {column: np.interp(run.time[-1], run.time, run.get(column))
              - np.interp(begin, run.time, run.get(column))
              for column in ("energy residual", "external work")}
    return Figure("energy residual [% of the work]",
                  100 * change["energy residual"] / change["external work"], gate=(-1., 1.))


def compare_force_accounts(run, body, direction):
    """The means of the force by its accounts, against that from the body force: within 1 %."""
    first = Signal(run, f"{body}: force {direction} of the fluid")
    reference = first.get_mean_of_last_periods()
    figures = []
    for column, label in ((f"{body}: force {direction} by feedback", "by feedback"),
                          (f"force {direction} by control volume", "by control volume")):
        if column + " [N/m]" in run.columns:
            other = Signal(run, column)
            other.end = first.end
            figures.append(Figure(f"mean force {direction} {label}",
                                  other.get_mean_of_last_periods(), reference, 0.01,
                                  "reference: from the body force"))
    return figures
