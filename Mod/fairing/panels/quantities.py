# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured numbers as text: short, with a unit."""

from __future__ import annotations

import math

import FreeCAD as App


def length_text(millimetres: float) -> str:
    """In the user's unit system, which picks nm, um or mm by itself."""
    if millimetres < 1e-9:  # below a picometre every number is rounding
        return "0 nm"
    return App.Units.Quantity(millimetres, App.Units.Length).UserString


def angle_text(degrees: float) -> str:
    """Two figures that count: 0.0041, 0.31, 12."""
    if degrees < 1e-4:
        return "0\u00b0"
    figures = max(0, 1 - math.floor(math.log10(degrees)))
    return f"{degrees:.{figures}f}\u00b0"


def percent_text(share: float) -> str:
    """0.0042 as 0.4 %, 0.31 as 31 %."""
    return f"{100 * share:.{1 if share < 0.1 else 0}f} %"


def show_quantity(spin, value: float, unit, figures: int = 6) -> None:
    """Puts a value in mm or degrees into a Gui::QuantitySpinBox with that many figures: on its own it rounds to the two
    decimals of the user's preferences, and the value with them."""
    quantity = App.Units.Quantity(value, unit)
    quantity.Format = {"Precision": figures, "NumberFormat": "g", "Denominator": 16}
    spin.setProperty("value", quantity)


def deviation_text(side: dict, limits: dict) -> str:
    """What a side misses most plainly: its angle or curvature, or its gap where it is only touched."""
    if side["asked"] == "G0":
        return length_text(side["gap"]["max"])
    if side["asked"] == "G2" and side["angle"]["max"] <= limits["angle"]:
        return percent_text(side["curvature"]["max"])
    return angle_text(max(side["angle"]["max"], side["corner_angle"]["max"]))


def point_text(point) -> str:
    """A place in mm."""
    return "(" + ", ".join(f"{round(coordinate, 9) + 0.0:.5g}" for coordinate in point) + ") mm"
