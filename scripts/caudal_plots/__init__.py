# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of Caudal's results, from statistics.txt and the VTU files."""

import caudal_setup  # noqa: F401: so that the package caudal is found

from caudal import BrokenData, MissingData  # noqa: F401
