# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filling all holes in the real window: the table, ticks, rows that light their holes, OK, undo, edit, the macro line."""

import threading

import FreeCADGui as Gui
from PySide import QtCore

import gui
import support


def table():
    return gui.widget("holesTable")


def column(number):
    return [table().item(row, number).text() for row in range(table().rowCount())]


def tick(row, on):
    table().item(row, 0).setCheckState(QtCore.Qt.Checked if on else QtCore.Qt.Unchecked)
    gui.pump(0.1)
    gui.settle()


gui.start()
document, base = support.four_holes()
view = gui.look_at_all()

# One object with a shape: it is the one that is meant. Its holes are there, filled, before the mouse has moved away.
assert gui.action_is_enabled("Fairing_FillAllHoles")
Gui.runCommand("Fairing_FillAllHoles")
gui.wait_for_verdict("Fills all 4 holes")
assert not gui.widget("promptLabel").isVisible()
assert column(0) == ["1", "2", "3", "4"] and column(1) == ["4"] * 4 and column(2) == ["quad"] * 4, column(2)
assert column(5) == ["good"] * 4 and all(column(3)) and all("°" in angle for angle in column(4))
assert document.Objects == [base] and not document.UndoNames, "the preview must not touch the document"
gui.picture("11_fill_all")

# A row lights its hole and reads its verdict; an edge picked in the view finds its row.
table().selectRow(1)
gui.wait_for(lambda: gui.verdict().startswith("2: Meets all 4 edges"), "the second hole's verdict")
gui.picture("12_hole_pointed_at")
loops = support.fairing_holes(base)
Gui.Selection.addSelection(document.Name, base.Name, loops[3][2])
gui.wait_for(lambda: {index.row() for index in table().selectedIndexes()} == {3}, "the fourth row")

# Without a tick a hole stays open.
tick(2, False)
gui.wait_for_verdict("Fills all 3 holes")
assert column(2) == ["quad", "quad", "", "quad"]
gui.widget("noneButton").click()
gui.wait_for(lambda: "tick one" in gui.verdict(), "the reason")
gui.press("Ok")
assert gui.panel_is_open() and document.Objects == [base]
gui.widget("allButton").click()
gui.wait_for_verdict("Fills all 4 holes")
tick(0, False)

# OK: one object, one step to undo.
gui.ok()
filled = document.FillAll
assert document.UndoNames == ["Fill all holes"] and filled.isValid() and len(filled.Shape.Faces) == 3
assert filled.Skipped == [min(loops[0], key=lambda name: int(name[4:]))] and filled.WithinTolerance
document.undo()
assert document.Objects == [base]
document.redo()
filled = document.FillAll

# Edit by a double-click: the choices are as they were; into the base, and the base is hidden.
assert filled.ViewObject.Proxy.doubleClicked(filled.ViewObject)
gui.wait_for_verdict("Fills all 3 holes")
assert table().item(0, 0).checkState() == QtCore.Qt.Unchecked and not filled.ViewObject.Visibility
tick(0, True)
gui.widget("resultCombo").setCurrentIndex(2)
gui.wait_for_verdict("Fills all 4 holes")
gui.ok()
assert filled.Skipped == [] and len(filled.Shape.Faces) == 25 and filled.Shape.isValid()
assert document.UndoNames[0] == "Edit FillAll" and filled.ViewObject.Visibility
gui.picture("13_filled_all")

# The outer border on request; a hole that fails is told in its row, and the others are filled all the same.
document.undo()
document.undo()
document.recompute()
Gui.Selection.clearSelection()
Gui.Selection.addSelection(document.Name, base.Name)
Gui.runCommand("Fairing_FillAllHoles")
gui.wait_for_verdict("Fills all 4 holes")
gui.widget("outerCheck").setChecked(True)
gui.settle()
assert len(column(0)) == 5
gui.picture("14_outer_border")
gui.press("Cancel")
assert not gui.panel_is_open() and document.Objects == [base]
assert not [thread for thread in threading.enumerate() if thread.name == "fairing"]
print("passed")
