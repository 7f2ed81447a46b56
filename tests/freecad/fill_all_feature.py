# SPDX-License-Identifier: LGPL-2.1-or-later
"""The object that fills all holes without a window, what a fill passes through, and bodies."""

import math
import sys

import FreeCAD as App
import Part

import fairing
import support


def fills_every_hole_of_its_base():
    document, base = support.four_holes()
    filled = fairing.make_fill_all(base)
    assert filled.State == ["Up-to-date"] and filled.Shape.isValid() and len(filled.Shape.Faces) == 4
    assert filled.WithinTolerance and filled.Verdict == "Fills all 4 holes within tolerance."
    assert len(filled.HoleEdges) == len(filled.HoleVerdicts) == len(filled.HoleGaps) == 4
    assert set(filled.HoleLayouts) == {"quad"} and max(filled.HoleAngles) <= support.ANGLE_TOLERANCE
    for face, loop in zip(filled.Shape.Faces, fairing.holes(base.Shape)):
        assert support.largest_gap(face, base, loop) < 1e-6 * support.hole_diagonal(base, loop)
    assert abs(filled.FilledArea.Value - filled.Shape.Area) < 1e-6 * filled.Shape.Area


def sews_them_into_the_base():
    document, base = support.four_holes()
    filled = fairing.make_fill_all(base, result="base")
    assert filled.Shape.isValid() and len(filled.Shape.Faces) == 25
    assert len(support.free_edges(filled.Shape)) == 20, "only the rim of the sheet is open"


def is_the_same_as_filling_one_hole_at_a_time():
    document, base = support.four_holes()
    together = fairing.make_fill_all(base)
    for face, loop in zip(together.Shape.Faces, fairing.holes(base.Shape)):
        alone = fairing.make_fill(base, loop[:1])
        assert face.CenterOfMass.distanceToPoint(alone.Shape.CenterOfMass) == 0.0


def leaves_out_what_is_skipped():
    document, base = support.four_holes()
    loops = fairing.holes(base.Shape)
    filled = fairing.make_fill_all(base, skipped=[loops[2][1]])
    assert len(filled.Shape.Faces) == 3 and filled.Skipped == [loops[2][1]]
    assert loops[2][0] not in filled.HoleEdges
    fairing.change_fill_all(filled, skipped=[], continuity="G0")
    assert len(filled.Shape.Faces) == 4 and filled.Continuity == "G0" and filled.Skipped == []
    filled.Skipped = ["nonsense"]
    document.recompute()
    assert not filled.isValid() and "nonsense" in filled.Verdict
    assert len(filled.Shape.Faces) == 4, "the last good shape stays"


def one_failing_hole_leaves_the_others_alone():
    document, base = support.four_holes()
    edge = fairing.holes(base.Shape)[1][0]
    shape, reports = fairing.fill_all(base.Shape)
    along = base.Shape.getElement(edge)
    middle = tuple(along.tangentAt(sum(along.ParameterRange) / 2))
    filled = fairing.make_fill_all(base, tangents={edge: middle})
    assert len(filled.Shape.Faces) == 3 and not filled.WithinTolerance
    assert filled.Verdict == "3 of 4 holes are filled within tolerance, 1 not at all."
    assert sum("runs along the edge" in verdict for verdict in filled.HoleVerdicts) == 1
    assert filled.HoleGaps.count(-1.0) == 1 and len(reports) == 4


def follows_its_base_and_survives_save_and_reopen():
    document, base = support.four_holes()
    filled = fairing.make_fill_all(base, energy="membrane")
    area = filled.Shape.Area
    path = support.saved(document)
    App.closeDocument(document.Name)
    document = App.openDocument(path)
    filled, base = document.FillAll, document.Base
    assert type(filled.Proxy).__name__ == "FillAllFeature" and filled.FairingType == "FillAll"
    centre = filled.Shape.Faces[0].CenterOfMass
    base.Placement = App.Placement(App.Vector(5, 70, -20), App.Rotation(App.Vector(3, 1, 2), 75))
    document.recompute()
    assert filled.isValid() and abs(filled.Shape.Area - area) < 1e-7 * area
    assert filled.Shape.Faces[0].CenterOfMass.distanceToPoint(base.Placement.multVec(centre)) < 1e-5


