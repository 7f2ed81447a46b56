# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picking inside the panel, labels in the 3D view, and what the panel says to bad input."""

import FreeCADGui as Gui
from PySide import QtGui

import gui
import support


def middle(edge):
    first, last = edge.ParameterRange
    return edge.valueAt((first + last) / 2)


def says(start):
    """A red line; nothing to press OK on."""
    gui.wait_for(lambda: start in gui.verdict(), f"'{start}', there is '{gui.verdict()}'")
    color = gui.widget("verdictLabel").palette().color(QtGui.QPalette.WindowText)
    assert color.red() > 150 > color.green(), "not a red line"
    assert "\n" not in gui.verdict() and "Traceback" not in gui.verdict()
    gui.press("Ok")
    assert gui.panel_is_open() and document.Objects == before and not document.UndoNames


gui.start()
document, base, edges = support.example()
view = gui.look_at_all()
before = document.Objects

# Nothing selected: the panel asks, and takes what is picked with the mouse.
Gui.runCommand("Fairing_FillHole")
gui.pump(0.2)
assert gui.widget("promptLabel").isVisible() and not gui.widget("boundaryTable").isVisible()
gui.press("Ok")
assert gui.panel_is_open() and document.Objects == before
gui.click(view, middle(base.Shape.getElement(edges[2])))
gui.wait_for_verdict("Meets all 4 edges")
assert not gui.widget("promptLabel").isVisible() and not Gui.Selection.hasSelection()

# What is neither an edge nor a face is refused with a reason in the status bar.
Gui.Selection.addSelection(document.Name, base.Name, "Vertex1")
assert not Gui.Selection.hasSelection()
gui.wait_for(lambda: "Pick an edge" in Gui.getMainWindow().statusBar().currentMessage(), "the reason")

# An edge that leads nowhere: a red line. Another edge of the hole: all is well again.
shared = next(f"Edge{n}" for n, edge in enumerate(base.Shape.Edges, 1)
              if len(base.Shape.ancestorsOfType(edge, support.Part.Face)) == 2)
Gui.Selection.addSelection(document.Name, base.Name, shared)
says(f"dge {shared[4:]}")
gui.picture("7_bad_pick")
Gui.Selection.addSelection(document.Name, base.Name, edges[2])
gui.wait_for_verdict("Meets all 4 edges")

# Numbers that make no sense.
gui.widget("gapAutoCheck").setChecked(False)
gui.type_into("gapSpin", "0.0 mm")
says("tolerance must be")
gui.widget("gapAutoCheck").setChecked(True)
gui.wait_for_verdict()
gui.type_into("angleSpin", "0.0 deg")
says("angle tolerance must be")
gui.type_into("angleSpin", "0.02 deg")
gui.wait_for_verdict()

# An edge out of tolerance is shown with its number.
gui.type_into("angleSpin", "0.0001 deg")
gui.widget("polesSpin").setValue(150)
gui.wait_for_verdict("Edge")
gui.picture("8_out_of_tolerance")
gui.type_into("angleSpin", "0.02 deg")
gui.widget("polesSpin").setValue(2500)
gui.wait_for_verdict()

# A click on a label cycles its edge from G1 to G2 to G0 and back, with shift all of them.
row = [gui.widget("boundaryTable").item(row, 0).text() for row in range(4)].index(edges[0][4:])
combo = lambda at: gui.widget("boundaryTable").cellWidget(at, 2).currentText()  # noqa: E731
assert combo(row) == "G1"
gui.click(view, middle(base.Shape.getElement(edges[0])))
gui.wait_for(lambda: combo(row) == "G2", "the label to take the click")
gui.settle()
gui.click(view, middle(base.Shape.getElement(edges[0])))
gui.wait_for(lambda: combo(row) == "G0", "the label to take another click")
assert [combo(at) for at in range(4)].count("G1") == 3
gui.click(view, middle(base.Shape.getElement(edges[0])), "shift")
gui.wait_for(lambda: [combo(at) for at in range(4)] == ["G1"] * 4, "all edges G1")
gui.wait_for_verdict("Meets all 4 edges")

# A guide: the slider wakes up, and the surface follows it.
other = document.addObject("Part::Feature", "Guide")
other.Shape = support.make_example.sheet().toShape()
before = document.Objects
assert not gui.widget("lambdaSlider").isVisible()
gui.widget("referenceButton").click()
Gui.Selection.addSelection(document.Name, "Guide", "Face1")
gui.wait_for(lambda: gui.widget("lambdaSlider").isEnabled(), "the guide to be taken")
gui.widget("lambdaSlider").setValue(300)
gui.wait_for(lambda: gui.widget("lambdaSpin").value() > 1.0, "the weight")
gui.wait_for_verdict()
gui.picture("9_guided")
gui.ok()
fill = document.Fill
assert fill.Reference == [(other, ("Face1",))] and fill.Lambda > 1.0 and fill.isValid()

# The face to be replaced, picked before the command: its border is the hole.
whole = support.App.newDocument("Whole")
sheet = whole.addObject("Part::Feature", "Base")
sheet.Shape = support.make_example.sheet_of(lambda i, j: True)
gui.look_at_all()
number = next(n for n, face in enumerate(sheet.Shape.Faces, 1)
              if abs(face.CenterOfMass.x) + abs(face.CenterOfMass.y) < 30)
Gui.Selection.addSelection("Whole", "Base", f"Face{number}")
assert gui.action_is_enabled("Fairing_FillHole")
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict("Meets all 4 edges")
gui.widget("resultCombo").setCurrentIndex(2)
gui.wait_for_verdict("Meets all 4 edges")
gui.press("Ok")
fill = whole.Fill
assert fill.State == ["Up-to-date"] and fill.Edges == (sheet, [f"Face{number}"]) and fill.ResultMode == "base"
assert fill.Shape.isValid() and len(fill.Shape.Faces) == len(sheet.Shape.Faces)
assert abs(fill.Shape.Area - sheet.Shape.Area) > 1e-6 * sheet.Shape.Area and not sheet.ViewObject.Visibility
print("passed")
