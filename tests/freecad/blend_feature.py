# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric blend without a window: made of one object or of two, recomputed, moved, changed, failing, saved."""

import math
import sys

import FreeCAD as App
import Part

import fairing
import support


def cup(radius, bottom, height, open_end):
    """A cylinder's wall and one of its caps."""
    faces = Part.makeCylinder(radius, height, App.Vector(0, 0, bottom)).Faces
    return Part.makeShell([face for face in faces if abs(face.CenterOfMass.z - open_end) > 1e-6])


def edge_at(shape, height):
    """The name of the circle at a height."""
    return next(f"Edge{number}" for number, edge in enumerate(shape.Edges, 1)
                if edge.isClosed() and abs(edge.CenterOfMass.z - height) < 1e-6)


def object_of(document, name, shape):
    obj = document.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj


def two_cups(name="Cups"):
    """A document with two coaxial cups that face each other, and their rims as links."""
    document = App.newDocument(name)
    low, high = (object_of(document, "Low", cup(10, 0, 20, 20)), object_of(document, "High", cup(6, 35, 15, 35)))
    document.recompute()
    return document, (low, [edge_at(low.Shape, 20)]), (high, [edge_at(high.Shape, 35)])


def two_planes(name="Planes"):
    """A document with an object of two rectangles, and the edges that face each other."""
    document = App.newDocument(name)
    base = object_of(document, "Base", Part.Compound([Part.makePlane(20, 10),
                                                      Part.makePlane(20, 10, App.Vector(0, 20, 8))]))
    document.recompute()
    names = [next(f"Edge{number}" for number, edge in enumerate(base.Shape.Edges, 1)
                  if edge.CenterOfMass.distanceToPoint(App.Vector(*middle)) < 1e-6)
             for middle in ((10, 10, 0), (10, 20, 8))]
    return document, base, names


def joins(blend, *sides):
    """Asserts one valid face that meets every side tangentially, measured here."""
    assert blend.State == ["Up-to-date"], blend.State
    assert blend.Shape.isValid() and len(blend.Shape.Faces) == 1, blend.Shape.ShapeType
    for base, names in sides:
        # the circles are met to a millionth of the diagonal of both chains, here at most 60 mm
        assert support.largest_gap(blend.Shape, base, names) < 6e-5
        assert support.largest_angle(blend.Shape, base, names) <= support.ANGLE_TOLERANCE
    assert blend.WithinTolerance and blend.LargestAngle.Value <= support.ANGLE_TOLERANCE, blend.Verdict


def least_y(blend):
    return min(vertex.Y for vertex in blend.Shape.Vertexes)


def joins_two_objects_tangentially():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high)
    joins(blend, low, high)
    assert blend.FairingType == "Blend" and blend.Name == "Blend"
    assert blend.ReportEdges == [f"Low.{low[1][0]}", f"High.{high[1][0]}"], blend.ReportEdges
    assert len(blend.EdgeGaps) == len(blend.EdgeAngles) == 2
    assert abs(blend.FilledArea.Value - blend.Shape.Area) < 1e-6 * blend.Shape.Area
    for name in ("Verdict", "LargestGap", "EdgeAngles"):
        assert "ReadOnly" in blend.getTypeOfProperty(name), name


def joins_two_edges_of_one_object():
    document, base, names = two_planes()
    blend = fairing.make_blend((base, names[0]), (base, names[1]), continuity="G2")
    joins(blend, (base, names))
    assert sorted(blend.ReportEdges) == sorted(names) and blend.Continuity == "G2"


def closes_two_cups_to_one_solid():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high, result="base")
    assert blend.isValid() and blend.Shape.ShapeType == "Solid" and blend.Shape.isValid(), blend.Shape.ShapeType
    cups = math.pi * (10 ** 2 * 20 + 6 ** 2 * 15)
    assert cups + math.pi * 6 ** 2 * 15 < blend.Shape.Volume < cups + math.pi * 10 ** 2 * 15


