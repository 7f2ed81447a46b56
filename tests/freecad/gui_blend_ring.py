# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three sides and more in the panel: open ones that come to a vertex, closed ones that are cut where edges show it."""

import math

import FreeCAD as App
import FreeCADGui as Gui
import Part

import gui
import seen


def arched_strip(turn):
    """A strip like a fillet that comes in from a direction and ends 10 mm before the origin, and the middle of the
    edge it ends with."""
    along = App.Vector(math.cos(turn), math.sin(turn), -0.5).normalize()
    side = App.Vector(-math.sin(turn), math.cos(turn), 0)
    up = along.cross(side)
    start, points = 10 * along, []
    for angle in (-0.5, 0.0, 0.5):
        points.append(start + 5 * math.sin(angle) * side + 5 * (math.cos(angle) - 1) * up)
    return Part.Arc(*points).toShape().extrude(6 * along), points[1]


def edge_through(obj, point):
    return next(f"Edge{number}" for number, edge in enumerate(obj.Shape.Edges, 1)
                if edge.distToShape(Part.Vertex(point))[0] < 1e-6)


gui.start()
panels = gui.keep_panels()

document = App.newDocument("Vertex")
picks = []
for number in range(3):
    shape, middle = arched_strip(2 * math.pi * number / 3)
    obj = gui.part(document, f"Fillet{number + 1}", shape)
    picks.append((obj, edge_through(obj, middle)))
document.recompute()
gui.look_at_all()
gui.select(document, *picks)
Gui.runCommand("Fairing_BlendFaces")
# Sides that do not connect are a mistake, or meant: the panel says so, and asks.
gui.wait_for_verdict("Edge")
assert "ring of sides" in gui.verdict(), gui.verdict()
assert gui.widget("ringCheck").isVisible() and not gui.widget("cutsButton").isVisible()
gui.widget("ringCheck").click()
gui.wait_for_verdict()
gui.picture("blend_vertex")
gui.press("Ok")
blend = document.Blend
assert blend.Ring and blend.WithinTolerance, blend.Verdict
assert len(blend.Shape.Faces) == 6 and blend.Shape.isValid()
for obj, edge in picks:
    assert obj.Shape.getElement(edge).distToShape(blend.Shape)[0] < 1e-6
document.undo()
assert document.getObject("Blend") is None
document.redo()
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
assert gui.widget("ringCheck").isChecked()
gui.press("Cancel")

# Its patches meet in curvature where that is chosen: one fillet is turned, since what is symmetric does by itself.
document.Fillet3.Placement.Rotation = App.Rotation(App.Vector(0, 0, 1), 12)
document.recompute()
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
combo, tangent = gui.widget("innerCombo"), seen.largest_jump(panels)
assert combo.isVisible() and combo.currentText() == "Tangent (G1)"
combo.setCurrentText("Curvature (G2)")
gui.wait_for_verdict()
assert {seam["asked"] for seam in seen.report(panels)["seams"] if not seam["crease"]} == {"G2"}
limit = seen.report(panels)["limits"]["curvature"]
assert seen.largest_jump(panels) <= limit < tangent, (seen.largest_jump(panels), tangent)
gui.scroll_to("innerCombo")
gui.picture("blend_between_patches")
assert not seen.cut_off(), seen.cut_off()
lines = seen.lines_run(gui.ok)
assert "fairing.change_blend(FreeCAD.ActiveDocument.getObject('Blend'), inner_continuity='G2')" in lines, lines
assert blend.InnerContinuity == "G2" and blend.isValid()
document.undo()
assert blend.InnerContinuity == "G1"

# Closed ones: a junction, whose cuts are shown by edges.
document = App.newDocument("Junction")
rims, walls = [], []
for number in range(3):
    turn = 2 * math.pi * number / 3
    along = App.Vector(math.cos(turn), math.sin(turn), 0)
    pipe = Part.makeCylinder(5, 8, 14 * along, along).Faces
    wall = gui.part(document, f"Pipe{number + 1}", next(face for face in pipe if len(face.Edges) == 3))
    walls.append(wall)
    rims.append((wall, next(f"Edge{index}" for index, edge in enumerate(wall.Shape.Edges, 1)
                            if edge.isClosed() and (edge.CenterOfMass - 14 * along).Length < 1e-6)))
document.recompute()
ends = [obj.Shape.getElement(edge).discretize(9)[index] for (obj, edge), index in zip(rims, (1, 3))]
line = gui.part(document, "Line", Part.makeLine(*ends))
document.recompute()
gui.look_at_all()
gui.select(document, *rims)
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
assert gui.widget("cutsButton").isVisible() and not gui.widget("ringCheck").isVisible()
gui.widget("cutsButton").click()
Gui.Selection.addSelection(document.Name, line.Name, "Edge1")
gui.wait_for_verdict()
gui.widget("cutsButton").click()
assert gui.widget("cutsButton").text() == "Cuts shown: 1", gui.widget("cutsButton").text()
gui.picture("blend_cuts")
gui.press("Ok")
made = document.Blend
assert made.Cuts == [(line, ("Edge1",))] and not made.Ring and made.WithinTolerance, made.Verdict
corners = [vertex.Point for face in made.Shape.Faces for vertex in face.Vertexes]
for end in ends:
    assert min(corner.distanceToPoint(end) for corner in corners) < 1e-5
print("passed")
