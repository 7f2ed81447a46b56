# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a surface passes through, picked in the real window: points, edges and whole objects, kept and left out."""

import FreeCAD as App
import FreeCADGui as Gui

import gui
import support


def rows():
    shown = gui.widget("throughList")
    return [shown.item(row).text().split("   ")[0] for row in range(shown.count())]


def pick(*names):
    gui.widget("throughButton").setChecked(True)
    Gui.Selection.addSelection(document.Name, *names)
    gui.wait_for(lambda: not gui.widget("throughButton").isChecked(), "the pick to be taken")
    gui.settle()


gui.start()
document, base, edges = support.example()
top = max(vertex.Z for vertex in base.Shape.Vertexes)
point = document.addObject("Part::Vertex", "Point")
point.X, point.Y, point.Z = 0.0, 0.0, top
wire = document.addObject("Part::Feature", "Wire")
wire.Shape = support.Part.makeLine(App.Vector(-8, 0, top + 1), App.Vector(8, 0, top + 1))
document.recompute()
gui.look_at_all()

Gui.Selection.addSelection(document.Name, base.Name, edges[0])
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict()
assert rows() == [] and not gui.widget("throughList").isVisible()
assert not gui.widget("throughRemoveButton").isEnabled()

# A vertex in the view, an edge, a whole object in the tree.
pick("Point", "Vertex1")
assert rows() == ["Point: Vertex1"] and gui.widget("throughList").isVisible()
pick("Wire", "Edge1")
assert rows() == ["Point: Vertex1", "Wire: Edge1"]
gui.picture("15_through")

# A face is no point, and says so.
gui.widget("throughButton").setChecked(True)
Gui.Selection.addSelection(document.Name, base.Name, "Face1")
gui.wait_for(lambda: "Pick a point" in Gui.getMainWindow().statusBar().currentMessage(), "the reason")
gui.widget("throughButton").setChecked(False)

# The selected row goes; then everything.
gui.widget("throughList").setCurrentRow(1)
gui.widget("throughRemoveButton").click()
gui.settle()
assert rows() == ["Point: Vertex1"]
gui.ok()
fill = document.Fill
assert [(obj.Name, names) for obj, names in fill.Through] == [("Point", ("Vertex1",))], fill.Through
assert fill.isValid(), fill.Verdict

Gui.ActiveDocument.setEdit(fill.Name)
gui.settle()
assert rows() == ["Point: Vertex1"]
gui.widget("throughRemoveButton").click()
gui.settle()
pick("Wire")
assert rows() == ["Wire"]
gui.ok()
assert [obj.Name for obj, _ in fill.Through] == ["Wire"] and fill.isValid()
print("passed")