def follows_what_it_joins():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high)
    area = blend.Shape.Area
    high[0].Placement.Base = App.Vector(3, 0, 12)
    document.recompute()
    joins(blend, low, high)
    assert blend.Shape.Area > area + 100.0, "a strip that spans 27 mm in place of 15"
    for cup_object in (low[0], high[0]):
        cup_object.Placement = App.Placement(App.Vector(5, 70, -20), App.Rotation(App.Vector(3, 1, 2), 75)).multiply(
            cup_object.Placement)
    moved = blend.Shape.Area
    document.recompute()
    joins(blend, low, high)
    assert abs(blend.Shape.Area - moved) < 1e-5 * moved


def follows_the_numbers_of_a_changed_cylinder():
    document = App.newDocument("Cylinders")
    low = document.addObject("Part::Cylinder", "Cylinder")
    low.Radius, low.Height = 10, 20
    wall = document.addObject("Part::Feature", "Wall")
    wall.Shape = cup(6, 35, 15, 35)
    tube = document.addObject("Part::FeaturePython", "Tube")

    class Open:
        def execute(self, obj):
            obj.Shape = Part.makeShell(low.Shape.Faces[:1])

    tube.Proxy = Open()
    document.recompute()
    rim = (tube, [edge_at(tube.Shape, 20)])
    blend = fairing.make_blend(rim, (wall, [edge_at(wall.Shape, 35)]))
    low.Radius = 8
    tube.touch()
    document.recompute()
    joins(blend, rim)


def lives_beside_its_base_in_a_part():
    document, low, high = two_cups()
    part = document.addObject("App::Part", "Part")
    part.addObject(low[0])
    part.Placement = App.Placement(App.Vector(0, 0, -5), App.Rotation())
    document.recompute()
    blend = fairing.make_blend(low, high)
    assert blend.getParentGeoFeatureGroup() is part and blend.isValid()
    top = blend.Shape.BoundBox.ZMax
    assert abs(top - 40.0) < 1e-3, f"High's rim is 40 mm above the Part's origin, the blend ends at {top}"


def failing_keeps_the_last_good_shape_and_says_why():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high)
    area, largest = blend.Shape.Area, blend.LargestAngle
    for name, value, words in (("FromEdges", [(low[0], ["Edge99"])], "edge 99"), ("ToEdges", [], "no edge"),
                               ("ToEdges", [low], "both sides"), ("FromEdges", [(low[0], ["Face1"])], "Face1"),
                               ("AngleTolerance", 0.0, "angle"), ("Degree", 99, "degree"),
                               ("FromReach", 0.0, "reach"),
                               ("FromContinuity", ["nonsense"], "nonsense"),
                               ("ToContinuity", [f"{high[1][0]}=G9"], "G9")):
        good = getattr(blend, name)
        setattr(blend, name, value)
        document.recompute()
        assert not blend.isValid() and words in blend.Verdict and "\n" not in blend.Verdict, (name, blend.Verdict)
        assert blend.Verdict in blend.getStatusString(), "the tree's tooltip says something else"
        assert not blend.WithinTolerance and blend.Shape.Area == area and blend.LargestAngle == largest
        setattr(blend, name, good)
    document.recompute()
    joins(blend, low, high)


def bad_input_leaves_the_document_as_it_was():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high)
    before = [(obj.Name, obj.State) for obj in document.Objects]
    for first, second, options in ((low, low, {}), (low, None, {}), ((low[0], []), high, {}),
                                   ((low[0], ["Vertex1"]), high, {}), ((low[0], ["Edge99"]), high, {}),
                                   (low, high, {"energy": "soap"}), (low, high, {"gap_tolerance": 0.0}),
                                   (low, high, {"angle_tolerance": float("nan")}),
                                   (low, high, {"to_continuity": {high[1][0]: "G7"}})):
        assert support.refused(lambda: fairing.make_blend(first, second, **options))
        if second:
            assert support.refused(lambda: fairing.change_blend(blend, from_edges=first, to_edges=second, **options))
        assert [(obj.Name, obj.State) for obj in document.Objects] == before
    joins(blend, low, high)


