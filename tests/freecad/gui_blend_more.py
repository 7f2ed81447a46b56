# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is rarely chosen about a blend, folded away in the panel: reach that changes along a side, direction, setback
by a distance and to a curve, and which points belong together, shown in the view; kept by the object and written into
macros."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

import gui

panels = gui.keep_panels()


def vertex_at(obj, point):
    return next(f"Vertex{number}" for number, vertex in enumerate(obj.Shape.Vertexes, 1)
                if vertex.Point.isEqual(App.Vector(*point), 1e-6))


def matches():
    """Points that belong together as drawn, two by two."""
    points = [App.Vector(*point) for point in panels[-1]._display._preview._matches._points.point.getValues()]
    return list(zip(points[::2], points[1::2]))


gui.start()

# Open sides: folded away until asked for; every choice reaches the object.
document = App.newDocument("Planes")
low = gui.part(document, "Low", Part.makePlane(20, 10))
high = gui.part(document, "High", Part.makePlane(20, 10, App.Vector(0, 20, 8)))
document.recompute()
gui.look_at_all()
low_edge, high_edge = gui.edge_at(low.Shape, (10, 10, 0)), gui.edge_at(high.Shape, (10, 20, 8))
gui.select(document, (low, low_edge), (high, high_edge))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
assert gui.widget("moreButton").isVisible() and not gui.widget("moreBox").isVisible()
gui.widget("moreButton").click()
assert gui.widget("moreBox").isVisible() and not gui.widget("alignmentSlider").isEnabled()
gui.widget("fromReachEndCheck").click()
assert gui.widget("fromReachEndSpin").isEnabled() and gui.widget("fromReachEndSpin").value() == 1.0
gui.widget("fromReachEndSpin").setValue(2.0)
gui.wait_for_verdict()
gui.widget("toDepartureCombo").setCurrentIndex(1)
gui.wait_for_verdict()
gui.picture("blend_more")
gui.press("Ok")
blend = document.Blend
assert blend.FromReachEnd == 2.0 and blend.FromReach == 1.0 and blend.ToDeparture == "perpendicular"
ends = [blend.Shape.Faces[0].Surface.parameter(App.Vector(x, 10, 0)) for x in (0, 20)]
surface = blend.Shape.Faces[0].Surface
legs = [max(abs(surface.getDN(u, v, *order).y) for order in ((1, 0), (0, 1))) for u, v in ends]  # across the edge
assert abs(max(legs) / min(legs) - 2.0) < 0.01, legs

# Edited, the choices are seen at once.
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
assert gui.widget("moreBox").isVisible() and gui.widget("fromReachEndSpin").value() == 2.0
gui.widget("fromReachEndCheck").click()
gui.widget("toDepartureCombo").setCurrentIndex(0)
gui.type_into("toSetbackSpin", "2 mm")
gui.wait_for_verdict()
gui.press("Ok")
assert blend.FromReachEnd == 0.0 and blend.ToDeparture == "free" and blend.ToSetback.Value == 2.0
assert abs(blend.Shape.BoundBox.YMax - 22.0) < 0.01, "the blend ends 2 mm inside the upper plane"

# A curve to set back to: a sketch picked in the tree, its edges, taken away again; in the macro and on editing.
sketch = document.addObject("Sketcher::SketchObject", "Line")
sketch.Placement.Base = App.Vector(0, 0, 8.1)
sketch.addGeometry(Part.LineSegment(App.Vector(-1, 23, 0), App.Vector(21, 24, 0)), False)
document.recompute()
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
gui.type_into("toSetbackSpin", "0 mm")
gui.wait_for_verdict()
gui.widget("toCurveButton").click()
assert gui.widget("toCurveButton").text() == "Pick an edge"
Gui.Selection.addSelection(document.Name, "Low", low_edge.replace("Edge", "Vertex"))
gui.wait_for(lambda: "or a sketch" in Gui.getMainWindow().statusBar().currentMessage(), "the hint")
assert gui.widget("toCurveButton").isChecked()
Gui.Selection.addSelection(document.Name, "Line", "Edge1")
gui.wait_for(lambda: not gui.widget("toCurveButton").isChecked(), "the curve")
gui.wait_for_verdict()
assert gui.widget("toCurveButton").text() == "Line: Edge1" and gui.widget("fromCurveButton").text() == "To a curve"
assert "laid onto face" in gui.verdict(), gui.verdict()
gui.picture("blend_curve")
gui.type_into("toSetbackSpin", "1 mm")
gui.wait_for_verdict("The side \"to\" is set back by a distance and by a curve")
gui.type_into("toSetbackSpin", "0 mm")
gui.wait_for_verdict()
gui.press("Ok")
assert blend.ToCurve == [(sketch, ("Edge1",))] and blend.FromCurve == [], blend.ToCurve
ends = sorted(vertex.Y for vertex in blend.Shape.Vertexes)[-2:]
assert max(abs(ends[0] - 23.0 - 1 / 22), abs(ends[1] - 24.0 + 1 / 22)) < 1e-5, ends
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
assert gui.widget("moreBox").isVisible() and gui.widget("toCurveButton").text() == "Line: Edge1"
gui.widget("toCurveRemoveButton").click()
gui.wait_for_verdict()
assert gui.widget("toCurveButton").text() == "To a curve" and not gui.widget("toCurveRemoveButton").isEnabled()
gui.widget("toCurveButton").click()
Gui.Selection.addSelection(document.Name, "Line")
gui.wait_for(lambda: gui.widget("toCurveButton").text() == "Line", "the sketch")
gui.wait_for_verdict()
gui.press("Ok")
assert [obj.Name for obj, _ in blend.ToCurve] == ["Line"] and blend.isValid()
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
gui.widget("toCurveRemoveButton").click()
gui.wait_for_verdict()
gui.press("Ok")
assert blend.ToCurve == [] and abs(blend.Shape.BoundBox.YMax - 20.0) < 1e-5

