# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program that scripts run, and the environment in which it uses one core for each rank."""

import os
import pathlib
import shutil
import subprocess

# The folder of scripts/ and prm/: the sources, or PREFIX/share/caudal.
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
IS_SOURCE = (ROOT / "CMakeLists.txt").is_file()
RESULTS = ROOT / "output" if IS_SOURCE else pathlib.Path("output").resolve()


def find_program():
    """$CAUDAL (the tests name that of their own build), or the one that belongs to the scripts."""
    if name := os.environ.get("CAUDAL"):
        return pathlib.Path(name)
    if IS_SOURCE:
        return ROOT / "build" / "caudal"
    installed = ROOT.parent.parent / "bin" / "caudal"
    return installed if installed.is_file() else pathlib.Path(shutil.which("caudal") or installed)


PROGRAM = find_program()
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
               "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none"}


def read_program():
    """The bytes of the program and of its library: what the results depend on."""
    libraries = [*PROGRAM.parent.glob("libcaudal.so"),
                 *PROGRAM.parent.parent.glob("lib*/**/libcaudal.so")]
    return b"".join(path.read_bytes() for path in [PROGRAM, *libraries[:1]])


def get_mpirun(ranks):
    """The beginning of a command that starts so many ranks. Where there are several MPIs Debian
    calls Open MPI's mpirun.openmpi."""
    mpirun = os.environ.get("MPIRUN") or next(
        filter(shutil.which, ["mpirun.openmpi", "mpirun", "mpiexec"]), "mpirun")
    version = subprocess.run([mpirun, "--version"], capture_output=True, text=True, check=False)
    quiet = ["--quiet"] if "open-mpi" in version.stdout else []
    return [mpirun, *quiet, "-np", str(ranks)]