def reaches_farther_on_one_side():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high)
    area = blend.Shape.Area
    blend.FromReach = 1.6
    document.recompute()
    joins(blend, low, high)
    assert blend.Shape.Area > area + 1.0


def choices_change_the_surface_and_are_kept():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high)
    fair = blend.Shape.Area
    fairing.change_blend(blend, energy="membrane", to_continuity={high[1][0]: "G0"})
    assert blend.isValid() and blend.Energy == "membrane" and blend.ToContinuity == [f"{high[1][0]}=G0"]
    assert blend.FromContinuity == [] and blend.Shape.Area < fair
    assert blend.EdgeAngles[0] <= support.ANGLE_TOLERANCE and blend.EdgeAngles[1] > 1.0
    fairing.change_blend(blend, degree=6)
    assert blend.ToContinuity == [f"{high[1][0]}=G0"] and blend.Degree == 6
    fairing.change_blend(blend, to_continuity={}, energy="mean-curvature-gradient", degree=0)
    joins(blend, low, high)


def picked_edges_are_told_apart_into_sides():
    from fairing.features.blend_picks import two_sides

    document, base, names = two_planes()
    beside = next(f"Edge{number}" for number, edge in enumerate(base.Shape.Edges, 1)
                  if edge.CenterOfMass.distanceToPoint(App.Vector(0, 5, 0)) < 1e-6)
    assert two_sides([(base, names[::-1])]) == ([(base, names[1:])], [(base, names[:1])])
    for order in (names, names[::-1]):
        first, second = two_sides([(base, [*order, beside])])
        own = sorted(order[:1] + [beside]) if order is names else order[:1]
        assert [(obj, sorted(edges)) for obj, edges in first] == [(base, own)]
        assert sorted(second[0][1]) == sorted({*names, beside} - set(own))
    far = object_of(document, "Far", Part.makePlane(5, 5, App.Vector(0, 100, 0)))
    first, second = two_sides([(far, ["Edge1"]), (base, [names[0], beside])])
    assert first == [(far, ["Edge1"])] and second[0][0] is base and sorted(second[0][1]) == sorted([names[0], beside])
    first, second = two_sides([(far, ["Edge1"]), (base, names)])
    assert first == [(far, ["Edge1"])] and second[0][0] is base and sorted(second[0][1]) == sorted(names)
    assert "no edge" in support.refused(lambda: two_sides([(base, names[:1])]))
    assert "one chain" in support.refused(lambda: two_sides([(far, ["Edge1", "Edge2", "Edge3"])]))


def takes_edges_of_several_objects_on_a_side():
    document = App.newDocument("Parts")
    high, west, east = (object_of(document, name, Part.makePlane(width, 10, App.Vector(x, y, z)))
                        for name, width, x, y, z in (("High", 20, 0, 20, 8), ("West", 9, 0, 0, 0), ("East", 11, 9, 0, 0)))
    document.recompute()
    top, left, right = ((obj, [next(f"Edge{n}" for n, edge in enumerate(obj.Shape.Edges, 1) if edge.BoundBox.YMin == y
                                    and edge.BoundBox.YLength < 1)]) for obj, y in ((high, 20), (west, 10), (east, 10)))
    blend = fairing.make_blend(top, [left, right], to_continuity={f"East.{right[1][0]}": "G0"})
    assert blend.FromEdges == [(high, tuple(top[1]))]
    assert blend.ToEdges == [(west, tuple(left[1])), (east, tuple(right[1]))]
    assert blend.ToContinuity == [f"East.{right[1][0]}=G0"]
    angles = dict(zip(blend.ReportEdges, blend.EdgeAngles))
    assert set(angles) == {f"{obj.Name}.{names[0]}" for obj, names in (top, left, right)}
    assert angles[f"West.{left[1][0]}"] <= support.ANGLE_TOLERANCE and angles[f"East.{right[1][0]}"] > 1.0, angles
    fairing.change_blend(blend, to_continuity={})
    joins(blend, top, left, right)
    before = blend.Shape.Area
    assert "West.Edge" in support.refused(lambda: fairing.change_blend(blend, to_continuity={"Edge1": "G0"}))
    fairing.change_blend(blend, to_edges=left)
    assert blend.ToEdges == [(west, tuple(left[1]))] and blend.Shape.Area < before - 1.0


