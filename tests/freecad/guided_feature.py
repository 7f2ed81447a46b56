# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guides as document objects without a window: made by scripts, changed, shared, undone, saved and reopened."""

import math

import FreeCAD as App
import Mesh
import Part

import fairing
import support

RADIUS = 20.0  # mm, of the handles here
LAMBDA = 1e4


def guided(**options):
    """The example filled, with a handle in its middle that leans to +x."""
    document, base, edges = support.example()
    free = fairing.make_fill(base, edges[:1], energy="thin-plate")
    middle = middle_of(free)
    handle = {"point": tuple(middle), "normal": (0.5, 0.0, 1.0), "radius": RADIUS}
    fill = fairing.make_fill(base, edges[:1], energy="thin-plate", guides=[handle], lambda_=LAMBDA, **options)
    return document, fill, middle


def middle_of(fill):
    surface = fill.Shape.Faces[0].Surface
    u0, u1, v0, v1 = surface.bounds()
    return surface.value((u0 + u1) / 2, (v0 + v1) / 2)


def normal_at(fill, point):
    """The face's normal at its point nearest to a point, upwards."""
    face = fill.Shape.Faces[0]
    normal = face.Surface.normal(*face.Surface.parameter(point))
    return normal if normal.z > 0 else -normal


def lean(fill, point, wish):
    """Degrees between the normal near a point and a wish."""
    return math.degrees(normal_at(fill, point).getAngle(App.Vector(*wish)))


def a_handle_turns_the_surface_and_lives_below_it():
    document, fill, middle = guided()
    handle, = fill.Guides
    assert handle.FairingType == "NormalHandle" and handle.Name == "NormalHandle"
    assert handle.Radius.Value == RADIUS and handle.Weight == 1.0
    before, after = lean(document.Fill, middle, handle.Normal), lean(fill, middle, handle.Normal)
    assert after < 0.3 * before, (before, after)
    assert 0.0 < fill.GuideRmsAngle.Value <= fill.GuideLargestAngle.Value
    assert document.Fill.GuideLargestAngle.Value == 0.0 and document.Fill.Guides == []
    assert fill.WithinTolerance, fill.Verdict


def a_changed_handle_changes_the_surface():
    document, fill, middle = guided()
    handle, = fill.Guides
    handle.Normal = App.Vector(0, 0.5, 1)
    document.recompute()
    assert lean(fill, middle, (0, 0.5, 1)) < lean(fill, middle, (0.5, 0, 1))
    handle.Weight = 0.0
    document.recompute()
    assert abs(lean(fill, middle, (0, 0.5, 1)) - lean(document.Fill, middle, (0, 0.5, 1))) < 1e-3


def a_zero_normal_is_told_and_the_shape_stays():
    document, fill, middle = guided()
    area = fill.Shape.Area
    fill.Guides[0].Normal = App.Vector()
    document.recompute()
    assert not fill.isValid() and "normal is zero" in fill.Verdict, fill.Verdict
    assert fill.Shape.Area == area
    fill.Guides[0].Normal = App.Vector(0, 0, 1)
    document.recompute()
    assert fill.isValid()


def a_handle_off_the_patch_is_told():
    document, fill, middle = guided()
    fill.Guides[0].Position = middle + App.Vector(500, 0, 0)
    document.recompute()
    assert not fill.isValid() and "guides nothing" in fill.Verdict, fill.Verdict


def a_normal_is_taken_from_a_face_an_edge_and_a_datum():
    document, fill, middle = guided()
    box = document.addObject("Part::Box", "Box")
    box.Placement = App.Placement(App.Vector(0, 0, 100), App.Rotation(App.Vector(0, 1, 0), 20))
    document.recompute()
    handle, = fill.Guides
    top = support.face_where(box, lambda face: face.normalAt(0, 0).z > 0.9)
    wish = box.Placement.Rotation.multVec(App.Vector(0, 0, 1))
    handle.Direction = (box, [top])
    document.recompute()
    assert handle.Normal.getAngle(wish) < 1e-9
    upright = next(f"Edge{k}" for k, edge in enumerate(box.Shape.Edges, 1)
                   if abs(edge.tangentAt(0).dot(wish)) > 0.999)
    handle.Direction = (box, [upright])
    document.recompute()
    assert min(handle.Normal.getAngle(wish), math.pi - handle.Normal.getAngle(wish)) < 1e-9
    handle.Direction = (box, [""])
    box.Placement = App.Placement(App.Vector(0, 0, 100), App.Rotation(App.Vector(0, 1, 0), 40))
    document.recompute()  # the handle follows, and the surface with it
    wish = box.Placement.Rotation.multVec(App.Vector(0, 0, 1))
    assert handle.Normal.getAngle(wish) < 1e-9
    assert lean(fill, middle, wish) < lean(document.Fill, middle, wish)
    handle.Direction = (box, ["Vertex1"])
    document.recompute()
    assert not handle.isValid()


