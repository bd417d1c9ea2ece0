# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads the module of a script, after what it needs has been installed."""

import importlib
import pathlib
import shutil
import subprocess
import sys

SETUP = pathlib.Path(__file__).resolve().parent / "setup"
# The package caudal, which reads results: in the sources, and in PREFIX/share/caudal.
sys.path.insert(0, str(SETUP.parent.parent / "python"))


def load_main(package):
    """The function main() of caudal_<package>; ends with a sentence if that can't be loaded."""
    for has_tried in (False, True):
        try:
            importlib.invalidate_caches()
            return importlib.import_module(f"caudal_{package}.main").main
        except ImportError as error:
            if not has_tried and SETUP.exists() and shutil.which("dpkg-query"):
                subprocess.run([str(SETUP), "--no-build", "plots"], stdout=sys.stderr, check=False)
                continue
            sys.exit(f"{sys.argv[0]} needs pandas, matplotlib and VTK for {sys.executable}: {error}.\n"
                     "Debian's packages python3-pandas, python3-matplotlib and python3-vtk9 (or python3-paraview, "
                     "which brings VTK, too) have them.")
