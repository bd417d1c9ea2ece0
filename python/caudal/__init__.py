# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of Caudal in Python.

    import caudal
    run = caudal.Run("output/fish")
    run.statistics                   # a pandas.DataFrame: a row for each step, "name [unit]"
    run.beats()                      # a row for each whole tail beat
    run.resample_beats(["muscle power", "u of centre of mass"])    # the columns by phase
    run.read_fluid(run.times[-1])    # a field: points, triangles, data (needs VTK)
    caudal.list_runs("output")       # the runs below a folder

Installed beside the program in share/caudal/python; put that folder into PYTHONPATH.
"""

from .errors import BrokenData, MissingData
from .parameters import read_model, read_parameters, read_progress
from .run import Run, list_runs
from .tables import get_unit, read_table

__all__ = ["BrokenData", "MissingData", "Run", "get_unit", "list_runs", "read_model",
           "read_parameters", "read_progress", "read_table"]
