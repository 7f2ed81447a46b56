# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hole whose surface is guided, in the real window: a handle set by a click, dragged and typed, a curve and a reference
picked, weights slid, all of it live; one step to undo, saved, reopened and edited again."""

import FreeCAD as App
import FreeCADGui as Gui

import gui
import support
from seen import angles_to_guide, drawn_points, guides, handle_arrow

panels = gui.keep_panels()


def camera():
    """Where it is and how it looks; how far is the renderer's own business."""
    node = view.getCameraNode()
    return node.position.getValue().getValue(), node.orientation.getValue().getValue(), node.height.getValue()


gui.start()
document, base, edges = support.example()
view = gui.look_at_all()
Gui.Selection.addSelection(document.Name, base.Name, edges[0])
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict("Meets all 4 edges")
assert not gui.widget("guideList").isVisible() and not gui.widget("weightsRow").isVisible()
plain = drawn_points(panels)
middle = App.Vector(*min(plain, key=lambda p: (App.Vector(*p) - App.Vector(0, 7, 61)).Length))

# A click on the surface sets a normal there, and nothing else happens to what lies behind.
gui.widget("normalButton").click()
gui.click(view, middle)
gui.wait_for_verdict("Meets all 4 edges")
assert len(guides()) == 1 and "Normal" in guides()[0] and not gui.widget("normalButton").isChecked()
assert gui.widget("lambdaSpin").value() == 100.0 and gui.widget("guideRow").isVisible()
assert not Gui.Selection.hasSelection() and document.Objects == [base]
foot, tip = handle_arrow(panels)
assert foot.distanceToPoint(middle) < 1.0
gui.picture("20_handle")

# Dragged by its tip the surface follows at once; the weight makes the angles fall.
still, before, seen = camera(), drawn_points(panels), []
gui.drag(view, tip, foot + App.Vector(0.45, 0, 0.893) * (tip - foot).Length,
         at_half=lambda: (seen.append(drawn_points(panels)), gui.picture("21_handle_dragged")))
assert camera() == still and not Gui.Selection.hasSelection()
assert seen[0] != before and gui.widget("xSpin").value() > 0.3
gui.wait_for_verdict("Meets all 4 edges")
start = angles_to_guide()
gui.widget("lambdaSpin").setValue(1000.0)  # the middle of the slider, where its handle is taken
gui.wait_for_verdict("Meets all 4 edges")
gui.settle()  # the panel has its height again
gui.drag_slider("lambdaSlider", 0.1)
gui.wait_for_verdict("Meets all 4 edges")
assert gui.widget("lambdaSpin").value() > 1000.0
assert angles_to_guide()[0] < start[0], (start, angles_to_guide())
gui.picture("22_heavier")

# What guides can be seen, and the control points; both follow while a slider moves.
drawing = panels[-1]._display._preview.guidance
assert drawing._field._lines.numVertices.getNum() == 0 and drawing._net._dots.numPoints.getValue() == 0
gui.widget("fieldCheck").click()
gui.widget("netCheck").click()
assert drawing._field._lines.numVertices.getNum() > 10 and drawing._net._dots.numPoints.getValue() == sum(
    rows * columns for rows, columns, _ in panels[-1]._result.control_net())
net = drawing._net._points.point.getValues()
gui.widget("lambdaSlider").setValue(gui.widget("lambdaSlider").value() - 40)
assert drawing._net._points.point.getValues() != net and drawing._field._lines.numVertices.getNum() > 10
gui.picture("23_field_and_net")
gui.widget("fieldCheck").click()
gui.widget("netCheck").click()
gui.wait_for_verdict("Meets all 4 edges")

# Moved by its foot, over the surface.
foot, _ = handle_arrow(panels)
gui.drag(view, foot, App.Vector(*min(drawn_points(panels), key=lambda p: (App.Vector(*p) - foot - App.Vector(6, 6, 0)).Length)))
gui.wait_for_verdict("Meets all 4 edges")
assert 2.0 < handle_arrow(panels)[0].distanceToPoint(foot) < 12.0

# Typed: direction, weight, radius. A zero normal is told.
gui.widget("xSpin").setValue(0.4)
gui.widget("ySpin").setValue(0.0)
gui.widget("zSpin").setValue(1.0)
gui.widget("weightSpin").setValue(2.0)
gui.type_into("radiusSpin", "25 mm")
gui.wait_for_verdict("Meets all 4 edges")
assert guides()[0].endswith("(0.37, 0.00, 0.93)"), guides()
gui.widget("xSpin").setValue(0.0)
gui.widget("zSpin").setValue(0.0)
gui.wait_for_verdict("The guide given: normal 1 is wrong, its normal is zero")
gui.widget("zSpin").setValue(1.0)
gui.widget("xSpin").setValue(0.4)
gui.wait_for_verdict("Meets all 4 edges")

