# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be wrong with the results of a run."""


class MissingData(Exception):
    """A file or column that is asked for is not there; the text says which."""


class BrokenData(MissingData):
    """A file is there, but it is cut off or damaged; the text says which."""