# Two vertices picked belong together.
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict()
gui.type_into("toSetbackSpin", "0 mm")
gui.wait_for_verdict()
gui.press("Cancel")
split = gui.part(document, "Split", Part.makeShell([Part.makePlane(6, 10, App.Vector(0, 50, 0)),
                                                Part.makePlane(14, 10, App.Vector(6, 50, 0))]))
other = gui.part(document, "Other", Part.makeShell([Part.makePlane(12, 10, App.Vector(0, 70, 8)),
                                                Part.makePlane(8, 10, App.Vector(12, 70, 8))]))
document.recompute()
gui.select(document, (split, gui.edge_at(split.Shape, (3, 60, 0))), (other, gui.edge_at(other.Shape, (6, 70, 8))))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
gui.widget("moreButton").setChecked(True)
gui.widget("pairButton").click()
Gui.Selection.addSelection(document.Name, "Other", vertex_at(other, (12, 70, 8)))
gui.wait_for(lambda: "belongs" in gui.widget("pairButton").text(), "the other vertex's turn")
Gui.Selection.addSelection(document.Name, "Other", vertex_at(other, (20, 70, 8)))
gui.wait_for(lambda: "other side" in Gui.getMainWindow().statusBar().currentMessage(), "the hint")
Gui.Selection.addSelection(document.Name, "Split", vertex_at(split, (6, 60, 0)))
gui.wait_for(lambda: not gui.widget("pairButton").isChecked(), "the pair")
gui.wait_for_verdict()
assert gui.widget("pairList").count() == 1
assert any(a.isEqual(App.Vector(6, 60, 0), 1e-4) and b.isEqual(App.Vector(12, 70, 8), 1e-4) for a, b in matches())
gui.picture("blend_pairs")
gui.press("Ok")
paired = document.ActiveObject
assert paired.Pairs == [f"{vertex_at(split, (6, 60, 0))}={vertex_at(other, (12, 70, 8))}"], paired.Pairs
assert paired.isValid()

# Closed sides: where the blend starts is shown on both, and can be turned.
pipes = App.newDocument("Pipes")
tubes = [gui.part(pipes, name, Part.makeCircle(radius, App.Vector(0, 0, z)).extrude(App.Vector(0, 0, 15)))
         for name, radius, z in (("Wide", 10, 0), ("Narrow", 6, 30))]
pipes.recompute()
gui.look_at_all()
rims = [gui.edge_at(tube.Shape, (0, 0, z)) for tube, z in zip(tubes, (15, 30))]
gui.select(pipes, *zip(tubes, rims))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
gui.widget("moreButton").setChecked(True)
assert gui.widget("alignmentSlider").isEnabled() and not gui.widget("fromReachEndCheck").isEnabled()
assert len(matches()) == 1
start, end = matches()[0]
assert abs(start.z - 15) < 1e-3 and abs(end.z - 30) < 1e-3
gui.widget("alignmentSpin").setValue(0.1)
gui.wait_for_verdict("")
turned = matches()[0][1]
angle = App.Vector(turned.x, turned.y, 0).getAngle(App.Vector(end.x, end.y, 0))
assert abs(angle - 0.2 * 3.14159265) < 1e-3, angle
gui.picture("blend_turned")
gui.press("Ok")
assert pipes.Blend.Alignment == 0.1
print("passed")