# OK: the fill and its handle, one step to undo.
gui.ok()
fill = document.Fill
handle, = fill.Guides
assert document.UndoNames == ["Fill hole"] and fill.isValid() and fill.WithinTolerance
assert handle.Weight == 2.0 and handle.Radius.Value == 25.0 and tuple(handle.Normal) == (0.4, 0.0, 1.0)
assert fill.ViewObject.Proxy.claimChildren() == [handle]
gui.picture("24_guided_fill")
area = fill.Shape.Area
document.undo()
assert document.Objects == [base]
document.redo()
fill = document.Fill
assert len(fill.Guides) == 1 and abs(fill.Shape.Area - area) < 1e-9 * area

# Saved, reopened, edited again: a reference is picked, the handle goes.
path = support.saved(document)
App.closeDocument(document.Name)
document = App.openDocument(path)
view = gui.look_at_all()
fill, base = document.Fill, document.Base
raised = gui.part(document, "Raised", support.make_example.sheet().toShape())
raised.Placement = App.Placement(App.Vector(0, 0, 5), App.Rotation())
document.recompute()
Gui.ActiveDocument.setEdit("Fill")
gui.wait_for_verdict("Meets all 4 edges")
assert len(guides()) == 1
gui.widget("referenceButton").click()
Gui.Selection.addSelection(document.Name, "Raised", "Face1")
gui.wait_for(lambda: len(guides()) == 2, "the reference to be taken")
gui.wait_for_verdict("Meets all 4 edges")
assert guides()[1] == "Raised: Face1" and gui.widget("gammaSlider").isEnabled()
gui.widget("guideList").setCurrentRow(0)
gui.widget("directionButton").click()
Gui.Selection.addSelection(document.Name, "Raised", "Face1")
gui.wait_for(lambda: "Normal from Raised: Face1" in guides()[0], "the direction to be taken")
gui.wait_for_verdict("Meets all 4 edges")
gui.widget("gammaSpin").setValue(1000.0)
gui.wait_for_verdict("Meets all 4 edges")
assert "from the reference" in gui.widget("followLabel").text()
gui.picture("25_reference")
gui.ok()
assert fill.Guides[0].Direction == (raised, ["Face1"]) and fill.Gamma == 1000.0
assert fill.Reference == [(raised, ("Face1",))] and fill.isValid()
steps = len(document.UndoNames)
Gui.ActiveDocument.setEdit("Fill")
gui.wait_for_verdict("Meets all 4 edges")
gui.widget("guideList").setCurrentRow(0)
gui.widget("guideRemoveButton").click()
gui.wait_for_verdict("Meets all 4 edges")
assert guides() == ["Raised: Face1"]
gui.ok()
assert fill.Guides == [] and len(document.UndoNames) == steps + 1
assert not document.findObjects("App::FeaturePython")

# A curve: an edge of a sketch's kind, with the normal of a face.
line = gui.part(document, "Line", support.Part.makeLine(App.Vector(-12, 7, 62), App.Vector(12, 7, 62)))
document.recompute()
Gui.ActiveDocument.setEdit("Fill")
gui.wait_for_verdict("Meets all 4 edges")
gui.widget("curveButton").click()
Gui.Selection.addSelection(document.Name, "Line", "Edge1")
gui.wait_for(lambda: len(guides()) == 2, "the curve to be taken")
assert "Along Line: Edge1" in guides()[0], guides()
gui.widget("directionButton").click()
Gui.Selection.addSelection(document.Name, "Raised", "Face1")
gui.wait_for(lambda: not gui.widget("directionButton").isChecked(), "the face to be taken")
gui.wait_for_verdict("Meets all 4 edges")
gui.ok()
curve, = fill.Guides
assert curve.Faces == [(raised, ("Face1",))] and len(curve.Points) > 1 and fill.isValid()
gui.picture("26_curve")

# Deleted, it takes along what guides nothing else; undone, both are back.
name = curve.Name
Gui.Selection.clearSelection()
Gui.Selection.addSelection(fill)
Gui.runCommand("Std_Delete")
gui.wait_for(lambda: document.getObject("Fill") is None, "the fill to be deleted")
assert document.getObject(name) is None and document.getObject("Line") and document.getObject("Raised")
document.undo()
assert [guide.Name for guide in document.Fill.Guides] == [name] and document.Fill.isValid()
print("passed")
