# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run says in words: its log."""

import re

from caudal.parameters import read_progress, read_text


# The beginning of the paragraph of the costs, the last of a run.
COSTS = r"\d+ steps in |CPU of rank 0"


class Log:
    """log.txt in parts: head, warnings, sizes, the last state and where the time went."""

    def __init__(self, folder):
        self.lines = read_text(folder / "log.txt").splitlines()
        self.progress = read_progress(folder)

    @property
    def banner(self):
        """Version, machine and libraries: what stands before the first empty line."""
        end = self.lines.index("") if "" in self.lines else len(self.lines)
        return self.lines[:end]

    @property
    def warnings(self):
        """Warnings, failed steps and errors, each once, with the number of times."""
        counts = {}
        for line in self.lines:
            if re.match(r"(Warning|Error)\b|The step from .* failed|The last good state", line):
                counts[line] = counts.get(line, 0) + 1
        return list(counts.items())

    @property
    def means_nothing(self):
        """Whether the program says that a body is far too thin for the grid."""
        return any("RESULTS MEAN NOTHING" in line for line in self.lines)

    @property
    def end(self):
        """How the run, or its last part if it was resumed, came to its end; None if it did not."""
        if self.progress in ("finished", "failed"):
            return self.progress
        resumptions = [i for i, line in enumerate(self.lines) if line.startswith("Resumed from")]
        last_part = self.lines[resumptions[-1]:] if resumptions else self.lines
        for line in last_part:
            if stop := re.match(r"Stopped (on request|by \S+ .* limit)", line):
                return "stopped " + stop[1]
        has_costs = any(re.match(COSTS, line) for line in last_part)
        return "finished" if has_costs and self.progress is None else None

    @property
    def costs(self):
        """The paragraph of the costs, or None while the run goes on."""
        for line in reversed(self.lines):
            if re.match(COSTS, line):
                return line
        return None

    @property
    def timings(self):
        """[(section, seconds, per cent)] of the wall time."""
        rows = [re.match(r"\s{2}(\S.*?)\s{2,}([\d.]+) s\s+([\d.]+) %$", line) for line in self.lines]
        return [(row[1], float(row[2]), float(row[3])) for row in rows if row]

    def get_facts(self):
        """The lines on bodies, grid and method between the banner and the first progress."""
        start = len(self.banner)
        facts = []
        for line in self.lines[start:]:
            if re.match(r"t = |#|Table of phases|frequency \[", line):
                break
            if line.strip() and not line.startswith(("Warning", "Override")):
                facts.append(line)
        return facts