def scripts_change_add_and_take_away_guides():
    document, fill, middle = guided()
    name = fill.Guides[0].Name
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    fairing.change_fill(fill, guides=[
        {"name": name, "point": tuple(middle), "normal": (0, 0, 2), "radius": 10, "weight": 3},
        {"point": tuple(middle + App.Vector(5, 5, 0)), "direction": (box, "Face6"), "radius": 5}])
    first, second = fill.Guides
    assert first.Name == name and first.Weight == 3.0 and first.Radius.Value == 10.0 and first.Normal.z == 2.0
    assert second.Direction == (box, ["Face6"]) and second.Normal.getAngle(App.Vector(0, 0, 1)) < 1e-9
    fairing.change_fill(fill, lambda_=1.0)
    assert fill.Guides == [first, second] and fill.Lambda == 1.0
    fairing.change_fill(fill, guides=[])
    assert fill.Guides == [] and document.getObject(name) is None
    assert len(document.findObjects("App::FeaturePython")) == 0


def wrong_guides_are_told_and_change_nothing():
    document, fill, middle = guided()
    area, at = fill.Shape.Area, tuple(middle)
    for guide, why in (({"point": at, "normal": (0, 0, 1)}, "radius"),
                       ({"normal": (0, 0, 1), "radius": 1}, '"point"'),
                       ({"point": at, "normal": (0, 0, 1), "radius": 1, "wait": 2}, "'wait'"),
                       ({"point": at, "normal": (0, 0, 0), "radius": 1}, "normal is zero"),
                       ({"point": at, "normal": (0, 0), "radius": 1}, "three numbers"),
                       ({"point": at, "direction": (document.Base, "Face99"), "radius": 1}, "There is no Face99")):
        sentence = support.refused(lambda: fairing.change_fill(fill, guides=[guide]))
        assert why in sentence, sentence
    assert fill.Shape.Area == area and len(fill.Guides) == 1 and fill.isValid()


def one_step_to_undo():
    document, fill, middle = guided()
    document.UndoMode = 1
    document.openTransaction("Guides")
    fairing.change_fill(fill, guides=[{"point": tuple(middle), "normal": (0, 1, 2), "radius": RADIUS}] * 2)
    document.commitTransaction()
    assert len(fill.Guides) == 2
    document.undo()
    document.recompute()
    assert [handle.Name for handle in fill.Guides] == ["NormalHandle"] and fill.Guides[0].Normal.x == 0.5
    assert len(document.findObjects("App::FeaturePython")) == 1
    document.redo()
    document.recompute()
    assert len(fill.Guides) == 2 and fill.isValid()


def survives_save_and_reopen():
    document, fill, middle = guided()
    area = fill.Shape.Area
    path, name = support.saved(document), fill.Name
    App.closeDocument(document.Name)
    document = App.openDocument(path)
    fill = document.getObject(name)
    handle, = fill.Guides
    assert type(handle.Proxy).__name__ == "NormalHandleFeature" and abs(fill.Shape.Area - area) < 1e-12 * area
    handle.Normal = App.Vector(-0.5, 0, 1)
    document.recompute()
    assert fill.isValid() and lean(fill, middle, (-0.5, 0, 1)) < lean(fill, middle, (0.5, 0, 1))


def moves_with_its_part():
    document, fill, middle = guided()
    part = document.addObject("App::Part", "Part")
    part.Placement = App.Placement(App.Vector(100, 0, 50), App.Rotation(App.Vector(0, 1, 0), 30))
    part.addObject(fill.Guides[0])  # the handle alone: it stands elsewhere now
    fill.Guides[0].Position = part.Placement.inverse().multVec(middle)
    fill.Guides[0].Normal = part.Placement.Rotation.inverted().multVec(App.Vector(0.5, 0, 1))
    area = fill.Shape.Area
    document.recompute()
    assert fill.isValid() and abs(fill.Shape.Area - area) < 1e-9 * area, fill.Verdict


