# SPDX-License-Identifier: LGPL-2.1-or-later
"""Benchmarks: cases with known answers, their figures beside the references."""
