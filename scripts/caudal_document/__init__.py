# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reference of parameters, output columns and messages as a page, and the pictures of the
gallery: scripts/document."""
