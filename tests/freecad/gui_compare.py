# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare in the real window: the same hole with every energy, looked at row by row, one of them used."""

import FreeCAD as App
import FreeCADGui as Gui
import Part

import gui

RADIUS = 30.0


def rows():
    table = gui.widget("compareTable")
    return {table.item(row, 0).text(): [table.item(row, column).text() if table.item(row, column) else ""
                                        for column in range(table.columnCount())]
            for row in range(table.rowCount())}


def filled_rows():
    return sum(bool(texts[8]) for texts in rows().values())


def compare():
    gui.widget("compareButton").click()
    gui.pump(0.1)
    gui.settle()
    gui.wait_for(lambda: filled_rows() == len(rows()) > 5, "every energy")


gui.start()
document = App.newDocument("Sphere")
sphere = Part.makeSphere(RADIUS)
hole = Part.makeCylinder(15, 60)
base = gui.part(document, "Base", Part.Face.cut(sphere.Faces[0], hole))
document.recompute()
gui.look_at_all()
import fairing  # noqa: E402

panels = gui.keep_panels()
gui.select(document, (base, fairing.holes(base.Shape)[0][0]))
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict()
gui.widget("pictureCombo").setCurrentIndex(1)
gui.settle()
chosen = gui.widget("energyCombo").currentIndex()

# Every energy has its row; minimum variation has the least of what it is about.
compare()
variation = {name: float(texts[7]) for name, texts in rows().items()}
assert min(variation, key=variation.get) == "Minimum variation", variation
table = gui.widget("compareTable")
assert not gui.widget("useButton").isEnabled() and table.isColumnHidden(3)
bold = {table.item(row, 0).text() for row in range(len(rows())) if table.item(row, 7).font().bold()}
assert "Minimum variation" in bold, bold

# A row is looked at in the 3D view, the panel's own choice stays.
for number, name in enumerate(("Membrane", "Minimum variation"), 51):
    row = list(rows()).index(name)
    table.selectRow(row)
    gui.pump(0.3)
    shown = panels[-1]._drawn.report["fairness"]["minimum_variation"]
    assert abs(shown - variation[name]) <= 1e-3 * shown + 1e-12, (shown, variation[name])
    gui.picture(f"{number}_compare_{name.lower().replace(' ', '_')}")
assert gui.widget("energyCombo").currentIndex() == chosen

# Used: the panel shows it without solving it again, and OK stores it.
gui.widget("useButton").click()
gui.wait_for_verdict()
assert gui.widget("energyCombo").currentText() == "Minimum variation"
gui.ok()
assert document.Fill.Energy == "minimum-variation" and document.Fill.isValid()

# Closed without using any: all is as before. Stopped: what is there stays.
Gui.ActiveDocument.setEdit("Fill")
gui.wait_for_verdict()
compare()
gui.widget("compareTable").selectRow(0)
gui.pump(0.2)
gui.widget("compareCloseButton").click()
gui.wait_for_verdict()
assert gui.widget("energyCombo").currentText() == "Minimum variation" and panels[-1]._comparison is None
gui.widget("degreeSpin").setValue(6)
gui.wait_for_verdict()
gui.widget("compareButton").click()
gui.pump(0.05)
gui.widget("compareStopButton").click()
gui.settle()
assert filled_rows() < 6
gui.widget("allG2Button").click()  # another question: nothing to compare any more
gui.settle()
assert panels[-1]._comparison is None

# Neither is there when a guide moves the surface at once.
gui.widget("compareButton").click()
assert panels[-1]._comparison is not None and panels[-1]._kept is not None
panels[-1]._guidance.place((0, 0, RADIUS), (0.2, 0, 1))
assert panels[-1]._comparison is None
gui.settle()
gui.press("Cancel")
App.closeDocument(document.Name)

# A blend: the same.
document = App.newDocument("Pipes")
low = gui.part(document, "Low", Part.makeCircle(10).extrude(App.Vector(0, 0, 20)))
high = gui.part(document, "High", Part.makeCircle(14, App.Vector(6, 0, 45)).extrude(App.Vector(0, 0, 20)))
document.recompute()
gui.look_at_all()
gui.select(document, (low, gui.edge_at(low.Shape, (0, 0, 20))), (high, gui.edge_at(high.Shape, (6, 0, 45))))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
compare()
values = {name: float(texts[5]) for name, texts in rows().items()}
assert values["Total curvature"] <= values["Thin plate"], values
gui.widget("compareTable").selectRow(list(rows()).index("Total curvature"))
gui.pump(0.2)
gui.picture("53_compare_blend")
gui.widget("useButton").click()
gui.wait_for_verdict()
gui.ok()
assert document.Blend.Energy == "total-curvature" and document.Blend.isValid()
print("passed")
