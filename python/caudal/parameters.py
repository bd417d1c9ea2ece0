# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run says of itself: its parameters, its model, and how far it has come."""

import pathlib
import re

from .errors import MissingData


def read_text(path):
    """The text of a file that every run has."""
    path = pathlib.Path(path)
    if not path.is_file():
        raise MissingData(f"There is no {path}; is this the output folder of a run?")
    return path.read_text(encoding="utf-8", errors="replace")


def parse_parameters(lines):
    """[(section path, entry, value, default or None)] of the lines of a parameter file."""
    section, entries = [], []
    for line in lines:
        line = line.strip()
        if line.startswith("subsection "):
            section.append(line.removeprefix("subsection ").strip())
        elif line == "end" and section:
            section.pop()
        elif match := re.match(r"set\s+(.*?)\s*=\s*(.*?)\s*(?:# default: ?(.*))?$", line):
            entries.append(("/".join(section), match[1], match[2],
                            None if match[3] is None else match[3].strip()))
    return entries


def read_parameters(folder):
    """[(section path, entry, value, default or None)] of a run's parameters.prm."""
    path = pathlib.Path(folder) / "parameters.prm"
    entries = parse_parameters(read_text(path).splitlines())
    if not entries:
        raise MissingData(f"{path} has no parameters; did the run start?")
    return entries


def read_model(folder):
    """Which model the run in a folder is of: immersed, potential, passage or elastic."""
    for section, entry, value, _ in read_parameters(folder):
        if not section and entry == "Model":
            return value
    return "immersed"


def read_progress(folder):
    """What manifest.txt says of the run: finished, unfinished or failed; None if there is none, as
    in results of versions before 0.2."""
    path = pathlib.Path(folder) / "manifest.txt"
    if not path.is_file():
        return None
    match = re.match(r"# .* The run is (\w+)\.", path.read_text(encoding="utf-8", errors="replace"))
    return match and match[1]
