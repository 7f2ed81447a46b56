# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts/demo does inside FreeCAD: opens the example, picks one edge of its hole, fills it as a user would, prints
the report and leaves filled.FCStd, filled.step and two pictures in $FAIRING_OUTPUT."""

import os
import sys

import FreeCAD as App
import FreeCADGui as Gui
import Part

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
OUTPUT = os.environ["FAIRING_OUTPUT"]
EXAMPLE = os.path.join(ROOT, "examples", "four_sided_hole")
sys.path[:0] = [EXAMPLE, os.path.join(ROOT, "tests", "freecad")]

import gui  # noqa: E402
from make_example import hole_edges  # noqa: E402


def main():
    gui.start()
    document = App.openDocument(os.path.join(EXAMPLE, "four_sided_hole.FCStd"))
    set_the_scene()
    edge = hole_edges(document.Base.Shape)[0]
    print(f"Opened {document.Name}, picked {edge} of '{document.Base.Label}'.")
    fill = fill_hole(document, edge)
    print_report(fill)
    document.saveAs(os.path.join(OUTPUT, "filled.FCStd"))
    Part.export([document.Base, fill], os.path.join(OUTPUT, "filled.step"))


def set_the_scene():
    """A light background and a view along which the bump and its surroundings show."""
    parameters = App.ParamGet("User parameter:BaseApp/Preferences/View")
    for name, color in (("BackgroundColor2", 0xF4F6F9FF), ("BackgroundColor3", 0xB9C4D2FF)):
        parameters.SetUnsigned(name, color)
    view = gui.look_at_all()
    view.setCameraOrientation(App.Rotation(App.Vector(0, 0, 1), 28).multiply(
        App.Rotation(App.Vector(1, 0, 0), 42)))
    view.setCameraType("Perspective")
    for obj in App.ActiveDocument.Objects:
        obj.ViewObject.ShapeColor = (0.62, 0.69, 0.77)
        obj.ViewObject.LineWidth = 1.5
    Gui.SendMsgToActiveView("ViewFit")
    App.Console.PrintMessage("Fairing's example\n")  # instead of the last start-up message in the status bar
    gui.pump(0.3)


def fill_hole(document, edge):
    """By the command and its panel."""
    Gui.Selection.addSelection(document.Name, "Base", edge)
    Gui.runCommand("Fairing_FillHole")
    gui.wait_for_verdict()
    Gui.SendMsgToActiveView("ViewFit")
    gui.picture("panel")
    gui.press("Ok")
    fill = document.Fill
    fill.ViewObject.LineWidth = 1.5
    gui.picture("filled")
    return fill


def print_report(fill):
    print(f"{'edge':8} {'gap (mm)':>12} {'angle (deg)':>12} {'at corners':>12} {'curvature':>10}")
    for edge, *numbers in zip(fill.ReportEdges, fill.EdgeGaps, fill.EdgeAngles, fill.EdgeCornerAngles,
                              fill.EdgeCurvatures):
        gap, angle, corner, curvature = numbers
        print(f"{edge:8} {gap:12.2e} {angle:12.5f} {corner:12.5f} {curvature:10.1%}")
    print(f"{fill.Verdict} {fill.Poles} control points, {fill.FilledArea.UserString}.")


main()
