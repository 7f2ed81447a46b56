# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the patches of a fill meet each other, chosen in the panel: seen in the preview's numbers, kept by the object,
undone, written into macros, found again on editing."""

import FreeCADGui as Gui

import gui
import seen
import support

gui.start()
panels = gui.keep_panels()
document, base, edges = support.example()
gui.look_at_all()
gui.select(document, (base, edges[0]))
Gui.runCommand("Fairing_FillHole")
gui.wait_for_verdict("Meets all 4 edges")
gui.widget("layoutCombo").setCurrentText("Star")
gui.wait_for_verdict("Meets all 4 edges")
combo = gui.widget("innerCombo")
assert combo.isVisible() and combo.currentText() == "Tangent (G1)" and "times as long" in combo.toolTip()
tangent = seen.largest_jump(panels)
assert {seam["asked"] for seam in seen.report(panels)["seams"]} == {"G1"}

# In curvature: reflections run on across the seams, here measured.
combo.setCurrentText("Curvature (G2)")
gui.wait_for_verdict("Meets all 4 edges")
assert {seam["asked"] for seam in seen.report(panels)["seams"]} == {"G2"}
limit = seen.report(panels)["limits"]["curvature"]
assert seen.largest_jump(panels) <= limit < tangent, (seen.largest_jump(panels), tangent)
gui.scroll_to("innerCombo")
gui.picture("16_between_patches")
assert not seen.cut_off() + seen.cut_off_entries("energyCombo"), (seen.cut_off(), seen.cut_off_entries("energyCombo"))
gui.widget("pictureCombo").setCurrentText("Zebra")
gui.settle()
gui.picture("17_between_patches_zebra")
gui.widget("pictureCombo").setCurrentText("No picture")
gui.settle()
lines = seen.lines_run(gui.ok)
assert [line for line in lines if "make_fill" in line] == [
    f"fairing.make_fill(FreeCAD.ActiveDocument.getObject('Base'), ['{edges[0]}'], layout='star', inner_continuity='G2')"
], lines
fill = document.Fill
assert fill.InnerContinuity == "G2" and len(fill.Shape.Faces) == 4 and fill.isValid()
curved = fill.Shape.copy()

# On editing it is found again; back to tangent is a step of its own to undo.
Gui.ActiveDocument.setEdit("Fill")
gui.wait_for_verdict()
assert gui.widget("innerCombo").currentText() == "Curvature (G2)"
gui.widget("innerCombo").setCurrentText("Tangent (G1)")
gui.wait_for_verdict()
assert abs(seen.largest_jump(panels) - tangent) < 1e-9
lines = seen.lines_run(gui.ok)
assert "fairing.change_fill(FreeCAD.ActiveDocument.getObject('Fill'), inner_continuity='G1')" in lines, lines
assert fill.InnerContinuity == "G1" and fill.Shape.CenterOfMass != curved.CenterOfMass
document.undo()
document.recompute()
assert fill.InnerContinuity == "G2" and fill.Shape.CenterOfMass.isEqual(curved.CenterOfMass, 1e-9)
print("passed")
