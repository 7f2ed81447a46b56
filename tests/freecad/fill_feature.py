# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric object without a window: made, recomputed, moved, changed, failing, saved and reopened."""

import os
import sys

import FreeCAD as App
import Part

import fairing
import support


def makes_a_tangential_face_from_one_edge():
    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1])
    support.is_filled(fill, base, edges)
    assert sorted(fill.ReportEdges) == sorted(edges)
    assert len(fill.EdgeGaps) == len(fill.EdgeAngles) == len(fill.EdgeCornerAngles) == 4
    assert max(fill.EdgeAngles) == fill.LargestAngle.Value and max(fill.EdgeGaps) == fill.LargestGap.Value
    assert abs(fill.FilledArea.Value - fill.Shape.Area) < 1e-6 * fill.Shape.Area
    for name in ("Verdict", "LargestGap", "EdgeAngles"):
        assert "ReadOnly" in fill.getTypeOfProperty(name), name


def every_edge_of_the_hole_leads_to_the_same_face():
    document, base, edges = support.example()
    centres = [fairing.make_fill(base, [edge]).Shape.CenterOfMass for edge in edges]
    centres.append(fairing.make_fill(base, edges[::-1]).Shape.CenterOfMass)
    assert max(centre.distanceToPoint(centres[0]) for centre in centres) < 1e-9 * support.hole_diagonal(base, edges)


def replaces_a_picked_face():
    document = App.newDocument("Replace")
    base = document.addObject("Part::Feature", "Base")
    sides = [support.make_example.sheet() for _ in range(3)]
    for column, piece in enumerate(sides):
        piece.segment(column / 3, (column + 1) / 3, 0.0, 1.0)
    left, middle, right = (piece.toShape() for piece in sides)
    shell = Part.makeShell([left, middle, right])
    shell.sewShape()
    base.Shape = shell
    names = [f"Face{number}" for number, face in enumerate(base.Shape.Faces, 1)
             if abs(face.CenterOfMass.x) < 20.0]
    fill = fairing.make_fill(base, names)
    assert fill.isValid() and fill.Shape.isValid(), fill.State
    kept = [face for number, face in enumerate(base.Shape.Faces, 1) if f"Face{number}" not in names]
    assert len(fill.ReportEdges) == 4 and len(kept) == 2
    assert fill.LargestAngle.Value <= support.ANGLE_TOLERANCE and fill.WithinTolerance, fill.Verdict


def follows_its_base():
    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1])
    centre = fill.Shape.CenterOfMass
    base.Placement = App.Placement(App.Vector(5, 70, -20), App.Rotation(App.Vector(3, 1, 2), 75))
    document.recompute()
    support.is_filled(fill, base, edges)
    assert fill.Shape.CenterOfMass.distanceToPoint(base.Placement.multVec(centre)) < 1e-6
    scaled = Part.Shape(base.Shape)
    scaled.Placement = App.Placement()
    scaled.scale(2.0)
    base.Shape = scaled
    document.recompute()
    support.is_filled(fill, base, edges)


def lives_beside_its_base_in_a_part():
    document, base, edges = support.example()
    part = document.addObject("App::Part", "Part")
    part.addObject(base)
    part.Placement = App.Placement(App.Vector(100, 0, 50), App.Rotation(App.Vector(0, 1, 0), 30))
    base.Placement = App.Placement(App.Vector(0, 10, 0), App.Rotation(App.Vector(0, 0, 1), 20))
    document.recompute()
    fill = fairing.make_fill(base, edges[:1])
    assert fill.getParentGeoFeatureGroup() is part
    support.is_filled(fill, base, edges)  # both in the Part's coordinates
    shown = Part.getShape(part, "Fill.", retType=0, transform=True)
    beside = Part.getShape(part, "Base.", retType=0, transform=True)
    assert shown.distToShape(beside)[0] < 1e-6


