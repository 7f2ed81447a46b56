# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edited face without a window: made, guided, changed, put into its base, failing, saved and reopened."""

import math

import FreeCAD as App
import Part

import fairing
import support

SIDE = 40.0
WISH = App.Vector(0.5, 0.0, 1.0)


def wavy(name="Base"):
    """A document with one bicubic face."""
    document = App.newDocument("Edit")
    surface = Part.BSplineSurface()
    shares = [k / 8 for k in range(9)]
    surface.interpolate([[App.Vector(SIDE * s, SIDE * t, 2.0 * math.sin(3.0 * s) * math.cos(2.0 * t)) for t in shares]
                         for s in shares])
    base = document.addObject("Part::Feature", name)
    base.Shape = surface.toShape()
    document.recompute()
    return document, base


def handle(**more):
    return {"point": (20, 20, 0), "normal": tuple(WISH), "radius": 15, **more}


def lean(obj):
    """Degrees between the normal in the middle and the wish."""
    face = obj.Shape.Faces[0]
    angle = math.degrees(face.Surface.normal(*face.Surface.parameter(App.Vector(20, 20, 0))).getAngle(WISH))
    return min(angle, 180.0 - angle)


def a_handle_turns_the_face_and_the_border_stays():
    document, base = wavy()
    edit = fairing.make_edit(base, "Face1", guides=[handle()], lambda_=100)
    assert edit.isValid() and edit.Shape.isValid() and edit.Shape.ShapeType == "Face"
    assert lean(edit) < 0.8 * lean(base), (lean(edit), lean(base))
    for edge in base.Shape.Edges:
        for point in edge.discretize(support.SAMPLES):
            assert edit.Shape.Faces[0].Surface.value(*edit.Shape.Faces[0].Surface.parameter(point)).isEqual(point, 1e-9)
    assert edit.BorderMove.Value <= 1e-10 and edit.BorderTurn.Value <= 1e-4 and edit.LargestMove.Value > 0.1
    assert edit.EnergyAfter < edit.EnergyBefore and 0 < edit.MovedPoles < edit.Poles
    assert 0.0 < edit.GuideRmsAngle.Value <= edit.GuideLargestAngle.Value
    assert edit.Face == (base, ["Face1"]) and edit.Guides[0].FairingType == "NormalHandle"


def choices_change_and_the_rest_stays():
    document, base = wavy()
    edit = fairing.make_edit(base, 1, guides=[handle()], lambda_=100)
    poles = edit.Poles
    fairing.change_edit(edit, degree=5, spans=10, keep="G2")
    assert edit.Poles > poles and edit.Keep == "G2" and edit.Degree == 5 and edit.Lambda == 100
    assert edit.Shape.Faces[0].Surface.UDegree == 5
    fairing.change_edit(edit, energy="membrane", keep=None)
    assert edit.Energy == "membrane" and edit.Keep == "auto" and edit.BorderMove.Value <= 1e-10
    steep = lean(edit)
    edit.Lambda = 1e4
    document.recompute()
    assert lean(edit) < steep


def the_base_takes_the_new_face_in_place_of_the_old_one():
    document = App.newDocument("Solid")
    base = document.addObject("Part::Box", "Box")
    base.Length = base.Width = base.Height = SIDE
    document.recompute()
    top = support.face_where(base, lambda face: face.CenterOfMass.z > SIDE - 1)
    edit = fairing.make_edit(base, top, guides=[{"point": (20, 20, SIDE), "normal": tuple(WISH), "radius": 15}],
                             lambda_=100, degree=5, spans=6, result="base")
    assert edit.Shape.ShapeType == "Solid" and edit.Shape.isValid() and len(edit.Shape.Faces) == 6
    assert support.free_edges(edit.Shape) == [] and edit.Shape.Volume > 0
    assert edit.LargestMove.Value > 0.1 and len(edit.Shape.Edges) == 12
    fairing.change_edit(edit, result="shell")
    assert edit.Shape.ShapeType == "Shell" and len(edit.Shape.Faces) == 1
    base.Height = 2 * SIDE
    document.recompute()
    # the handle stayed where it was, its foot is the nearest point
    assert edit.isValid() and abs(edit.Shape.BoundBox.Center.z - 2 * SIDE) < SIDE / 4


def a_converted_face_says_how_closely():
    document = App.newDocument("Cylinder")
    base = document.addObject("Part::Cylinder", "Cylinder")
    document.recompute()
    side = support.face_where(base, lambda face: face.Surface.TypeId.endswith("Cylinder"))
    edit = fairing.make_edit(base, side)
    assert edit.isValid() and len(edit.Notes) == 1 and "converted" in edit.Notes[0], edit.Notes


def a_reference_attracts():
    document, base = wavy()
    raised = document.addObject("Part::Feature", "Raised")
    raised.Shape = base.Shape.translated(App.Vector(0, 0, 3))
    edit = fairing.make_edit(base, 1, reference=raised, gamma=1e4, spans=12)
    assert 1.0 < edit.Shape.CenterOfMass.z - base.Shape.CenterOfMass.z < 3.0
    assert edit.GuideRmsDistance.Value < 3.0 and edit.Reference[0][0] is raised
    fairing.change_edit(edit, reference=None, gamma=0.0)
    assert edit.Reference == [] and edit.isValid()


def bad_input_is_told():
    document, base = wavy()
    assert "There is no face 7" in support.refused(lambda: fairing.make_edit(base, "Face7"))
    assert "not a face" in support.refused(lambda: fairing.make_edit(base, "Edge1"))
    assert "spans" in support.refused(lambda: fairing.make_edit(base, 1, spans=99))
    assert "guides nothing" in support.refused(
        lambda: fairing.make_edit(base, 1, guides=[handle(point=(900, 0, 0))], lambda_=1))
    assert document.Objects == [base]


def survives_save_and_reopen():
    document, base = wavy()
    area = fairing.make_edit(base, 1, guides=[handle()], lambda_=100).Shape.Area
    path = support.saved(document)
    App.closeDocument(document.Name)
    document = App.openDocument(path)
    edit = document.Edit
    assert type(edit.Proxy).__name__ == "EditFeature" and abs(edit.Shape.Area - area) < 1e-12 * area
    document.Base.Placement = App.Placement(App.Vector(0, 0, 1), App.Rotation())
    document.recompute()
    assert edit.isValid() and edit.Shape.CenterOfMass.z > 0.5


support.run_all(globals())
