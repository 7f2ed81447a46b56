# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels in German, whose words are longer: every text of theirs is German, and none is cut off."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
from PySide import QtGui

import gui
import seen
import support


def nothing_is_cut_off(name, *marks):
    """Of the open panel, looked at from top to bottom, which shows certain texts."""
    gui.picture(name)
    texts = seen.texts()
    assert not set(marks) - set(texts), (set(marks) - set(texts), texts)
    gui.scroll_to("innerCombo")
    gui.picture(name + "_below")
    assert not seen.cut_off(), seen.cut_off()


Gui.setLocale("German")
gui.start()

document, base, edges = support.example()
gui.look_at_all()
gui.select(document, (base, edges[0]))
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict()
gui.widget("layoutCombo").setCurrentText("Stern")
gui.widget("innerCombo").setCurrentText("Krümmung (G2)")
gui.wait_for_verdict()
nothing_is_cut_off("german_fill", "Aufteilung", "Zwischen Stücken", "Neu wählen")
assert not seen.cut_off_entries("energyCombo"), seen.cut_off_entries("energyCombo")
gui.press("Cancel")
Gui.Selection.clearSelection()
Gui.runCommand("Fairing_FillAllHoles")
gui.wait_for_verdict("Fills")
nothing_is_cut_off("german_fill_all", "Zwischen Stücken")
gui.press("Cancel")
App.closeDocument(document.Name)

document = App.newDocument("Planes")
low = gui.part(document, "Low", Part.makePlane(20, 10))
high = gui.part(document, "High", Part.makePlane(20, 10, App.Vector(0, 20, 8)))
document.recompute()
gui.look_at_all()
gui.select(document, (low, gui.edge_at(low.Shape, (10, 10, 0))), (high, gui.edge_at(high.Shape, (10, 20, 8))))
Gui.runCommand("Fairing_BlendFaces")
gui.wait_for_verdict()
gui.widget("moreButton").click()
gui.pump(0.2)
nothing_is_cut_off("german_blend", "Zwischen Stücken")
gui.press("Cancel")
print("passed")
