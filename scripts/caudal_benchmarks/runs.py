# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of caudal that are not made twice."""

import hashlib
import pathlib
import re
import subprocess
import time

from caudal import Run
from caudal_plots.program import (ENVIRONMENT, PROGRAM, RESULTS, ROOT, get_mpirun,
                                   read_program)


class RunError(Exception):
    """A run failed; the text is what it said."""


def read_with_includes(prm):
    """The text of a .prm file, the files that it includes in their places, without comments."""
    lines = []
    for line in prm.read_text(encoding="utf-8").splitlines():
        if match := re.match(r"\s*include\s+(\S+)", line):
            lines += read_with_includes(prm.parent / match.group(1))
        elif line.strip() and not line.lstrip().startswith("#"):
            lines.append(line)
    return lines


def get_fingerprint(prm, overrides):
    """Of all that decides on the results: the case, the overrides and the program."""
    text = "\n".join(read_with_includes(ROOT / prm) + list(overrides))
    return hashlib.sha256(text.encode() + read_program()).hexdigest()


def run(prm, folder, overrides=(), ranks=1):
    """Runs a case into a folder unless that very run has ended there; returns it."""
    folder = pathlib.Path(folder)
    stamp, fingerprint = folder / "fingerprint.txt", get_fingerprint(prm, overrides)
    if stamp.is_file() and stamp.read_text(encoding="utf-8").split()[0] == fingerprint:
        return Run(folder)
    command = [*get_mpirun(ranks), str(PROGRAM), prm, "-D", f"Output/Folder={folder}",
               "-D", "Output/Existing results=replace"]
    for override in overrides:
        command += ["-D", override]
    begin = time.time()
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False,
                            stdin=subprocess.DEVNULL, env=ENVIRONMENT)
    if result.returncode != 0:
        raise RunError(f"{' '.join(command)}: {result.stderr.strip()}")
    stamp.write_text(f"{fingerprint}\n{time.time() - begin:.0f} s on {ranks} ranks\n",
                     encoding="utf-8")
    return Run(folder)