def starts_at_a_sketch_on_the_face():
    document, base, names = two_planes()
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.Placement.Base = App.Vector(0, 0, 0.1)  # a little above the lower plane
    for ends in (((9, 6, 0), (-1, 6, 0)), ((9, 6, 0), (21, 6, 0))):
        sketch.addGeometry(Part.LineSegment(*(App.Vector(*end) for end in ends)), False)
    document.recompute()
    low, high = (base, names[:1]), (base, names[1:])
    blend = fairing.make_blend(low, high, from_curve=(sketch, ["Edge1", "Edge2"]))
    assert blend.FromCurve == [(sketch, ("Edge1", "Edge2"))] and blend.ToCurve == []
    assert abs(least_y(blend) - 6.0) < 1e-6 and blend.WithinTolerance
    assert set(blend.ReportEdges) == {*names} and "laid onto face" in blend.Notes[0], (blend.ReportEdges, blend.Notes)
    sketch.Placement.Base.y = 1.0  # drawn anew: the blend follows
    document.recompute()
    assert abs(least_y(blend) - 7.0) < 1e-6
    fairing.change_blend(blend, from_curve=sketch, result="base")  # the whole sketch
    assert [obj for obj, _ in blend.FromCurve] == [sketch]
    level = [face for face in blend.Shape.Faces if face.CenterOfMass.z < 1e-6]
    assert abs(sum(face.Area for face in level) - 20.0 * 7.0) < 1e-4
    error = support.refused(lambda: fairing.change_blend(blend, from_setback=1.0))
    assert "by a distance and by a curve" in error and blend.FromSetback.Value == 0.0
    fairing.change_blend(blend, from_curve=[], result="patches")
    joins(blend, low, high)
    error = support.refused(lambda: fairing.change_blend(blend, from_curve=(sketch, ["Edge9"])))
    assert "Sketch has 2" in error, error
    error = support.refused(lambda: fairing.change_blend(blend, to_curve=(sketch, ["Face1"])))
    assert "is not an edge" in error, error
    joins(blend, low, high)


def starts_at_an_edge_of_what_it_joins():
    document = App.newDocument("Steps")
    base = object_of(document, "Base", Part.Compound([
        Part.makeShell([Part.makePlane(20, 6), Part.makePlane(20, 4, App.Vector(0, 6, 0))]),
        Part.makePlane(20, 10, App.Vector(0, 20, 8))]))
    document.recompute()
    low, middle, high = (next(f"Edge{number}" for number, edge in enumerate(base.Shape.Edges, 1)
                              if edge.CenterOfMass.distanceToPoint(App.Vector(*point)) < 1e-6)
                         for point in ((10, 10, 0), (10, 6, 0), (10, 20, 8)))
    blend = fairing.make_blend((base, [low]), (base, [high]), from_curve=(base, [middle]))
    joins(blend, (base, [middle]), (base, [high]))
    assert blend.ReportEdges == [low, high], blend.ReportEdges


def a_handle_and_a_reference_guide_it():
    document, base, (first, second) = two_planes()
    free = fairing.make_blend((base, [first]), (base, [second]))
    middle, wish = App.Vector(10, 15, 4), App.Vector(0.4, -1, 1)

    def lean(blend):
        face = blend.Shape.Faces[0]
        angle = math.degrees(face.Surface.normal(*face.Surface.parameter(middle)).getAngle(wish))
        return min(angle, 180.0 - angle)

    handle = {"point": tuple(middle), "normal": tuple(wish), "radius": 8}
    blend = fairing.make_blend((base, [first]), (base, [second]), guides=[handle], lambda_=1e3)
    assert lean(blend) < 0.8 * lean(free), (lean(blend), lean(free))
    joins(blend, (base, [first, second]))
    assert blend.Guides[0].FairingType == "NormalHandle" and blend.GuideRmsAngle.Value > 0.0
    lightly = lean(blend)
    blend.Guides[0].Weight = 0.1
    document.recompute()
    assert lightly < lean(blend) < lean(free)
    raised = object_of(document, "Raised", free.Shape.translated(App.Vector(0, 0, 2)))
    fairing.change_blend(blend, guides=[], reference=raised, lambda_=0.0, gamma=1e4)
    assert blend.Guides == [] and blend.Reference[0][0] is raised and blend.Gamma == 1e4
    assert 0.2 < blend.Shape.CenterOfMass.z - free.Shape.CenterOfMass.z < 2.0


