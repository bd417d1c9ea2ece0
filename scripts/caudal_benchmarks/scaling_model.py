# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model of what a step costs on many ranks, by what was measured on few.

A step takes the processor time outside of MPI of the rank that has most to do, the time of the
messages that a rank sends, and in 2D the factorisation of the dense matrix between the ranks. Each
is a sum of few terms whose factors are fitted to the measured ranks."""

import dataclasses
import math
import time

import numpy

RANKS = (16, 64, 256, 1024)
LATENCY = 2e-6  # of a message [s]
BANDWIDTH = 1e9  # of a rank [B/s]


def measure_factorisation_rate(n=1500):
    """Operations a second of an LU factorisation of a dense matrix, in processor time."""
    matrix = numpy.random.default_rng(1).random((n, n)) + n * numpy.eye(n)
    begin = time.process_time()
    numpy.linalg.solve(matrix, matrix[0])
    return 2 / 3 * n ** 3 / (time.process_time() - begin)


def fit(ranks, values, terms):
    """Factors, none negative, of the terms whose sum is close to the values, each relative to its
    size; terms that would be negative are left out, and so are those within the scatter."""
    ranks, values = numpy.array(ranks, float), numpy.array(values, float)
    used = list(range(len(terms)))
    while True:
        matrix = numpy.array([[terms[k](p) for k in used] for p in ranks]) / values[:, None]
        factors, *_ = numpy.linalg.lstsq(matrix, numpy.ones(len(ranks)), rcond=None)
        dropped = find_doubtful(matrix, factors) if len(used) > 1 else None
        if dropped is None:
            break
        used.pop(dropped)
    result = numpy.zeros(len(terms))
    result[used] = factors
    return result


def find_doubtful(matrix, factors):
    """The number of a term that is negative or less than twice its standard error, the worst one."""
    freedom = len(matrix) - len(factors)
    scatter = numpy.linalg.norm(matrix @ factors - 1) ** 2 / freedom if freedom > 0 else 0.
    errors = numpy.sqrt(numpy.diag(numpy.linalg.pinv(matrix.T @ matrix)) * scatter)
    margins = factors - 2 * errors
    margins[0] = factors[0]  # what is there on any number of ranks is not left out for its scatter
    worst = int(numpy.argmin(margins))
    return worst if margins[worst] < 0 else None


def evaluate(factors, terms, ranks):
    return sum(factor * term(ranks) for factor, term in zip(factors, terms))


def constant(_):
    return 1.


def share(ranks):
    return 1 / ranks


def proportional(ranks):
    return ranks


def logarithm(ranks):
    return math.log2(ranks)


def ring(ranks):
    """Bytes that a rank sends for each one that is summed over all, in a ring."""
    return 2 * (ranks - 1) / ranks


def ring_of_all(ranks):
    """The same of vectors that are as long as there are ranks."""
    return ranks * ring(ranks)


def ring_of_interface(ranks):
    """The same of a matrix with an entry for each pair of cuts, in bytes."""
    return 8 * (ranks - 1) ** 2 * ring(ranks)


@dataclasses.dataclass
class Terms:
    """Of which terms work, memory, messages and bytes are sums."""
    work: tuple
    bytes: tuple
    messages: tuple = (constant, logarithm)


def choose_terms(series):
    work = {"nothing": (constant, share), "water": (constant,),
            "bodies": (constant, proportional)}[series.grows]
    if series.dim == 2:
        return Terms(work, (ring if series.grows == "nothing" else ring_of_all, ring_of_interface))
    return Terms(work, (constant, proportional if series.grows == "bodies" else logarithm))


class Model:
    """The model of a series, by the costs on two ranks and more."""

    def __init__(self, series, costs, rate):
        self.terms, self.rate = choose_terms(series), rate
        self.ranks = [n for n in costs if n > 1]
        used = [costs[n] for n in self.ranks]
        self.cut = 0.
        self.work = self._fit([max(cost.work) for cost in used], self.terms.work)
        self.messages = self._fit([max(cost.messages) for cost in used], self.terms.messages)
        self.bytes = self._fit([max(cost.bytes) for cost in used], self.terms.bytes)
        self.memory = self._fit([max(cost.long.memory) for cost in used], self.terms.work)
        if series.dim == 2:
            self._use_interface(used, series.dim * (2 * series.cells[1] + 1))

    def _fit(self, values, terms):
        return fit(self.ranks, values, terms)

    def _use_interface(self, used, least):
        """Unknowns in a cut, by the bytes, but no fewer than in a cut through the coarsest cells;
        their share of bytes, work and memory is on its own."""
        self.cut = max(math.sqrt(self.bytes[1]), least)
        rest = [max(cost.bytes) - self.cut ** 2 * ring_of_interface(n)
                for n, cost in zip(self.ranks, used)]
        self.bytes = (*self._fit([max(value, 1.) for value in rest], self.terms.bytes[:1]),
                      self.cut ** 2)
        self.work = self._fit(
            [max(max(cost.work) - self.get_interface_time(n), 1e-3 * max(cost.work))
             for n, cost in zip(self.ranks, used)], self.terms.work)
        self.memory = self._fit(
            [max(cost.long.memory) - self.get_interface_memory(n)
             for n, cost in zip(self.ranks, used)], self.terms.work)

    def get_interface(self, ranks):
        """Unknowns between the ranks."""
        return self.cut * (ranks - 1)

    def get_interface_time(self, ranks):
        return 2 / 3 * self.get_interface(ranks) ** 3 / self.rate

    def get_interface_memory(self, ranks):
        """[MiB] of the dense matrix: its sum, its factors, and what a rank adds."""
        return 3 * 8 * self.get_interface(ranks) ** 2 / 2 ** 20

    def get_seconds(self, ranks):
        """Of work, of the matrix between ranks, of latencies and of bytes."""
        return (evaluate(self.work, self.terms.work, ranks), self.get_interface_time(ranks),
                LATENCY * evaluate(self.messages, self.terms.messages, ranks),
                evaluate(self.bytes, self.terms.bytes, ranks) / BANDWIDTH)

    def get_memory(self, ranks):
        return evaluate(self.memory, self.terms.work, ranks) + self.get_interface_memory(ranks)


def make_row(series, model, ranks, first):
    """Seconds and memory on so many ranks; @p first: the work of a step on one rank."""
    seconds = model.get_seconds(ranks)
    total = sum(seconds)
    gain = first / total * (1 if series.grows == "nothing" else ranks)
    return (f"{ranks:,}", *(f"{part:.2g}" if part < 100 else f"{part:,.0f}" for part in seconds),
            f"{total:.2g}" if total < 100 else f"{total:,.0f}", f"{gain:.2g}",
            f"{100 * gain / ranks:.2g} %", f"{model.get_memory(ranks):,.0f}")


HEADER = ("ranks", "work s", "dense matrix s", "latencies s", "bytes s", "sum s", "times one rank",
          "efficiency", "MiB of a rank")

ASSUMPTIONS = """
None of the figures in this section was measured. A step is the sum of

