# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps over parameters of a case, of any model: runs, table, plots, a page; and mesh studies."""


class SweepError(Exception):
    """What a user asked for can't be done; the text says what is wrong and what to do."""
