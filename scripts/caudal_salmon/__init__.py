# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies of the ideal-fluid salmon: runs, tables and plots."""