def a_reference_of_several_objects():
    document, base, edges = support.example()
    free = fairing.make_fill(base, edges[:1])
    raised = []
    for name, shift in (("Raised", 6), ("Higher", 9)):
        part = document.addObject("Part::Feature", name)
        part.Shape = free.Shape.translated(App.Vector(0, 0, shift))
        raised.append(part)
    pulled = fairing.make_fill(base, edges[:1], reference=raised, gamma=1e5)
    assert [obj for obj, _ in pulled.Reference] == raised
    assert 0.5 < pulled.Shape.CenterOfMass.z - free.Shape.CenterOfMass.z < 6.0  # the nearer one pulls
    assert 0.0 < pulled.GuideRmsDistance.Value < 6.0 and pulled.GuideCovered > 0.5, pulled.GuideCovered
    sketch = document.addObject("Part::Feature", "Line")
    sketch.Shape = Part.makeLine(App.Vector(), App.Vector(1, 0, 0))
    assert "Line has no face" in support.refused(lambda: fairing.change_fill(pulled, reference=sketch))


def a_reference_of_an_older_version_is_kept():
    document, base, edges = support.example()
    free = fairing.make_fill(base, edges[:1])
    raised = document.addObject("Part::Feature", "Raised")
    raised.Shape = free.Shape.translated(App.Vector(0, 0, 6))
    pulled = fairing.make_fill(base, edges[:1], reference=raised, gamma=1e5)
    for names in ([""], ["Face1"]):
        pulled.removeProperty("Reference")  # as version 1 had it
        pulled.addProperty("App::PropertyLinkSubGlobal", "Reference", "Guidance")
        pulled.Reference = (raised, names)
        pulled.FairingVersion = 1
        pulled.Proxy.onDocumentRestored(pulled)
        assert pulled.Reference == [(raised, tuple(names))], pulled.Reference
        pulled.touch()
        document.recompute()
        assert pulled.isValid(), pulled.Verdict


def a_surface_follows_a_curve():
    document, base, edges = support.example()
    free = fairing.make_fill(base, edges[:1], energy="thin-plate")
    middle = middle_of(free)
    line = document.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine(middle - App.Vector(8, 0, 0), middle + App.Vector(8, 0, 0))
    fill = fairing.make_fill(base, edges[:1], energy="thin-plate", lambda_=LAMBDA,
                             guides=[{"curve": line, "normal": (0, 1, 2), "radius": 10}])
    curve, = fill.Guides
    assert curve.FairingType == "FeatureCurve" and len(curve.Points) == len(curve.Normals) >= 2
    assert all(abs(normal.x) < 1e-9 for normal in curve.Normals)  # square to the curve
    assert lean(fill, middle, (0, 1, 2)) < 0.3 * lean(free, middle, (0, 1, 2))
    line.Placement = App.Placement(App.Vector(), App.Rotation(App.Vector(0, 0, 1), 10), middle)
    document.recompute()
    assert fill.isValid() and max(abs(normal.x) for normal in curve.Normals) > 0.01
    flat = document.addObject("Part::Feature", "Flat")
    flat.Shape = Part.makePlane(100, 100, App.Vector(-50, -50, 0))
    fairing.change_fill(fill, guides=[{"curve": line, "faces": (flat, ["Face1"]), "radius": 10}])
    assert all(abs(abs(normal.z) - 1) < 1e-9 for normal in fill.Guides[0].Normals)
    fairing.change_fill(fill, guides=[{"curve": (base, edges[:1]), "radius": 10}])  # the face beside that edge tells
    wish = base.Shape.ancestorsOfType(base.Shape.getElement(edges[0]), Part.Face)[0]
    at = fill.Guides[0].Points[len(fill.Guides[0].Points) // 2]
    theirs = wish.normalAt(*wish.Surface.parameter(at))
    assert abs(theirs.dot(fill.Guides[0].Normals[len(fill.Guides[0].Points) // 2])) > 0.9999
    assert "has no edge" in support.refused(lambda: fairing.change_fill(
        fill, guides=[{"curve": document.addObject("Part::Vertex", "V"), "radius": 1}]))


def a_mesh_is_a_reference():
    document, base, edges = support.example()
    free = fairing.make_fill(base, edges[:1])
    mesh = document.addObject("Mesh::Feature", "Scan")
    mesh.Mesh = Mesh.Mesh(free.Shape.tessellate(0.05))
    mesh.Placement = App.Placement(App.Vector(0, 0, 6), App.Rotation())
    pulled = fairing.make_fill(base, edges[:1], reference=mesh, gamma=1e5)
    assert pulled.Reference[0][0] is mesh
    assert 0.5 < pulled.Shape.CenterOfMass.z - free.Shape.CenterOfMass.z < 6.0
    flipped = mesh.Mesh.copy()
    points, triangles = flipped.Topology
    triangles[3] = triangles[3][::-1]
    mesh.Mesh = Mesh.Mesh((points, triangles))
    assert "Harmonise its normals" in support.refused(lambda: fairing.change_fill(pulled, reference=mesh))


support.run_all(globals())
