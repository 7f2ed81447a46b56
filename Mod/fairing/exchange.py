# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes between FreeCAD's Part and the native module, as BREP text: exact, and EdgeN / FaceN keep their numbers."""

from __future__ import annotations

import Part

from . import native


def data_of(shape: Part.Shape) -> bytes:
    """The shape as BREP text, what the native module reads. Raises ValueError where there is none."""
    if shape.isNull():
        raise ValueError("The object has no shape.")
    return shape.exportBrepToString().encode("ascii")


def native_shape(shape: Part.Shape):
    """The shape as the native module's Shape."""
    return native_shape_of(data_of(shape))


def native_shape_of(brep: bytes):
    """The native module's Shape out of BREP text."""
    return native.module().Shape(brep)


def part_shape(brep: bytes) -> Part.Shape:
    """A Part.Face, Part.Shell ... out of BREP text."""
    shape = Part.Shape()
    shape.importBrepFromString(brep.decode("ascii"), False)
    return Part.Compound([shape]).childShapes()[0]  # of its own type, not just a Part.Shape
