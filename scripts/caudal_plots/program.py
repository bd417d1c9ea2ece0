"""The program that scripts run, and the environment in which it uses one core for each rank."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# The tests name that of their own build.
PROGRAM = pathlib.Path(os.environ.get("CAUDAL", ROOT / "build" / "caudal"))
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
               "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none"}
