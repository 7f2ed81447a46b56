# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the example document: a freeform sheet with a crown and a bump, and a four-sided hole where the bump is highest.

    scripts/with_freecad_gui examples/four_sided_hole/make_example.py     writes four_sided_hole.FCStd beside this file
"""

import math
import os

import FreeCAD as App
import Part

LENGTH, WIDTH, HEIGHT = 240.0, 180.0, 46.0  # mm
POLES = 9  # along either direction
PIECES = 3  # the sheet is cut into 3 x 3 faces, the middle one is left out


def sheet() -> Part.BSplineSurface:
    """One bicubic surface: a crown over the length and the width, and a bump off the middle."""
    poles = [[_pole(i / (POLES - 1), j / (POLES - 1)) for j in range(POLES)] for i in range(POLES)]
    spans = POLES - 3
    knots = [k / spans for k in range(spans + 1)]
    multiplicities = [4] + [1] * (spans - 1) + [4]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(poles, multiplicities, multiplicities, knots, knots, False, False, 3, 3)
    return surface


def sheet_with_hole() -> Part.Shape:
    """The sheet's faces but the middle one, sewn; any of the four edges round the hole leads to it."""
    return sheet_of(lambda i, j: (i, j) != (PIECES // 2, PIECES // 2))


def sheet_of(is_there) -> Part.Shape:
    """Those of the sheet's faces (i, j) that are there, sewn."""
    faces = []
    for i in range(PIECES):
        for j in range(PIECES):
            if is_there(i, j):
                piece = sheet()
                piece.segment(i / PIECES, (i + 1) / PIECES, j / PIECES, (j + 1) / PIECES)
                faces.append(piece.toShape())
    shell = Part.makeShell(faces)
    shell.sewShape()
    return shell


def hole_edges(shape: Part.Shape) -> list:
    """Names of the edges round the hole: those with one face that stay off the sheet's outline."""
    outline = shape.BoundBox
    return [f"Edge{number}" for number, edge in enumerate(shape.Edges, 1)
            if len(shape.ancestorsOfType(edge, Part.Face)) == 1 and _is_within(edge.BoundBox, outline)]


def make_document(name: str = "four_sided_hole") -> App.Document:
    document = App.newDocument(name)
    base = document.addObject("Part::Feature", "Base")
    base.Label = "Sheet with a hole"
    base.Shape = sheet_with_hole()
    document.recompute()
    return document


def _pole(s: float, t: float) -> App.Vector:
    """Control point at (s, t) of the unit square."""
    x, y = (s - 0.5) * LENGTH, (t - 0.5) * WIDTH
    crown = 0.55 * math.cos(1.15 * (s - 0.5) * math.pi) + 0.25 * math.cos(1.1 * (t - 0.5) * math.pi)
    bump = 0.75 * math.exp(-22.0 * ((s - 0.46) ** 2 + 0.8 * (t - 0.54) ** 2))
    return App.Vector(x, y + 10.0 * math.sin(2.0 * s), HEIGHT * (crown + bump))


def _is_within(box: App.BoundBox, outline: App.BoundBox) -> bool:
    margin = 0.1 * outline.XLength
    return box.XMin > outline.XMin + margin and box.XMax < outline.XMax - margin \
        and box.YMin > outline.YMin + margin and box.YMax < outline.YMax - margin


if __name__ == "__main__":
    import FreeCADGui as Gui  # a document saved without a window opens with everything hidden

    made = make_document()
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    made.saveAs(os.path.join(os.path.dirname(os.path.abspath(__file__)), "four_sided_hole.FCStd"))