- **work**: processor time outside of MPI of the rank that has most to do. With one size it is a part that is the same on all
  numbers of ranks (bodies, which all ranks have, and what is between their slices) and one that is shared; with water in proportion it is
  constant; with bodies in proportion it may grow with them. Fitted to the measured ranks from 2 on; a growth within the scatter
  is taken for none.
- **dense matrix** (2D): 2/3 n^3 operations of each rank for the n unknowns between strips, at the {rate:.0f} Gflop/s that a dense
  LU factorisation reached here. n is the number of cuts times the unknowns of a cut, which follow from the measured bytes; they are
  no fewer than in a cut through the coarsest cells.
- **latencies**: {latency:.0f} us for each message that a rank sends, an assumption; their number grows with log2 of the ranks as fitted.
- **bytes**: those that a rank sends, at an assumed {bandwidth:.0f} GB/s for each rank (a node's link of 200 Gbit/s, of which 24 ranks
  share). In 2D they are vectors of all unknowns and the dense matrix, summed in rings.

Left out: waiting for others beyond the rank that has most to do, so that rank 0's work between two messages counts once, but
not what it does while all wait in turns; the memory bandwidth that ranks of a node share; regridding; files. Iterations are
those of the largest measured number of ranks, and strips and slabs those of the long channel, whose surfaces don't grow.
Where times exceed those of fewer ranks, more ranks are a loss; the formulas do not regard that strips need columns of cells."""


def can_model(costs):
    return len([n for n in costs if n > 1]) > 2 and all(
        cost.work and cost.messages for cost in costs.values())


def report_model(report, measured):
    """Tables of the model for all series that were measured on three numbers of ranks beyond one."""
    measured = {name: (series, costs) for name, (series, costs) in measured.items()
                if can_model(costs) and 1 in costs}
    if not measured:
        return
    rate = measure_factorisation_rate()
    report.add("", "## A model for 16 to 1,024 ranks: not measured",
               *ASSUMPTIONS.format(rate=rate / 1e9, latency=LATENCY * 1e6,
                                   bandwidth=BANDWIDTH / 1e9).split("\n"))
    for series, costs in measured.values():
        model = Model(series, costs, rate)
        report.add("", f"**{series.title}** (model)."
                   + (f" {model.cut:.0f} unknowns in a cut." if model.cut else ""))
        report.add_table(HEADER, [make_row(series, model, ranks, costs[1].work[0])
                                  for ranks in RANKS])
