# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the ends of a blend follow: picked in the view while the panel is open, kept by the object, changed on edit,
and written into macros."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

import gui


def pick(obj, name, count):
    Gui.Selection.addSelection(obj.Document.Name, obj.Name, name)
    gui.wait_for(lambda: gui.widget("endsList").count() == count, f"{count} in the list")
    gui.wait_for_verdict()


gui.start()
document = App.newDocument("Ends")
low = gui.part(document, "Low", Part.makePlane(20, 10))
high = gui.part(document, "High", Part.makePlane(20, 10, App.Vector(0, 20, 8)))
curve = Part.BezierCurve()
curve.setPoles([App.Vector(*pole) for pole in ((0, 10, 0), (0, 14, 0), (0, 16, 8), (0, 20, 8))])
curve = gui.part(document, "Curve", curve.toShape())
wall = gui.part(document, "Wall", Part.makePlane(30, 30, App.Vector(20, 30, -10), App.Vector(1, 0, 0)))
document.recompute()
gui.look_at_all()

gui.select(document, (low, gui.edge_at(low.Shape, (10, 10, 0))), (high, gui.edge_at(high.Shape, (10, 20, 8))))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
gui.widget("moreButton").setChecked(True)
assert not gui.widget("endsList").isVisible()
gui.widget("endsButton").click()
pick(curve, "Edge1", 1)
pick(wall, "Face1", 2)
gui.widget("endsButton").click()
shown = [gui.widget("endsList").item(row).text() for row in range(2)]
assert shown[0].startswith("Curve: Edge1") and "m" in shown[0].split()[-1], shown
assert shown[1].startswith("Wall: Face1"), shown
gui.picture("blend_ends")
gui.press("Ok")
blend = document.Blend
assert blend.Ends == [(curve, ("Edge1",)), (wall, ("Face1",))], blend.Ends
assert blend.isValid() and blend.WithinTolerance, blend.Verdict
assert abs(blend.Shape.BoundBox.XMax - 20) < 1e-5

# Edited, the list is there at once; one is taken away.
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
assert gui.widget("moreBox").isVisible() and gui.widget("endsList").count() == 2
gui.widget("endsList").setCurrentRow(0)
gui.widget("endsRemoveButton").click()
gui.wait_for_verdict()
assert gui.widget("endsList").count() == 1
gui.press("Ok")
assert blend.Ends == [(wall, ("Face1",))] and blend.isValid()

# What OK does is a line of Python.
from fairing.panels.blend_command import blend_command
from fairing.panels.blend_session import BlendSession

session = BlendSession.of_object(blend)
session.ends = []
session.update()
assert blend_command(session).endswith(", ends=[])"), blend_command(session)
print("passed")
