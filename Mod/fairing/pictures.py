# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of curvature there are."""

from __future__ import annotations

# In the order of the native module's columns.
QUANTITIES = ("mean", "gauss", "k1", "k2", "mean-gradient")
UNITS = ("1/mm", "1/mm\u00b2", "1/mm", "1/mm", "1/mm\u00b2")
SYMBOLS = ("H", "K", "\u03ba\u2081", "\u03ba\u2082", "|\u2207H|")
NONE, ZEBRA = "none", "zebra"
PICTURES = (NONE, *QUANTITIES, ZEBRA)  # in the order of the list in the panels


def is_signed(quantity: str) -> bool:
    return quantity != "mean-gradient"
