# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of figures.py, one a figure, its parts side by side, made by the real FreeCAD:

    scripts/with_freecad_gui --output docs/images examples/wu_yang_2015/pictures.py
"""

import math
import os
import sys

import FreeCAD as App
import FreeCADGui as Gui
import Part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "scripts"))
sys.path.insert(0, os.path.join(ROOT, "tests", "freecad"))

import data  # noqa: E402
import figures  # noqa: E402
import gui  # noqa: E402

BLUE, GREY, RED = (0.42, 0.66, 0.86), (0.84, 0.86, 0.89), (0.85, 0.12, 0.12)
WIDTH, HEIGHT = 400, 300  # pixels a part
NEEDLES = 8  # normals drawn along either direction
LENGTH = 12.0  # of the longest, mm
SPACE = 1.55  # from part to part, in sizes of one
ISOLINES = 9


def needles(surface, field: dict) -> Part.Shape:
    """The normals of a field as needles on a surface; none where they weigh nothing."""
    lines = []
    for i in range(NEEDLES + 1):
        for j in range(NEEDLES + 1):
            s, t = i / NEEDLES, j / NEEDLES
            normal = normal_at(field, s, t)
            if normal.Length > 0:
                foot = surface.value(s, t)
                lines.append(Part.makeLine(foot, foot + LENGTH * normal.normalize()))
    return Part.makeCompound(lines)


def normal_at(field: dict, s: float, t: float) -> App.Vector:
    normals = [App.Vector(*normal) for normal in field["normals"]]
    if "degree" in field:
        m = field["degree"][1]
        return data.patch([normals[k:k + m + 1] for k in range(0, len(normals), m + 1)]).value(s, t)
    place = round(s * field["n"]) * (field["m"] + 1) + round(t * field["m"])
    return normals[place] * field["weights"][place]


def isolines(shape) -> Part.Shape:
    surface = shape.Faces[0].Surface
    u0, u1, v0, v1 = surface.bounds()
    shares = [(k + 1) / (ISOLINES + 1) for k in range(ISOLINES)]
    return Part.makeCompound([surface.uIso(u0 + s * (u1 - u0)).toShape() for s in shares]
                             + [surface.vIso(v0 + s * (v1 - v0)).toShape() for s in shares])


def show(document, shape, color, width, at):
    obj = document.addObject("Part::Feature", "Part")
    obj.Shape = shape.translated(at)
    view = obj.ViewObject
    view.Deviation, view.AngularDeflection = 0.02, 4.0
    view.ShapeColor, view.LineWidth, view.PointSize = color, width, 1.0
    view.LineColor = color if color == RED else (0.13, 0.15, 0.18)


def picture(name: str, figure, columns: int, turn: float, tilt: float):
    document = App.newDocument(name)
    size = data.SIDE * (2.0 if any(beside for *_, beside in figure.shapes) else 1.0)
    rows = -(-len(figure.shapes) // columns)
    below = SPACE * size * HEIGHT / WIDTH / math.cos(math.radians(tilt))
    right = App.Rotation(App.Vector(0, 0, 1), turn).multVec(App.Vector(1, 0, 0))
    down = App.Rotation(App.Vector(0, 0, 1), turn).multVec(App.Vector(0, -1, 0))
    for k, (_, shape, field, beside) in enumerate(figure.shapes):
        at = right * (SPACE * size * (k % columns)) + down * (below * (k // columns))
        show(document, shape, BLUE, 2.0, at)
        show(document, isolines(shape), BLUE, 1.0, at)
        for part in beside:
            show(document, part, GREY, 1.0, at)
        if field:
            show(document, needles(shape.Faces[0].Surface, field), RED, 2.0, at)
    gui.pump(0.3)
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.setCameraType("Orthographic")
    view.setCameraOrientation(App.Rotation(App.Vector(0, 0, 1), turn).multiply(App.Rotation(App.Vector(1, 0, 0), tilt)))
    view.fitAll()
    view.getCameraNode().height.setValue(SPACE * size * HEIGHT / WIDTH * rows)
    gui.pump(0.3)
    view.saveImage(os.path.join(os.environ["FAIRING_OUTPUT"], f"{name}.png"), WIDTH * columns, HEIGHT * rows, "White")
    App.closeDocument(document.Name)


def main():
    gui.start()
    for number, (make, columns, turn, tilt) in enumerate(
            zip(figures.FIGURES, (4, 5, 5, 5, 3), (25, 25, 25, 25, 20), (55, 60, 60, 55, 55)), 1):
        picture(f"wu_yang_figure_{number}", make(), columns, turn, tilt)


main()
