# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach of a blend in the window: sliders and arrows move the surface at once, OK takes what they show; the panel
lists the whole chains and lets go of picked edges."""

import statistics
import time

import FreeCAD as App
import FreeCADGui as Gui
import Part

import gui
from seen import drawn_points

LONGEST_FRAME = 0.033  # s from a slider's value to triangles, median; what the window's thread computes, so that other
# processes of a busy machine do not count
panels = gui.keep_panels()


def tube(document, name, radius, bottom, height):
    obj = document.addObject("Part::Feature", name)
    obj.Shape = Part.makeCircle(radius, App.Vector(0, 0, bottom)).extrude(App.Vector(0, 0, height))
    return obj


def rim(obj, z):
    return next(f"Edge{number}" for number, edge in enumerate(obj.Shape.Edges, 1)
                if edge.BoundBox.ZLength < 1e-6 and abs(edge.BoundBox.ZMin - z) < 1e-6)


def tip(side):
    return panels[-1]._display._handles._arrows[side].tip


def reaches():
    return gui.widget("fromReachSpin").value(), gui.widget("toReachSpin").value()


gui.start()
document = App.newDocument("Tubes")
low, high = tube(document, "Low", 10, 0, 20), tube(document, "High", 6, 35, 15)
document.recompute()
edges = rim(low, 20), rim(high, 35)
view = gui.look_at_all()
gui.select(document, ("Low", edges[0]), ("High", edges[1]))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict("Meets all 2 edges")
assert reaches() == (1.0, 1.0) and gui.widget("fromReachSlider").value() == 0

# The way from a slider's value to triangles, as the window's thread goes it.
slider, times = gui.widget("fromReachSlider"), []
for position in range(-40, 41):
    before = time.thread_time()
    slider.setValue(position)
    times.append(time.thread_time() - before)
print(f"reach slider to triangles: median {1e3 * statistics.median(times):.1f} ms, longest {1e3 * max(times):.1f} ms")
assert statistics.median(times) <= LONGEST_FRAME, times
slider.setValue(0)
gui.wait_for_verdict("Meets all 2 edges")

# Dragged with the mouse it moves the surface; the verdict is that of what is shown.
before = drawn_points(panels)
gui.drag_slider("fromReachSlider", 0.2)
assert 1.2 < reaches()[0] < 2.5 and reaches()[1] == 1.0
assert gui.verdict().startswith("Meets all 2 edges") and drawn_points(panels) != before
assert "." in gui.widget("fromTable").item(0, 4).text() and "\u00b0" in gui.widget("fromTable").item(0, 4).text()
gui.settle()
slid = reaches()[0]

# An arrow's tip dragged: the same for the other side. The camera stays, nothing is selected.
camera = view.getCamera()
middle = []
start = tip(1)
gui.drag(view, start, start + App.Vector(0, 0, -3),
         at_half=lambda: (middle.append(reaches()[1]), gui.picture("blend_reach_dragged")))
assert 1.0 < middle[0] < reaches()[1], (middle, reaches())
arrow = panels[-1]._display._handles._arrows[1]
# a step of the mouse is a pixel, here some hundredths of the arrow
assert abs((tip(1) - start).z + 3) < 0.5 and abs(reaches()[1] - (1 + 3 / arrow.vector.Length)) < 0.1
assert view.getCamera() == camera and not Gui.Selection.hasSelection() and reaches()[0] == slid
gui.settle()
shown = drawn_points(panels)
gui.press("Ok")
blend = document.Blend
assert blend.FromReach == slid and blend.ToReach > middle[0]
assert blend.WithinTolerance and document.UndoNames == ["Blend faces"]
face = blend.Shape.Faces[0]
apart = max(face.distToShape(Part.Vertex(App.Vector(*point)))[0] for point in shown[::40])
assert apart < 1e-3, f"OK took another surface than was shown, {apart} mm away"  # drawn in single precision

# Edited: a number typed; Cancel keeps what was.
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict("Meets all 2 edges")
assert reaches() == (blend.FromReach, blend.ToReach)
gui.widget("toReachSpin").setValue(0.5)
gui.settle()
assert gui.widget("toReachSlider").value() < 0
gui.press("Cancel")
assert blend.ToReach > 1.2

# The whole chain is listed; what was not picked is slanted, and goes with the pick.
planes = App.newDocument("Planes")
floor = planes.addObject("Part::Feature", "Floor")
floor.Shape = Part.makeShell([Part.makePlane(8, 10), Part.makePlane(12, 10, App.Vector(8, 0, 0))])
upper = planes.addObject("Part::Feature", "Upper")
upper.Shape = Part.makePlane(20, 10, App.Vector(0, 20, 8))
planes.recompute()
view = gui.look_at_all()
picked, found = gui.edge_at(floor.Shape, (4, 10, 0)), gui.edge_at(floor.Shape, (14, 10, 0))
gui.select(planes, ("Floor", picked), ("Upper", gui.edge_at(upper.Shape, (10, 20, 8))))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict("Meets all 3 edges")
table = gui.widget("fromTable")
rows = {table.item(row, 0).text(): row for row in range(table.rowCount())}
assert set(rows) == {f"Floor.{picked}", f"Floor.{found}"}
slanted = {name: table.item(row, 0).font().italic() for name, row in rows.items()}
assert slanted == {f"Floor.{picked}": False, f"Floor.{found}": True}
assert "by itself" in table.item(rows[f"Floor.{found}"], 0).toolTip()
gui.picture("blend_chain")
table.selectRow(rows[f"Floor.{found}"])
assert not gui.widget("dropButton").isEnabled()
table.cellWidget(rows[f"Floor.{found}"], 2).setCurrentText("G0")
gui.wait_for_verdict("Meets all 3 edges")
gui.press("Ok")
assert planes.Blend.FromContinuity == [f"{found}=G0"] and planes.Blend.FromEdges == [(floor, (picked,))]
Gui.ActiveDocument.setEdit("Blend")
gui.wait_for_verdict("Meets all 3 edges")
table = gui.widget("fromTable")
table.selectRow(next(row for row in range(2) if not table.item(row, 0).font().italic()))
assert gui.widget("dropButton").isEnabled()
gui.widget("dropButton").click()
gui.pump(0.2)
assert not gui.widget("fromTable").isVisible() and gui.widget("promptLabel").isVisible()
assert not gui.widget("fromReachRow").isVisible()
gui.press("Cancel")
assert planes.Blend.FromEdges == [(floor, (picked,))]

# Three pipes that are three objects: a junction of the first picked one with the others. Its reach has a slider, but no
# arrow.
junction = App.newDocument("Junction")
rims = []
for name, turn in (("A", 0), ("B", 120), ("C", 240)):
    pipe = tube(junction, name, 6, 20, 10)
    rims.append((pipe, rim(pipe, 20)))
    pipe.Placement = App.Placement(App.Vector(), App.Rotation(App.Vector(0, 1, 0), turn))
junction.recompute()
gui.look_at_all()
gui.select(junction, *((pipe.Name, edge) for pipe, edge in rims))
assert gui.action_is_enabled("Fairing_BlendFaces")
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict("Meets all 3 edges")
assert gui.widget("fromTable").rowCount() == 1 and gui.widget("toTable").rowCount() == 2
assert gui.widget("fromReachRow").isVisible() and gui.widget("toReachRow").isVisible()
assert not panels[-1]._display._handles._arrows
gui.picture("blend_junction")
gui.press("Ok")
made = junction.Blend
assert made.FromEdges == [(rims[0][0], (rims[0][1],))]
assert made.ToEdges == [(pipe, (edge,)) for pipe, edge in rims[1:]]
assert made.isValid() and made.Shape.isValid() and made.WithinTolerance and made.FromReach == 1.0
assert set(made.ReportEdges) == {f"{pipe.Name}.{edge}" for pipe, edge in rims}
for pipe, edge in rims:
    points = pipe.Shape.getElement(edge).discretize(23)
    # the kernel's distance to a shape is exact to its own tolerance
    assert max(made.Shape.distToShape(Part.Vertex(point))[0] for point in points) < 1e-4
print("passed")
