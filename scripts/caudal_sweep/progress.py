# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the runs of a sweep have come, from what they print."""

import pathlib
import re
import time

TAIL = 20000  # bytes of what a run printed that are looked through
LINE = re.compile(r"t = (\S+) of (\S+) s .* ([\d:]+) left")


def read_duration(text):
    """The seconds of "1:02:03" or "2:03"."""
    return sum(float(part) * 60**k for k, part in enumerate(reversed(text.split(":"))))


def read_printed(path):
    """(share of the simulated time, seconds left) of the last line that tells them; (None, None)."""
    path = pathlib.Path(path)
    try:
        with open(path, "rb") as file:
            file.seek(max(path.stat().st_size - TAIL, 0))
            text = file.read().decode("utf-8", errors="replace")
        age = time.time() - path.stat().st_mtime
    except OSError:
        return None, None
    found = LINE.findall(text)
    if not found or float(found[-1][1]) <= 0:
        return None, None
    now, end, left = found[-1]
    return float(now) / float(end), max(read_duration(left) - age, 0.)


def describe_roughly(seconds):
    """A duration of which only the size is known."""
    if seconds < 90:
        return f"{max(round(seconds, -1), 10):.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def estimate_rest(running, n_waiting, ended, n_at_once):
    """Seconds until all runs have ended; None if nothing is known. @p running: (seconds left or None,
    seconds since the start) of each; @p ended: the seconds that others took."""
    left = [rest for rest, _ in running if rest is not None]
    lengths = [rest + past for rest, past in running if rest is not None] + list(ended)
    mean = sum(lengths) / max(len(lengths), 1)
    if any(rest is None and past >= mean for rest, past in running) or not lengths:
        return None  # others were shorter than this one is already
    left += [max(mean - past, 0.) for rest, past in running if rest is None]
    return (sum(left) + mean * n_waiting) / n_at_once if n_waiting else max(left, default=0.)


def describe(printed, starts, n_waiting, ended, n_at_once):
    """The line "2 running: 45 %, 51 %; about 11 min left". @p printed and @p starts: the file and
    the time of the start of each running one."""
    told = [read_printed(path) for path in printed]
    now = time.time()
    rest = estimate_rest([(left, now - start) for (_, left), start in zip(told, starts)],
                         n_waiting, ended, n_at_once)
    shares = ", ".join("no time told yet" if share is None else f"{100 * share:.0f} %" for share, _ in told)
    return (f"{len(told)} running: {shares}" + (f"; {n_waiting} waiting" if n_waiting else "")
            + ("" if rest is None else f"; about {describe_roughly(rest)} left"))
