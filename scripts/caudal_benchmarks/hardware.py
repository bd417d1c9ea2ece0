# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine on which a measurement was made."""

import pathlib
import re
import time

import numpy


def get_processor():
    text = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    names = re.findall(r"^model name\s*:\s*(.+)$", text, re.MULTILINE)
    return f"{len(names)} x {names[0]}" if names else "unknown processor"


def measure_bandwidth(length=2 ** 25, repetitions=5):
    """Bytes a second that one core moves in z = x + y (McCalpin's STREAM, "add"); best of some."""
    x, y, z = (numpy.full(length, value) for value in (1., 2., 0.))
    seconds = []
    for _ in range(repetitions):
        begin = time.perf_counter()
        numpy.add(x, y, out=z)
        seconds.append(time.perf_counter() - begin)
    return 3 * x.nbytes / min(seconds)
