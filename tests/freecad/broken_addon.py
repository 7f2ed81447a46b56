# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench without a native module that works: it loads, and says what is wrong (the first argument) and what to
do."""

import sys

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

import fairing
import gui
import support

EXPECTED = sys.argv[1]
shown = []


def close_message():
    box = QtGui.QApplication.activeModalWidget()
    shown.append(box.text())
    box.accept()


gui.start()
document, base, edges = support.example()
gui.look_at_all()
Gui.Selection.addSelection(document.Name, base.Name, edges[0])
QtCore.QTimer.singleShot(800, close_message)
Gui.runCommand("Fairing_FillHole")
assert len(shown) == 1 and EXPECTED in shown[0] and "Traceback" not in shown[0], shown
assert not gui.panel_is_open() and document.Objects == [base]
try:
    fairing.make_fill(base, edges[:1])
    raise AssertionError("no module, no fill")
except fairing.NativeModuleError as error:
    assert str(error) == shown[0] and "build the add-on" in str(error)
assert document.Objects == [base] and App.ActiveDocument is document
print("passed")
