# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of Caudal's results, from statistics.txt and the VTU files."""


class MissingData(Exception):
    """A file or column that a figure needs is not there; the text says which."""


class BrokenData(MissingData):
    """A file is there, but it is cut off or damaged; the text says which."""
