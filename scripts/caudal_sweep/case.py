# SPDX-License-Identifier: LGPL-2.1-or-later
"""A parameter file as a sweep sees it: its values before it runs, and what decides on its results."""

import hashlib
import pathlib
import re
import subprocess

from caudal.parameters import parse_parameters
from caudal_benchmarks.runs import read_with_includes
from caudal_plots.program import ENVIRONMENT, PROGRAM

from . import SweepError


def call(arguments, **options):
    """What the program prints, and its exit code."""
    result = subprocess.run([str(PROGRAM), *map(str, arguments)], stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False, env=ENVIRONMENT, **options)
    return result.stdout, result.returncode


def find_cause(text, code):
    """Why a run failed, in a sentence: its error or, without one, how it ended."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    for line in lines:
        if line.startswith("Error: "):
            return line.removeprefix("Error: ")
    if code < 0:
        return f"killed by signal {-code}"
    return f"exit code {code}" + (f": {lines[-1]}" if lines else ", and it said nothing")


class Case:
    """A .prm file and what is set on the command line for all of its runs."""

    def __init__(self, prm, overrides=()):
        self.prm = pathlib.Path(prm)
        self.overrides = list(overrides)
        for override in self.overrides:
            if not override.partition("=")[0].strip() or "=" not in override:
                raise SweepError(f"-D <{override}> can't be understood. Write "
                                 "-D \"Section/Entry=value\".")
        try:
            self.lines = read_with_includes(self.prm)
        except (OSError, UnicodeDecodeError) as error:
            raise SweepError(f"{prm} can't be read: {error}. Give a parameter file.") from error
        self.values = {f"{section}/{entry}".lstrip("/"): value for section, entry, value, _
                       in parse_parameters(line.partition("#")[0] for line in self.lines)}
        self.values.update((part.strip() for part in override.split("=", 1))
                           for override in self.overrides)

    @property
    def name(self):
        return self.prm.stem

    @property
    def model(self):
        return self.values.get("Model", "immersed")

    def get(self, entry, default=None):
        """The value, as text, of an entry that the file or the command line sets."""
        return self.values.get(entry, default)

    def make_options(self, point):
        """The program's options for a point of the sweep."""
        settings = [*self.overrides, *(f"{entry}={value}" for entry, value in point.items())]
        return [word for setting in settings for word in ("-D", setting)]

    def get_fingerprint(self, point):
        """Of all that decides on the results of a run: the file, what it includes, the settings,
        and the tables and meshes that are named in it. Not of the program."""
        settings = [*self.overrides, *(f"{entry}={value}" for entry, value in sorted(point.items()))]
        digest = hashlib.sha256("\n".join([*self.lines, *settings]).encode())
        for value in [*self.values.values(), *point.values()]:
            for folder in (self.prm.parent, pathlib.Path()):
                path = folder / value
                if len(value) < 200 and re.search(r"\w", value) and path.is_file():
                    digest.update(path.read_bytes())
                    break
        return digest.hexdigest()

    def check(self, point):
        """SweepError if the program does not know the file or an entry: no run could do with it."""
        text, code = call(["--check", "--fast", self.prm, *self.make_options(point)])
        cause = find_cause(text, code)
        if code != 0 and re.search(r"there is no (entry|section)|can't be read|can't be opened", cause):
            raise SweepError(cause)
