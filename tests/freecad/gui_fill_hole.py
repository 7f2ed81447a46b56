# SPDX-License-Identifier: LGPL-2.1-or-later
"""A designer's way from one edge picked with the mouse to a saved, parametric surface, in the real window."""

import FreeCAD as App
import FreeCADGui as Gui

import gui
import support

gui.start()
document, base, edges = support.example()
view = gui.look_at_all()

# Pick one edge with the mouse. With nothing selected the command offers itself too; with a vertex it does not.
assert gui.action_is_enabled("Fairing_FillHole")
Gui.Selection.addSelection(document.Name, base.Name, "Vertex1")
assert not gui.action_is_enabled("Fairing_FillHole")
Gui.Selection.clearSelection()
gui.click(view, base.Shape.getElement(edges[0]).valueAt(
    sum(base.Shape.getElement(edges[0]).ParameterRange) / 2))
picked = Gui.Selection.getSelectionEx()
assert [(pick.ObjectName, pick.SubElementNames) for pick in picked] == [("Base", (edges[0],))], picked
assert gui.action_is_enabled("Fairing_FillHole")
gui.picture("1_edge_picked")

# The preview is there without a further move, and the numbers with it.
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict("Meets all 4 edges")
table = gui.widget("boundaryTable")
assert {"Edge" + table.item(row, 0).text() for row in range(table.rowCount())} == set(edges)
assert not gui.action_is_enabled("Fairing_FillHole")
assert document.Objects == [base] and not document.UndoNames, "the preview must not touch the document"
gui.picture("2_preview")

# OK: one object, one step to undo.
gui.press("Ok")
assert not gui.panel_is_open()
fill = document.Fill
support.is_filled(fill, base, edges)
assert document.UndoNames == ["Fill hole"], document.UndoNames
assert fill.Edges == (base, [edges[0]])
gui.picture("3_filled")
area = fill.Shape.Area

document.undo()
assert document.Objects == [base] and document.RedoNames == ["Fill hole"]
document.redo()
fill = document.Fill
support.is_filled(fill, base, edges)
assert abs(fill.Shape.Area - area) < 1e-9 * area

# Edit by a double-click, to G0 on one edge: a row of the table, then OK.
assert fill.ViewObject.Proxy.doubleClicked(fill.ViewObject)
gui.wait_for_verdict()
assert not fill.ViewObject.Visibility, "the preview stands for the object"
combo = gui.widget("boundaryTable").cellWidget(0, 2)
combo.setCurrentText("G0")
gui.wait_for_verdict()
gui.picture("4_one_edge_g0")
gui.press("Ok")
assert [line.split("=")[1] for line in fill.EdgeContinuity] == ["G0"], fill.EdgeContinuity
assert document.UndoNames[0] == "Edit Fill" and len(document.UndoNames) == 2, document.UndoNames
assert Gui.ActiveDocument.getInEdit() is None and fill.ViewObject.Visibility
assert fill.isValid() and abs(fill.Shape.Area - area) > 1e-6 * area
document.undo()
document.recompute()
assert fill.EdgeContinuity == [] and abs(fill.Shape.Area - area) < 1e-9 * area

# Edit and cancel: nothing has changed.
steps = document.UndoNames
Gui.ActiveDocument.setEdit(fill.Name)
gui.wait_for_verdict()
gui.widget("allG0Button").click()
gui.wait_for(lambda: gui.widget("boundaryTable").cellWidget(3, 2).currentText() == "G0", "G0 in every row")
gui.press("Cancel")
assert not gui.panel_is_open() and fill.ViewObject.Visibility
assert fill.Continuity == "G1" and document.UndoNames == steps

# Save, reopen, move the base: the surface follows.
path = support.saved(document)
App.closeDocument(document.Name)
document = App.openDocument(path)
view = gui.look_at_all()
base, fill = document.Base, document.Fill
support.is_filled(fill, base, edges)
assert abs(fill.Shape.Area - area) < 1e-9 * area
centre = fill.Shape.CenterOfMass
moved = App.Placement(App.Vector(30, -20, 15), App.Rotation(App.Vector(1, 2, 3), 40))
base.Placement = moved
document.recompute()
support.is_filled(fill, base, edges)
assert fill.Shape.CenterOfMass.distanceToPoint(moved.multVec(centre)) < 1e-5
Gui.SendMsgToActiveView("ViewFit")
gui.picture("5_reopened_and_moved")
print("passed")
