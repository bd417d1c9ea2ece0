# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which cases of prm/ set which parameters."""

import pathlib
import re

from .parameters import find_parameters


def read_lines(path):
    """The lines of a parameter file without comments; continued ones are one line."""
    text = re.sub(r"#.*", "", path.read_text(encoding="utf-8"))
    return re.sub(r"\\\n\s*", " ", text).splitlines()


def read_values(path, section=()):
    """The values by "Section/Entry" that a parameter file and those that it includes set; the last
    one wins."""
    values, section = {}, list(section)
    for line in map(str.strip, read_lines(path)):
        if line.startswith("include "):
            name = line.removeprefix("include ").strip()
            values.update(read_values(find_included(path, name), section))
        elif line.startswith("subsection "):
            section.append(line.removeprefix("subsection ").strip())
        elif line == "end":
            section.pop()
        elif match := re.match(r"set\s+(.*?)\s*=\s*(.*)$", line):
            values["/".join([*section, match[1]])] = " ".join(match[2].split())
    return values


def find_included(path, name):
    """An included file: relative to the including one, else to the project."""
    beside = path.parent / name
    return beside if beside.exists() else pathlib.Path(name)


def find_in_plane(entry):
    """The entry that describes this one: the sides that 3D adds have those of 2D's."""
    for side, other in (("back", "bottom"), ("front", "top")):
        entry = re.sub(rf"(Boundary conditions/)({side})\b", rf"\1{other}", entry)
    return entry


def add_cases(parameters, root):
    """Adds to each parameter the cases that set it. Returns what the cases set and no model has."""
    unknown = []
    for path in sorted((root / "prm").rglob("*.prm")):
        case, values = str(path.relative_to(root)), read_values(path)
        model = values.get("Model", "immersed")
        for entry, value in values.items():
            found = find_parameters(parameters, find_in_plane(entry), model)
            if not found:
                unknown.append(f"{case}: {entry}")
            for parameter in found:
                cases = parameter.cases.setdefault(value, [])
                if case not in cases:  # two bodies may set the same
                    cases.append(case)
    return unknown
