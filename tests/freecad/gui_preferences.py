# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preference page: shows the defaults, keeps what is chosen, and a new fill starts from it."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

import gui
import support
from fairing import settings

seen = {}


def choose():
    """In the open dialog: looks at the defaults, chooses others, presses OK."""
    dialog = QtGui.QApplication.activeModalWidget()
    page = dialog.findChild(QtGui.QWidget, "FairingPreferences")

    def field(name):
        return page.findChild(QtGui.QWidget, name)

    seen["continuity"] = field("continuityCombo").currentIndex()
    seen["angle"] = field("angleSpin").value()
    gui.picture("10_preferences")
    field("energyCombo").setCurrentIndex(1)
    field("angleSpin").setValue(0.05)
    field("labelsCheck").setChecked(False)
    field("resultCombo").setCurrentIndex(1)
    buttons = dialog.findChildren(QtGui.QDialogButtonBox)
    next(box for box in buttons if box.button(QtGui.QDialogButtonBox.Apply)).button(QtGui.QDialogButtonBox.Ok).click()


gui.start()
document, base, edges = support.example()
gui.look_at_all()
QtCore.QTimer.singleShot(1500, choose)
Gui.showPreferences("Fairing", 0)
assert seen == {"continuity": 1, "angle": 0.02}, seen

chosen = settings.new_choices()
assert (chosen["energy"], chosen["angle_tolerance"], chosen["result"]) == ("membrane", 0.05, "shell"), chosen
assert (chosen["continuity"], chosen["layout"]) == ("G1", "auto"), chosen
Gui.Selection.addSelection(document.Name, base.Name, edges[0])
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict()
assert gui.widget("energyCombo").currentIndex() == 1 and not gui.widget("labelsCheck").isChecked()
gui.press("Ok")
assert document.Fill.Energy == "membrane" and document.Fill.AngleTolerance.Value == 0.05
assert document.Fill.Shape.ShapeType == "Shell" and document.Fill.isValid()
print("passed")
