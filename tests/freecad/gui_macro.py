# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's macro recorder writes down while the panel is used runs again, in another document, to the same
result."""

import os
import tempfile

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

import gui
import support

FOLDER = tempfile.mkdtemp()


def record(name):
    """Starts the recorder; its dialog is modal and is filled in from the event loop."""
    def fill_in():
        dialog = QtGui.QApplication.activeModalWidget()
        dialog.findChild(QtGui.QLineEdit, "lineEditPath").setText(name)
        dialog.findChild(QtGui.QPushButton, "buttonStart").click()

    QtCore.QTimer.singleShot(500, fill_in)
    Gui.runCommand("Std_DlgMacroRecord")
    gui.pump(0.2)


def use_the_panel(document, edge):
    Gui.Selection.addSelection(document.Name, "Base", edge)
    Gui.runCommand("Fairing_FillHole")
    gui.wait_for_verdict()
    gui.widget("boundaryTable").cellWidget(2, 2).setCurrentText("G0")
    gui.wait_for_verdict()
    gui.press("Ok")
    Gui.ActiveDocument.setEdit("Fill")
    gui.wait_for_verdict()
    gui.widget("energyCombo").setCurrentIndex(1)
    gui.wait_for_verdict()
    gui.press("Ok")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, "Base")
    Gui.runCommand("Fairing_FillAllHoles")
    gui.wait_for_verdict("Fills")
    gui.widget("continuityCombo").setCurrentIndex(0)
    gui.wait_for_verdict("Fills")
    gui.press("Ok")


App.ParamGet("User parameter:BaseApp/Preferences/Macro").SetString("MacroPath", FOLDER)
gui.start()
document, base, edges = support.example()
gui.look_at_all()
record("fill")
use_the_panel(document, edges[0])
Gui.runCommand("Std_MacroStopRecord")
recorded = document.Fill.Shape
wishes = document.Fill.EdgeContinuity
assert document.Fill.Energy == "membrane" and len(wishes) == 1 and document.UndoNames == [
    "Fill all holes", "Edit Fill", "Fill hole"]

with open(os.path.join(FOLDER, "fill.FCMacro")) as file:
    macro = file.read()
lines = [line for line in macro.splitlines() if "fairing" in line]
print("\n".join(lines))
assert lines[0] == "import fairing" and lines[-3].startswith("fairing.make_fill(")
assert lines[-1] == "fairing.make_fill_all(FreeCAD.ActiveDocument.getObject('Base'), continuity='G0')"
assert lines[-2] == "fairing.change_fill(FreeCAD.ActiveDocument.getObject('Fill'), energy='membrane')"

second, _, _ = support.example("Second")
App.setActiveDocument(second.Name)
exec(compile(macro, "fill.FCMacro", "exec"), {"__name__": "__main__", "App": App, "Gui": Gui})
fill = second.Fill
assert fill.isValid() and fill.Energy == "membrane" and fill.EdgeContinuity == wishes
assert abs(fill.Shape.Area - recorded.Area) < 1e-9 * recorded.Area
assert fill.Shape.CenterOfMass.distanceToPoint(recorded.CenterOfMass) < 1e-9
assert second.FillAll.isValid() and second.FillAll.Continuity == "G0" and len(second.FillAll.Shape.Faces) == 1
print("passed")
