# SPDX-License-Identifier: LGPL-2.1-or-later
"""A parameter file as a sweep sees it: its values before it runs, and what decides on its results."""

import functools
import hashlib
import pathlib
import re
import subprocess

from caudal.parameters import parse_parameters
from caudal_benchmarks.runs import read_with_includes
from caudal_plots.program import ENVIRONMENT, PROGRAM

from . import SweepError

# Entries that results do not depend on.
WITHOUT_EFFECT = re.compile(r"Output/Folder|Output/Existing results|Checkpoint/.*")


def call(arguments, **options):
    """What the program prints, and its exit code."""
    result = subprocess.run([str(PROGRAM), *map(str, arguments)], stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False, env=ENVIRONMENT, **options)
    return result.stdout, result.returncode


@functools.cache
def check_fast(*arguments):
    """What the program says of a case before it tries a step: on fine grids in 3D after a minute, so
    each is asked once."""
    return call(["--check", "--fast", *arguments])


def find_error(text):
    """The program's error, which stands at the start of a line, as MPI's don't; None without one."""
    return next((line.removeprefix("Error: ").strip() for line in text.splitlines()
                 if line.startswith("Error: ")), None)


def find_cause(text, code):
    """Why a run failed, in a sentence: its error or, without one, how it ended."""
    if error := find_error(text):
        return error
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    if code < 0:
        return f"killed by signal {-code}"
    return f"exit code {code}" + (f": {lines[-1]}" if lines else ", and it said nothing")


def join_lines(lines):
    """The lines without comments; those that a backslash continues are one."""
    return "\n".join(line.partition("#")[0].rstrip() for line in lines).replace("\\\n", " ").split("\n")


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
                       in parse_parameters(join_lines(self.lines))}
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

    def get_settings(self, point):
        """All that is set in a run and decides on its results."""
        return {entry: value for entry, value in {**self.values, **point}.items()
                if not WITHOUT_EFFECT.fullmatch(entry)}

    def get_files(self, point):
        """{name: digest} of the tables and meshes that are named in the settings."""
        files = {}
        for value in self.get_settings(point).values():
            for folder in (self.prm.parent, pathlib.Path()):
                path = folder / value
                if len(value) < 200 and re.search(r"\w", value) and path.is_file():
                    files[value] = hashlib.sha256(path.read_bytes()).hexdigest()
                    break
        return files

    def read_units(self):
        """{entry: unit} as the descriptions of the parameters tell them; not where there are several."""
        text, code = call(["--print-parameters", "prm", self.prm, *self.make_options({})])
        units, words, section = {}, "", []
        for line in map(str.strip, text.splitlines() if code == 0 else []):
            if line.startswith("#"):
                words += line.removeprefix("#")
                continue
            if line.startswith("subsection "):
                section.append(line.removeprefix("subsection ").strip())
            elif line == "end" and section:
                section.pop()
            elif match := re.match(r"set\s+(.*?)\s*=", line):
                found = set(re.findall(r"\[((?:[\w%/^. ()-]|\*)+)\]", words)) - {"1", "-"}
                if len(found) == 1:
                    units["/".join([*section, match[1]])] = found.pop()
            words = ""
        return units

    def check(self, point):
        """SweepError if the program does not know the file or an entry: no run could do with it."""
        cause = self.find_fault(point)
        if re.search(r"there is no (entry|section)|can't be read|can't be opened", cause):
            raise SweepError(cause)

    def find_fault(self, point):
        """Why the program would refuse a run; empty if it would not. That it could not be started, as
        MPI's folders may be lacking for a moment, says nothing of the run."""
        text, code = check_fast(self.prm, *self.make_options(point))
        return find_cause(text, code) if code != 0 and find_error(text) else ""
