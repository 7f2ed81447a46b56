# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blend Faces in the window: the panel joins two edges in the order they were selected or picked, edits the result, and
tells what cannot be joined; the macro recorder writes it down."""

import os
import tempfile

import FreeCAD as App
import FreeCADGui as Gui
import Part
from PySide import QtCore, QtGui

import gui
import support

NAME = "Fairing_BlendFaces"
said = []


def two_planes(name):
    """A document with two rectangles, objects of their own, and the edges that face each other."""
    document = App.newDocument(name)
    for label, y, z in (("Low", 0, 0), ("High", 20, 8)):
        document.addObject("Part::Feature", label).Shape = Part.makePlane(20, 10, App.Vector(0, y, z))
    document.recompute()
    return document, gui.edge_at(document.Low.Shape, (10, 10, 0)), gui.edge_at(document.High.Shape, (10, 20, 8))


def read_message_and_close():
    box = QtGui.QApplication.activeModalWidget()
    said.append(box.text())
    box.button(QtGui.QMessageBox.Ok).click()


gui.start()
folder = tempfile.mkdtemp()
document, low_edge, high_edge = two_planes("Planes")
gui.look_at_all()

# One edge: nothing to join. None: the panel asks.
gui.select(document, ("Low", low_edge))
assert not gui.action_is_enabled(NAME)
Gui.Selection.clearSelection()
assert gui.action_is_enabled(NAME)
Gui.runCommand(NAME)
gui.pump(0.2)
assert gui.widget("promptLabel").isVisible() and not gui.widget("fromTable").isVisible()
assert not gui.widget("layoutCombo").isVisible() and gui.widget("energyCombo").isVisible()
gui.press("Ok")
assert gui.panel_is_open() and document.getObject("Blend") is None

# The first pick is where it starts, the next one where it ends; faces are no picks.
Gui.Selection.addSelection(document.Name, "Low", "Face1")
gui.wait_for(lambda: "Pick an edge" in Gui.getMainWindow().statusBar().currentMessage(), "the hint")
Gui.Selection.addSelection(document.Name, "High", high_edge)
gui.wait_for(lambda: gui.widget("toButton").isChecked(), "the other side's turn")
Gui.Selection.addSelection(document.Name, "Low", low_edge)
gui.wait_for_verdict("Meets all 2 edges")
assert not gui.widget("promptLabel").isVisible()
assert gui.widget("fromTable").item(0, 0).text() == f"High.{high_edge}"
assert gui.widget("toTable").item(0, 0).text() == f"Low.{low_edge}" and gui.widget("toTable").item(0, 4).text()
assert gui.widget("toTable").item(0, 1).text() == "1", "the face beside the edge"
gui.picture("blend_panel")
gui.press("Cancel")
assert document.getObject("Blend") is None and not gui.panel_is_open()

# The context menu of the view offers it where there is something to join.
menus = []
workbench = Gui.activeWorkbench()
workbench.appendContextMenu = lambda place, names: menus.append(names)
for picks in ((("High", high_edge),), (("High", high_edge), ("Low", low_edge))):
    gui.select(document, *picks)
    workbench.ContextMenu("View")
assert menus == [["Fairing_FillHole"], ["Fairing_FillHole", NAME]], menus

# With two edges selected it shows the surface at once.
gui.select(document, ("High", high_edge), ("Low", low_edge))
assert gui.action_is_enabled(NAME)
Gui.runCommand(NAME)
gui.wait_for_verdict("Meets all 2 edges")
gui.press("Ok")
blend = document.Blend
assert blend.FromEdges == [(document.High, (high_edge,))] and blend.ToEdges == [(document.Low, (low_edge,))]
assert blend.isValid() and blend.WithinTolerance and len(blend.Shape.Faces) == 1
assert type(blend.ViewObject.Proxy).__name__ == "BlendView"
icon = blend.ViewObject.Proxy.getIcon()
assert os.path.exists(icon) and not QtGui.QIcon(icon).pixmap(64, 64).isNull()
assert not Gui.Selection.hasSelection() and document.UndoNames == ["Blend faces"]
assert not gui.panel_is_open()
gui.picture("blend")

# Edited: one edge only touched, another energy; Cancel keeps what was, OK takes it.
area = blend.Shape.Area
for button in ("Cancel", "Ok"):
    Gui.ActiveDocument.setEdit("Blend")
    gui.wait_for_verdict("Meets all 2 edges")
    gui.widget("toTable").cellWidget(0, 2).setCurrentText("G0")
    gui.widget("energyCombo").setCurrentIndex(1)
    gui.wait_for_verdict()
    gui.press(button)
    changed = button == "Ok"
    assert (blend.ToContinuity == [f"{low_edge}=G0"]) is changed and (blend.Energy == "membrane") is changed
    assert (blend.Shape.Area == area) is not changed and blend.ViewObject.Visibility
document.undo()
assert document.Blend.ToContinuity == [] and document.UndoNames == ["Blend faces"]

# One step to undo.
document.undo()
assert document.getObject("Blend") is None
document.redo()
assert document.Blend.isValid()

# What cannot be joined is told in one sentence, and nothing is made.
before = [obj.Name for obj in document.Objects]
gui.select(document, ("Low", low_edge), ("Low", gui.edge_at(document.Low.Shape, (0, 5, 0))),
       ("Low", gui.edge_at(document.Low.Shape, (20, 5, 0))))
QtCore.QTimer.singleShot(500, read_message_and_close)
Gui.runCommand(NAME)
assert said == ["The edges make one chain: a blend joins two or more."], said
gui.select(document, ("Blend", "Edge1"), ("Blend", "Edge1"))
assert not gui.action_is_enabled(NAME), "one edge picked twice"
assert [obj.Name for obj in document.Objects] == before

# The user's defaults are asked for, and the base of a result that contains it is hidden.
group = App.ParamGet("User parameter:BaseApp/Preferences/Mod/Fairing")
group.SetInt("Continuity", 2)
group.SetInt("Result", 2)
second, low_edge, high_edge = two_planes("Second")
gui.select(second, ("Low", low_edge), ("High", high_edge))
App.ParamGet("User parameter:BaseApp/Preferences/Macro").SetString("MacroPath", folder)


def name_the_macro():
    dialog = QtGui.QApplication.activeModalWidget()
    dialog.findChild(QtGui.QLineEdit, "lineEditPath").setText("blend")
    dialog.findChild(QtGui.QPushButton, "buttonStart").click()


QtCore.QTimer.singleShot(500, name_the_macro)
Gui.runCommand("Std_DlgMacroRecord")
gui.pump(0.2)
Gui.runCommand(NAME)
gui.wait_for_verdict("Meets all 2 edges")
gui.press("Ok")
Gui.runCommand("Std_MacroStopRecord")
made = second.Blend
assert made.Continuity == "G2" and made.ResultMode == "base" and len(made.Shape.Faces) == 3
assert not second.Low.ViewObject.Visibility and not second.High.ViewObject.Visibility
assert made.ViewObject.Proxy.claimChildren() == [second.Low, second.High]

# What the recorder wrote does the same elsewhere.
with open(os.path.join(folder, "blend.FCMacro")) as file:
    macro = file.read()
lines = [line for line in macro.splitlines() if "fairing" in line]
assert lines[0] == "import fairing" and lines[-1] == (
    f"fairing.make_blend((FreeCAD.ActiveDocument.getObject('Low'), ['{low_edge}']), "
    f"(FreeCAD.ActiveDocument.getObject('High'), ['{high_edge}']), continuity='G2', result='base')"), lines
third, _, _ = two_planes("Third")
App.setActiveDocument(third.Name)
exec(compile(macro, "blend.FCMacro", "exec"), {"__name__": "__main__", "App": App, "Gui": Gui})
assert abs(third.Blend.Shape.Area - made.Shape.Area) < 1e-9 * made.Shape.Area

# Deleting it shows again what it contained.
App.setActiveDocument(second.Name)
made.ViewObject.Proxy.onDelete(made.ViewObject, ())
assert second.Low.ViewObject.Visibility and second.High.ViewObject.Visibility
print("passed")
