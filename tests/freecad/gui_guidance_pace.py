# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a slider's value takes to triangles in the 3D view: of one patch with 7 x 7 control points, and of a star of
five with 9 x 9 each. Printed; what is asserted is that every value is shown."""

import math
import statistics
import time

import FreeCAD as App
import FreeCADGui as Gui
import Part

import gui
from seen import drawn_points

SIDE = 40.0
POSITIONS = range(150, 450, 4)  # of the slider: weights from 10 to 100 000
panels = gui.keep_panels()


def sheet(count, size):
    """A bicubic face with count x count control points, in waves."""
    shares = [k / (count - 1) for k in range(count)]
    surface = Part.BSplineSurface()
    surface.interpolate([[App.Vector(size * (s - 0.5), size * (t - 0.5), 4.0 * math.sin(3.0 * s) * math.cos(2.0 * t))
                          for t in shares] for s in shares])
    return surface.toShape()


def pentagon():
    """A sheet without a five-sided piece."""
    corners = [App.Vector(22 * math.cos(a), 22 * math.sin(a), -60) for a in (0.3 + k * 0.4 * math.pi for k in range(6))]
    return sheet(9, 3 * SIDE).cut(Part.Face(Part.makePolygon(corners)).extrude(App.Vector(0, 0, 120)))


def pace(what):
    """Moves the slider and prints how long each value takes: of this thread, which other work of the machine does not
    count in, and on the clock."""
    nets = panels[-1]._result.control_net()
    sizes = sorted({f"{rows} x {columns}" for rows, columns, _ in nets})
    slider, spent, clock, shown = gui.widget("lambdaSlider"), [], [], []
    for position in POSITIONS:
        before, began = time.thread_time(), time.monotonic()
        slider.setValue(position)
        spent.append(1e3 * (time.thread_time() - before))
        clock.append(1e3 * (time.monotonic() - began))
        shown.append(drawn_points(panels)[len(drawn_points(panels)) // 3].getValue())
    assert len(set(shown)) > 0.9 * len(shown), "every value is shown"
    print(f"{what}, {len(nets)} patches of {', '.join(sizes)} control points, slider to triangles: median "
          f"{statistics.median(spent):.1f} ms, longest {max(spent):.1f} ms; on the clock {statistics.median(clock):.1f} "
          f"and {max(clock):.1f} ms")


def first_handle(view, point):
    gui.widget("normalButton").click()
    gui.click(view, point)
    gui.settle()
    gui.widget("xSpin").setValue(0.5)
    gui.settle()


gui.start()
document = App.newDocument("Patch")
base = gui.part(document, "Base", sheet(5, SIDE))
document.recompute()
surface = base.Shape.Faces[0].Surface
assert (surface.NbUPoles, surface.NbVPoles) == (7, 7) or print(surface.NbUPoles, surface.NbVPoles)
view = gui.look_at_all()
gui.select(document, (base, "Face1"))
Gui.runCommand("Fairing_EditSurface")
gui.settle()
first_handle(view, surface.value(*[0.5 * sum(bounds) for bounds in (surface.bounds()[:2], surface.bounds()[2:])]))
pace("one patch")
gui.settle()
gui.press("Cancel")

document = App.newDocument("Star")
base = gui.part(document, "Base", pentagon())
document.recompute()
inner = min(base.Shape.Edges, key=lambda edge: math.hypot(edge.CenterOfMass.x, edge.CenterOfMass.y))
name = next(f"Edge{k}" for k, edge in enumerate(base.Shape.Edges, 1) if edge.isSame(inner))
view = gui.look_at_all()
gui.select(document, (base, name))
Gui.runCommand("Fairing_FillHole")
gui.settle()
points = [App.Vector(*point) for point in drawn_points(panels)]
first_handle(view, min(points, key=lambda point: math.hypot(point.x - 5, point.y)))
pace("a star")
gui.settle()
gui.press("Cancel")
print("passed")
