# SPDX-License-Identifier: LGPL-2.1-or-later
"""A blend that is guided, in the real window: a handle set by a click and dragged, reach and weight moved beside it; one
step to undo, edited again."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

import gui
from seen import angles_to_guide, drawn_points, guides, handle_arrow

panels = gui.keep_panels()


def nearest(place):
    """The point of the surface that is nearest to a place."""
    return App.Vector(*min(drawn_points(panels), key=lambda point: (App.Vector(*point) - place).Length))


gui.start()
document = App.newDocument("Planes")
low = gui.part(document, "Low", Part.makePlane(20, 10))
high = gui.part(document, "High", Part.makePlane(20, 10, App.Vector(0, 20, 8)))
document.recompute()
view = gui.look_at_all()
gui.select(document, (low, gui.edge_at(low.Shape, (10, 10, 0))), (high, gui.edge_at(high.Shape, (10, 20, 8))))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict("Meets all 2 edges")

# A click sets a normal on the strip, its arrow is dragged: the strip follows at once and meets its edges still.
gui.widget("normalButton").click()
gui.click(view, nearest(App.Vector(10, 15, 4)))
gui.wait_for_verdict("Meets all 2 edges")
assert len(guides()) == 1 and gui.widget("lambdaSpin").value() == 100.0
foot, tip = handle_arrow(panels)
before, seen = drawn_points(panels), []
leaning = 0.9 * (tip - foot) + 0.43 * (tip - foot).Length * App.Vector(1, 0, 0)
gui.drag(view, tip, foot + leaning, at_half=lambda: seen.append(drawn_points(panels)))
assert seen[0] != before and gui.widget("xSpin").value() > 0.3
gui.wait_for_verdict("Meets all 2 edges")
start = angles_to_guide()
gui.widget("lambdaSpin").setValue(5000.0)
gui.wait_for_verdict("Meets all 2 edges")
heavy = angles_to_guide()
assert heavy[0] < 0.5 * start[0], (start, heavy)
gui.picture("blend_guided")

# The reach moves beside it, and the guide is followed still.
before = drawn_points(panels)
gui.widget("fromReachSpin").setValue(1.3)
assert drawn_points(panels) != before
gui.wait_for_verdict("Meets all 2 edges")
assert angles_to_guide()[0] < 0.7 * start[0], (start, angles_to_guide())

# OK is one step to undo; redone and edited again, a handle without weight is as if it were not there.
gui.ok()
blend = document.Blend
assert document.UndoNames == ["Blend faces"] and len(blend.Guides) == 1 and blend.isValid() and blend.WithinTolerance
guided = blend.Shape.CenterOfMass
document.undo()
assert document.Objects == [low, high]
document.redo()
blend = document.Blend
assert blend.Shape.CenterOfMass.isEqual(guided, 1e-9)
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict("Meets all 2 edges")
gui.widget("guideList").setCurrentRow(0)
gui.widget("weightSpin").setValue(0.0)
gui.wait_for_verdict("Meets all 2 edges")
gui.ok()
weightless = [face.copy() for face in blend.Shape.Faces]
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict("Meets all 2 edges")
gui.widget("guideList").setCurrentRow(0)
gui.widget("guideRemoveButton").click()
gui.wait_for_verdict("Meets all 2 edges")
gui.ok()
assert blend.Guides == [] and not document.findObjects("App::FeaturePython")
for before, after in zip(weightless, blend.Shape.Faces):
    assert before.Surface.getPoles() == after.Surface.getPoles(), "a handle without weight changes nothing"

# What only the property asks for is solved in the panel, too.
blend.InnerContinuity = "G2"
document.recompute()
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict("Meets all 2 edges")
assert panels[-1]._session.asked()[0].inner_continuity == "G2"
gui.press("Cancel")
print("passed")
