# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a run as one HTML page that needs no network."""