def survives_save_and_reopen():
    document, low, high = two_cups()
    blend = fairing.make_blend(low, high, degree=6, from_continuity={low[1][0]: "G2"})
    area = blend.Shape.Area
    path = support.saved(document)
    App.closeDocument(document.Name)
    document = App.openDocument(path)
    blend = document.Blend
    assert type(blend.Proxy).__name__ == "BlendFeature" and abs(blend.Shape.Area - area) < 1e-12 * area
    assert blend.FromContinuity == [f"{low[1][0]}=G2"] and blend.Degree == 6
    assert blend.FromEdges[0][0] is document.Low and blend.ToEdges[0][0] is document.High
    blend.touch()
    document.recompute()
    assert blend.isValid() and abs(blend.Shape.Area - area) < 1e-9 * area


def its_ends_follow_edges_and_faces_of_other_objects():
    document, base, names = two_planes("Ends")
    curve = Part.BezierCurve()
    curve.setPoles([App.Vector(*pole) for pole in ((0, 10, 0), (0, 14, 0), (0, 16, 8), (0, 20, 8))])
    curve = object_of(document, "Curve", curve.toShape())
    wall = object_of(document, "Wall", Part.makePlane(60, 60, App.Vector(20, 50, -20), App.Vector(1, 0, 0)))
    blend = fairing.make_blend((base, names[0]), (base, names[1]), ends=[(curve, ["Edge1"]), (wall, ["Face1"])])
    assert blend.isValid() and blend.WithinTolerance, blend.Verdict
    assert blend.Ends == [(curve, ("Edge1",)), (wall, ("Face1",))], blend.Ends
    assert {"Curve.Edge1", "Wall.Face1"} <= set(blend.ReportEdges), blend.ReportEdges
    gap = max(blend.Shape.distToShape(Part.Vertex(point))[0] for point in curve.Shape.Edges[0].discretize(20))
    assert gap < 5e-5 and abs(blend.Shape.BoundBox.XMax - 20) < 1e-5
    fairing.change_blend(blend, from_reach=1.2)
    assert len(blend.Ends) == 2 and blend.WithinTolerance, blend.Verdict
    path = support.saved(document)
    App.closeDocument(document.Name)
    document = App.openDocument(path)
    blend = document.Blend
    document.Wall.Placement.Base = App.Vector(5, 0, 0)
    document.recompute()
    assert not blend.isValid() and "5 mm off it" in blend.Verdict, blend.Verdict
    fairing.change_blend(blend, ends=[(document.Curve, ["Edge1"])])
    assert blend.isValid() and len(blend.Ends) == 1 and "Wall.Face1" not in blend.ReportEdges
    fairing.change_blend(blend, ends=[])
    assert blend.Ends == [] and len(blend.ReportEdges) == 2


def a_dead_one_comes_back_to_life():
    from fairing.features import reconnect

    document, low, high = two_cups()
    blend = fairing.make_blend(low, high)
    blend.Proxy = 0
    assert reconnect.reconnect(document) == [blend] and type(blend.Proxy).__name__ == "BlendFeature"
    document.recompute()
    joins(blend, low, high)


def needs_no_window():
    assert not App.GuiUp and not {"FreeCADGui", "PySide", "PySide2", "pivy"} & set(sys.modules)


support.run_all(globals())
