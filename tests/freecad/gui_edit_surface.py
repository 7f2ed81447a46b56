# SPDX-License-Identifier: LGPL-2.1-or-later
"""A face shaped anew in the real window: picked, turned by an arrow, its freedom raised, put into its base; undone, redone
and edited again."""

import FreeCAD as App
import FreeCADGui as Gui

import gui
import support
from seen import handle_arrow

SIDE = 40.0
panels = gui.keep_panels()


gui.start()
document = App.newDocument("Box")
box = document.addObject("Part::Box", "Box")
box.Length = box.Width = box.Height = SIDE
document.recompute()
view = gui.look_at_all()
centre = App.Vector(SIDE / 2, SIDE / 2, SIDE)
top = support.face_where(box, lambda face: face.CenterOfMass.isEqual(centre, 1e-6))

# One face is needed; an edge is none.
Gui.Selection.addSelection("Box", "Box", "Edge1")
assert not gui.action_is_enabled("Fairing_EditSurface")
gui.select(document, (box, top))
assert gui.action_is_enabled("Fairing_EditSurface")
Gui.runCommand("Fairing_EditSurface")
gui.settle()
assert gui.widget("faceLabel").text() == f"Box: {top}" and gui.widget("resultCombo").currentIndex() == 2
assert box.ViewObject.Transparency > 0, "the old face must not hide the new one"

# A plane has nothing to move until it is split, and says so.
assert "control points" in gui.verdict(), gui.verdict()
gui.widget("spansSpin").setValue(6)
gui.widget("degreeSpin").setValue(3)
gui.wait_for_verdict("25 of 81 control points moved")

# A handle by a click, dragged by its tip.
gui.widget("normalButton").click()
gui.click(view, centre)
gui.wait_for_verdict("25 of 81")
foot, tip = handle_arrow(panels)
assert foot.distanceToPoint(centre) < 1.0
gui.drag(view, tip, foot + App.Vector(0.5, 0, 0.866) * (tip - foot).Length)
gui.settle()
assert abs(gui.widget("xSpin").value() - 0.5) < 0.1
gui.picture("27_edited_face")
gui.ok()
edit = document.Edit
assert document.UndoNames == ["Edit surface"], document.UndoNames
assert edit.Shape.ShapeType == "Solid" and edit.Shape.isValid() and edit.LargestMove.Value > 0.1
assert not box.ViewObject.Visibility and box.ViewObject.Transparency == 0
assert edit.ViewObject.Proxy.claimChildren() == [box, edit.Guides[0]]
gui.picture("28_edited_solid")

document.undo()
assert document.Objects == [box]
document.redo()
edit = document.Edit
assert len(edit.Guides) == 1 and edit.Shape.isValid()

# Edited again by a double-click on its handle: beside the base, another border. Cancel keeps what was.
assert edit.Guides[0].ViewObject.Proxy.doubleClicked(edit.Guides[0].ViewObject)
gui.wait_for_verdict("25 of 81")
assert box.ViewObject.Visibility and not edit.ViewObject.Visibility
gui.widget("keepCombo").setCurrentIndex(1)
gui.wait_for_verdict("49 of 81")
gui.press("Cancel")
assert edit.Keep == "auto" and edit.ViewObject.Visibility and not box.ViewObject.Visibility
Gui.ActiveDocument.setEdit("Edit")
gui.wait_for_verdict("25 of 81")
gui.widget("resultCombo").setCurrentIndex(0)
gui.wait_for_verdict("25 of 81")
gui.ok()
assert edit.ResultMode == "patches" and edit.Shape.ShapeType == "Face" and len(document.UndoNames) == 2
print("passed")