def reaches_into_another_part():
    document, base, edges = support.example()
    part = document.addObject("App::Part", "Part")
    part.addObject(base)
    part.Placement = App.Placement(App.Vector(100, 0, 50), App.Rotation(App.Vector(0, 1, 0), 30))
    fill = fairing.make_fill(base, edges[:1])
    part.removeObject(fill)
    fill.touch()
    document.recompute()
    assert fill.isValid(), fill.State
    seen = base.Shape.copy()
    seen.Placement = part.Placement.multiply(base.Placement)
    assert fill.Shape.distToShape(seen)[0] < 1e-6
    assert fill.Shape.CenterOfMass.distanceToPoint(seen.CenterOfMass) < support.hole_diagonal(base, edges)


def works_through_a_link():
    document, base, edges = support.example()
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = base
    link.Placement = App.Placement(App.Vector(0, 0, 200), App.Rotation())
    document.recompute()
    fill = fairing.make_fill(link, edges[:1])
    assert fill.isValid() and fill.Shape.CenterOfMass.z > 200.0


def failing_keeps_the_last_good_shape_and_says_why():
    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1])
    area, largest = fill.Shape.Area, fill.LargestAngle
    fill.Edges = (base, ["Edge99"])
    document.recompute()
    assert not fill.isValid()
    assert "edge 99" in fill.Verdict and not fill.WithinTolerance, fill.Verdict
    assert fill.Verdict in fill.getStatusString(), "the tree's tooltip says something else"
    assert fill.Shape.Area == area and fill.LargestAngle == largest
    for name, value, word in (("AngleTolerance", 0.0, "angle"), ("Lambda", -1.0, "lambda"),
                              ("Gamma", float("nan"), "gamma"), ("Degree", 99, "degree"),
                              ("EdgeContinuity", ["nonsense"], "nonsense"),
                              ("EdgeContinuity", [f"{edges[1]}=G9"], "G9")):
        good = getattr(fill, name)
        fill.Edges = (base, edges[:1])
        setattr(fill, name, value)
        document.recompute()
        assert not fill.isValid() and word in fill.Verdict and "\n" not in fill.Verdict, (name, fill.Verdict)
        assert fill.Shape.Area == area
        setattr(fill, name, good)
    fill.Edges = None
    document.recompute()
    assert not fill.isValid() and "No edge is picked" in fill.Verdict
    fill.Edges = (base, edges[:1])
    document.recompute()
    support.is_filled(fill, base, edges)


def bad_input_leaves_the_document_as_it_was():
    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1])
    before = [(obj.Name, obj.State) for obj in document.Objects]
    for picks, options in (([], {}), (["Edge99"], {}), ([edges[0], "Edge1"], {}), (["Vertex1"], {}),
                           (edges, {"gap_tolerance": 0.0}), (edges, {"gap_tolerance": float("nan")}),
                           (edges, {"angle_tolerance": -1.0}), (edges, {"lambda_": -1.0}), (edges, {"energy": "soap"}),
                           (edges, {"edge_continuity": {"Edge1": "G0"}})):
        assert support.refused(lambda: fairing.make_fill(base, picks, **options))
        assert support.refused(lambda: fairing.change_fill(fill, picks, **options))
        assert [(obj.Name, obj.State) for obj in document.Objects] == before
    empty = document.addObject("Part::Feature", "Empty")
    assert "no shape" in support.refused(lambda: fairing.make_fill(empty, ["Edge1"]))
    document.removeObject("Empty")
    support.is_filled(fill, base, edges)


