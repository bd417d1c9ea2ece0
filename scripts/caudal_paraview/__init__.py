# SPDX-License-Identifier: LGPL-2.1-or-later
"""A script that opens a run in ParaView as the pictures of scripts/plot show it."""