def says_why_nothing_can_be_filled():
    document = App.newDocument("Closed")
    base = document.addObject("Part::Feature", "Base")
    base.Shape = Part.makeBox(1, 2, 3)
    before = len(document.Objects)
    error = support.refused(lambda: fairing.make_fill_all(base))
    assert "no hole" in error, error
    assert len(document.Objects) == before


def old_objects_learn_the_new_choices():
    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1], energy="membrane")
    for name in ("Layout", "Through", "EdgeDirections", "Notes", "LargestCurvature"):
        fill.removeProperty(name)
    for name, words in (("Energy", ["thin-plate", "membrane"]), ("Continuity", ["G0", "G1"])):
        kept = getattr(fill, name)
        setattr(fill, name, words)
        setattr(fill, name, kept)
    path = support.saved(document)
    App.closeDocument(document.Name)
    fill = App.openDocument(path).Fill
    assert (fill.Energy, fill.Continuity, fill.Layout) == ("membrane", "G1", "auto")
    assert "mean-curvature-gradient" in fill.getEnumerationsOfProperty("Energy")
    assert fill.getEnumerationsOfProperty("Continuity") == ["G0", "G1", "G2"]
    fill.touch()
    fill.Document.recompute()
    assert fill.isValid() and fill.LayoutUsed == "quad" and fill.Energy == "membrane"


def a_direction_takes_the_place_of_a_face():
    document = App.newDocument("Arch")
    base = document.addObject("Part::Feature", "Base")
    arcs = [Part.Arc(App.Vector(0, y, 0), App.Vector(20, y, 5), App.Vector(40, y, 0)).toShape() for y in (0, 20)]
    lines = [Part.makeLine((x, 0, 0), (x, 20, 0)) for x in (0, 40)]
    base.Shape = Part.makeCompound(arcs + lines)
    fill = fairing.make_fill(base, ["Edge1", "Edge2", "Edge3", "Edge4"],
                             symmetry={"Edge1": (0, 1, 0), "Edge2": App.Vector(0, 1, 0)})
    assert fill.EdgeDirections == ["Edge1=symmetry 0.0 1.0 0.0", "Edge2=symmetry 0.0 1.0 0.0"]
    assert fill.isValid() and fill.WithinTolerance, fill.Verdict
    face = fill.Shape.Faces[0]
    point = App.Vector(15, 0, math.sqrt(42.5 ** 2 - 25) - 37.5)
    assert abs(face.normalAt(*face.Surface.parameter(point)).y) < 1e-3
    fill.EdgeDirections = ["Edge1=upwards"]
    document.recompute()
    assert not fill.isValid() and "Edge1=upwards" in fill.Verdict


def replaces_a_face_of_a_body_as_a_solid_of_its_own():
    document = App.newDocument("Body")
    body = document.addObject("PartDesign::Body", "Body")
    box = document.addObject("PartDesign::AdditiveBox", "Box")
    body.addObject(box)
    document.recompute()
    body.Placement = App.Placement(App.Vector(0, 0, 30), App.Rotation(App.Vector(1, 0, 0), 30))
    document.recompute()
    for base in (box, body):
        fill = fairing.make_fill(base, ["Face6"], continuity="G0", result="base")
        assert fill.getParentGeoFeatureGroup() is None, "a body takes no strangers"
        assert fill.Shape.ShapeType == "Solid" and fill.Shape.isValid() and fill.Shape.Volume > 0
        assert abs(fill.Shape.Volume - 1000) < 1e-6
        assert fill.Shape.CenterOfMass.distanceToPoint(body.Placement.multVec(App.Vector(5, 5, 5))) < 1e-6


def needs_no_window():
    assert not App.GuiUp and not {"FreeCADGui", "PySide", "PySide2", "pivy"} & set(sys.modules)


support.run_all(globals())
