# SPDX-License-Identifier: LGPL-2.1-or-later
"""A fill meets a FreeCAD without Fairing and comes back: one step a process, chosen by the first argument.

make    with the add-on: makes and saves a fill
keep    without it: the shape is there and stays, also through a save
revive  with it again, in the window: the fill computes and draws once more
"""

import os
import sys

import FreeCAD as App

import support

STEP, PATH = sys.argv[1:3]


def make():
    import fairing

    document, base, edges = support.example()
    handle = {"point": tuple(base.Shape.BoundBox.Center), "normal": (0, 0, 1), "radius": 200}
    fill = fairing.make_fill(base, edges[:1], edge_continuity={edges[1]: "G0"}, guides=[handle], lambda_=0.1)
    assert fill.isValid()
    document.saveAs(PATH)


def keep():
    assert "fairing" not in sys.modules
    document = App.openDocument(PATH)
    fill = document.Fill
    area = fill.Shape.Area
    assert fill.Shape.isValid() and len(fill.Shape.Faces) == 1 and area > 1.0
    assert fill.LargestGap.Value < 1e-3 and fill.Verdict.startswith("Meets")
    document.Base.Placement.Base.z = 25.0
    document.recompute()
    assert fill.Shape.Area == area
    document.save()


def revive():
    document = App.openDocument(PATH)
    fill, base = document.Fill, document.Base
    assert type(fill.Proxy).__name__ == "FillFeature", "the proxy stays dead"
    assert type(fill.ViewObject.Proxy).__name__ == "FillView"
    handle, = fill.Guides
    assert type(handle.Proxy).__name__ == "NormalHandleFeature"
    assert type(handle.ViewObject.Proxy).__name__ == "NormalHandleView"
    document.recompute()
    edges = support.make_example.hole_edges(base.Shape)
    assert fill.State == ["Up-to-date"] and fill.EdgeContinuity
    assert support.largest_gap(fill.Shape, base, edges) < 1e-6 * support.hole_diagonal(base, edges)
    assert fill.ViewObject.Proxy.getIcon().endswith("Fairing_FillHole.svg") and os.path.exists(
        fill.ViewObject.Proxy.getIcon())
    # The command does the same for a document the observer has missed.
    fill.Proxy = fill.ViewObject.Proxy = 0
    import FreeCADGui as Gui

    Gui.activateWorkbench("FairingWorkbench")
    Gui.runCommand("Fairing_Reconnect")
    assert type(fill.Proxy).__name__ == "FillFeature" and type(fill.ViewObject.Proxy).__name__ == "FillView"


{"make": make, "keep": keep, "revive": revive}[STEP]()
print("passed")