def choices_change_the_surface_and_are_kept():
    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1])
    plate = fill.Shape.copy()
    fairing.change_fill(fill, energy="membrane")
    assert fill.Energy == "membrane" and fill.isValid()
    assert fill.Shape.Area < plate.Area, "a membrane is the smaller surface"
    fairing.change_fill(fill, energy="thin-plate", edge_continuity={edges[2]: "G0"})
    assert fill.EdgeContinuity == [f"{edges[2]}=G0"]
    sides = dict(zip(fill.ReportEdges, fill.EdgeAngles))
    assert sides[edges[2]] > 1.0 and max(angle for edge, angle in sides.items() if edge != edges[2]) <= 0.02
    fairing.change_fill(fill, edge_continuity={}, degree=5)
    assert fill.Shape.Faces[0].Surface.UDegree == 5
    support.is_filled(fill, base, edges)
    fairing.change_fill(fill, layout="star", inner_continuity="G2")
    assert fill.InnerContinuity == "G2" and len(fill.Shape.Faces) == 4
    curved = fill.Shape.copy()
    fairing.change_fill(fill, inner_continuity="G1")
    assert fill.InnerContinuity == "G1" and fill.Shape.CenterOfMass != curved.CenterOfMass


def a_reference_pulls_the_surface():
    document, base, edges = support.example()
    free = fairing.make_fill(base, edges[:1])
    raised = document.addObject("Part::Feature", "Raised")
    raised.Shape = free.Shape.translated(App.Vector(0, 0, 6))
    pulled = fairing.make_fill(base, edges[:1], reference=raised, gamma=1e5)
    assert pulled.Reference[0][0] is raised
    height = pulled.Shape.CenterOfMass.z - free.Shape.CenterOfMass.z
    assert 0.5 < height < 6.0, height
    support.is_filled(pulled, base, edges)


def result_modes_hold_what_they_say():
    document, base, edges = support.example()
    shell = fairing.make_fill(base, edges[:1], result="shell")
    assert shell.Shape.ShapeType == "Shell" and shell.Shape.isValid()
    whole = fairing.make_fill(base, edges[:1], result="base")
    assert whole.Shape.isValid() and len(whole.Shape.Faces) == len(base.Shape.Faces) + 1
    free = [edge for edge in whole.Shape.Edges if len(whole.Shape.ancestorsOfType(edge, Part.Face)) == 1]
    assert len(free) == 12, "only the rim of the sheet is open"


def survives_save_and_reopen():
    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1], edge_continuity={edges[1]: "G0"}, degree=4, inner_continuity="G2")
    area = fill.Shape.Area
    path = support.saved(document)
    App.closeDocument(document.Name)
    document = App.openDocument(path)
    fill = document.Fill
    assert type(fill.Proxy).__name__ == "FillFeature" and abs(fill.Shape.Area - area) < 1e-12 * area
    assert fill.EdgeContinuity == [f"{edges[1]}=G0"] and fill.Degree == 4 and fill.FairingType == "Fill"
    assert fill.InnerContinuity == "G2"
    fill.touch()
    document.recompute()
    assert fill.isValid() and abs(fill.Shape.Area - area) < 1e-9 * area


def objects_of_an_older_version_are_brought_up_to_date():
    from fairing import migrate

    document, base, edges = support.example()
    fill = fairing.make_fill(base, edges[:1])
    fill.removeProperty("EdgeCurvatures")  # as if made before that was measured
    fill.FairingVersion = migrate.CURRENT - 1
    migrate.UPDATES[migrate.CURRENT - 1] = lambda obj: setattr(obj, "Label", "Updated")
    fill.Proxy.onDocumentRestored(fill)
    assert fill.FairingVersion == migrate.CURRENT and fill.Label == "Updated"
    fill.touch()
    document.recompute()
    assert len(fill.EdgeCurvatures) == 4


def the_example_on_disk_is_the_one_its_script_makes():
    document = App.openDocument(os.path.join(support.ROOT, "examples", "four_sided_hole", "four_sided_hole.FCStd"))
    made = support.make_example.sheet_with_hole()
    assert abs(document.Base.Shape.Area - made.Area) < 1e-9 * made.Area
    assert support.make_example.hole_edges(document.Base.Shape) == support.make_example.hole_edges(made)


def needs_no_window():
    assert not App.GuiUp and not {"FreeCADGui", "PySide", "PySide2", "pivy"} & set(sys.modules)


support.run_all(globals())
