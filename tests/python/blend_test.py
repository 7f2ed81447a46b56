# SPDX-License-Identifier: LGPL-2.1-or-later
"""fairing.blend() and the native Shape.blend(): tubes and planes joined, choices taken, nonsense refused."""

import math

import FreeCAD as App
import Part
import pytest

import fairing
from fairing import _fairing, exchange
from fairing.blend_request import BlendRequest

ANGLE = 0.02  # degrees, the default tolerance


def tube(radius, bottom, height):
    """The wall of a cylinder round the z axis."""
    return Part.makeCircle(radius, App.Vector(0, 0, bottom)).extrude(App.Vector(0, 0, height))


def edge_at(shape, middle):
    """The number of the edge whose centre of mass is nearest."""
    return 1 + min(range(len(shape.Edges)),
                   key=lambda k: shape.Edges[k].CenterOfMass.distanceToPoint(App.Vector(*middle)))


def largest_curvature_along(edge, face):
    """Of a face at points of an edge it ends at, 1/mm."""
    feet = [face.Surface.parameter(point) for point in edge.discretize(11)]
    return max(abs(face.Surface.curvature(*foot, kind)) for foot in feet for kind in ("Max", "Min"))


@pytest.fixture(scope="module")
def tubes():
    """Two coaxial tubes, and the numbers of the circles that face each other."""
    shape = Part.Compound([tube(10, 0, 20), tube(6, 35, 15)])
    return shape, edge_at(shape, (0, 0, 20)), edge_at(shape, (0, 0, 35))


@pytest.fixture(scope="module")
def planes():
    """Two level rectangles, 10 mm apart and 8 mm in height, and the numbers of the edges that face each other."""
    shape = Part.Compound([Part.makePlane(20, 10), Part.makePlane(20, 10, App.Vector(0, 20, 8))])
    return shape, edge_at(shape, (10, 10, 0)), edge_at(shape, (10, 20, 8))


@pytest.fixture(params=["tubes", "planes"])
def pair(request):
    return request.getfixturevalue(request.param)


def refused(code, action):
    with pytest.raises(fairing.FairingError) as caught:
        action()
    text = str(caught.value)
    assert caught.value.code == code, text
    assert text and "\n" not in text and text.endswith(".") and text[0].isupper()
    return caught.value


def test_meets_both_sides_tangentially(pair):
    shape, start, end = pair
    face, report = fairing.blend(shape, [start], [end])
    assert face.ShapeType == "Face" and face.isValid()
    assert report["layout"] == "strip" and report["within_tolerance"]
    assert sorted(side["edge"] for side in report["sides"]) == sorted([start, end])
    assert max(side["angle"]["max"] for side in report["sides"]) <= ANGLE
    assert max(side["gap"]["max"] for side in report["sides"]) <= report["limits"]["gap"]


def test_curvature_within_tolerance_on_request(pair):
    shape, start, end = pair
    face, report = fairing.blend(shape, [start], [end], continuity="G2")
    assert face.isValid() and report["within_tolerance"]
    assert report["largest_curvature"] <= report["limits"]["curvature"]


def test_a_plane_is_left_without_bending_on_request(planes):
    shape, start, end = planes
    bent = [largest_curvature_along(shape.Edges[start - 1], fairing.blend(shape, [start], [end], continuity=word)[0])
            for word in ("G1", "G2")]
    assert bent[1] < 0.01 * bent[0]  # rows hold it to rounding; a hundredth is what the report would let pass


def test_an_edge_that_differs_is_only_touched(planes):
    shape, start, end = planes
    _, report = fairing.blend(shape, [start], [end], edge_continuity={f"Edge{end}": "G0"})
    angles = {side["edge"]: side["angle"]["max"] for side in report["sides"]}
    assert angles[start] <= ANGLE and angles[end] > 1.0


def test_the_strip_between_tubes_is_round(tubes):
    shape, start, end = tubes
    face, report = fairing.blend(shape, [start], [end])
    # the circles are met to a millionth of the diagonal; between them a round strip stays round as closely as that
    assert abs(face.CenterOfMass.x) < 10 * report["limits"]["gap"]
    assert abs(face.CenterOfMass.y) < 10 * report["limits"]["gap"]


def test_sides_may_change_places(planes):
    shape, start, end = planes
    there, _ = fairing.blend(shape, start, f"Edge{end}")
    back, _ = fairing.blend(shape, end, start)
    assert there.CenterOfMass.distanceToPoint(back.CenterOfMass) < 1e-6
    assert there.Area == pytest.approx(back.Area, rel=1e-6)


def test_moves_with_the_shape(tubes):
    shape, start, end = tubes
    face, report = fairing.blend(shape, [start], [end])
    placement = App.Placement(App.Vector(100, 200, -50), App.Rotation(App.Vector(1, 1, 0), 35))
    moved = shape.copy()
    moved.Placement = placement
    again, _ = fairing.blend(moved, [start], [end])
    # as exact as the circles are met: knots may be chosen otherwise where rounding decides
    assert again.CenterOfMass.distanceToPoint(placement.multVec(face.CenterOfMass)) < 10 * report["limits"]["gap"]


def test_sews_into_what_it_joins(pair):
    shape, start, end = pair
    whole, report = fairing.blend(shape, [start], [end], result="base")
    assert whole.isValid() and whole.ShapeType == "Shell" and len(whole.Faces) == 3
    assert report["within_tolerance"]


def test_closes_cups_to_a_solid():
    cups = []
    for bottom, height, radius, open_end in ((0, 20, 10, 20), (35, 15, 6, 35)):
        solid = Part.makeCylinder(radius, height, App.Vector(0, 0, bottom))
        cups.append(Part.makeShell([face for face in solid.Faces if abs(face.CenterOfMass.z - open_end) > 1e-6]))
    shape = Part.Compound(cups)
    solid, report = fairing.blend(shape, [edge_at(shape, (0, 0, 20))], [edge_at(shape, (0, 0, 35))], result="base")
    assert solid.ShapeType == "Solid" and solid.isValid() and report["within_tolerance"]
    parts = math.pi * (10 ** 2 * 20 + 6 ** 2 * 15)
    assert parts + math.pi * 6 ** 2 * 15 < solid.Volume < parts + math.pi * 10 ** 2 * 15


def test_groups_edges_that_connect(planes):
    shape, start, end = planes
    neighbour = edge_at(shape, (0, 5, 0))
    assert sorted(exchange.native_shape(shape).chains([end, start, neighbour])) == sorted(
        [sorted([start, neighbour]), [end]])


def test_refuses_picks_that_make_no_sense(planes):
    shape, start, end = planes
    error = refused("EdgeOnBothSides", lambda: fairing.blend(shape, [start], [start]))
    assert error.edge == start
    refused("OneSideOnly", lambda: fairing.blend(shape, [start], []))
    refused("OneSideOnly", lambda: fairing.blend(shape, [], [end]))
    refused("EdgeOutOfRange", lambda: fairing.blend(shape, [99], [end]))
    refused("EdgeNotInLoop", lambda: fairing.blend(shape, [start], [end], edge_continuity={edge_at(shape, (10, 0, 0)):
                                                                                              "G0"}))
    refused("EdgeNotFree", lambda: exchange.native_shape(Part.makeBox(1, 1, 1)).blend([1], [2]))
    with pytest.raises(ValueError, match="Face1"):
        fairing.blend(shape, ["Face1"], [end])


def test_refuses_a_ring_and_a_line():
    shape = Part.Compound([tube(10, 0, 20), Part.makePlane(20, 10, App.Vector(0, 0, 40))])
    refused("ChainsUnlike", lambda: fairing.blend(shape, [edge_at(shape, (0, 0, 20))], [edge_at(shape, (10, 0, 40))]))


@pytest.mark.parametrize("options, code", [
    ({"tolerance": 0.0}, "ToleranceNotPositive"),
    ({"tolerance": math.nan}, "ToleranceNotPositive"),
    ({"angle": 0.0}, "AngleNotPositive"),
    ({"degree": 2}, "DegreeTooLow"),
    ({"energy": "soap"}, "UnknownChoice"),
    ({"continuity": "G7"}, "UnknownChoice"),
    ({"edge_continuity": {1: "smooth"}}, "UnknownChoice"),
    ({"result": "everything"}, "UnknownChoice"),
])
def test_refuses_options_that_make_no_sense(planes, options, code):
    shape, start, end = planes
    refused(code, lambda: exchange.native_shape(shape).blend([start], [end], **options))


def test_stops_when_told_to(tubes):
    shape, start, end = tubes
    progress = _fairing.Progress()
    progress.abort()
    refused("Cancelled", lambda: exchange.native_shape(shape).blend([start], [end], progress=progress))
    progress = _fairing.Progress()
    exchange.native_shape(shape).blend([start], [end], progress=progress)
    assert progress.fraction == 1.0


def test_can_be_drawn_and_told_in_words(tubes):
    shape, start, end = tubes
    done = exchange.native_shape(shape).blend([start], [end])
    points, normals, triangles = done.mesh(8)
    assert points.shape == normals.shape and points.shape[1] == 3 and triangles.max() < len(points)
    assert done.verdict.startswith("Meets") and done.within_tolerance and "strip" in done.composition


def test_a_repeated_blend_is_not_computed_again(tubes):
    shape, start, end = tubes
    request, data = BlendRequest.of([f"Edge{start}"], [end]), exchange.data_of(shape)
    assert request.solve(data) is request.solve(data)
    assert request.solve(data) is not BlendRequest.of([start], [end], continuity="G2").solve(data)


def test_reaches_farther_and_stays_tangent(tubes):
    shape, low, high = tubes
    plain, _ = fairing.blend(shape, [low], [high])
    longer, report = fairing.blend(shape, [low], [high], from_reach=1.6, to_reach=0.8)
    assert report["within_tolerance"] and report["largest_angle"] <= ANGLE
    # the wide tube goes on farther before it turns in: more room inside
    assert longer.isValid() and longer.Area > plain.Area + 1.0
    refused("ReachNotPositive", lambda: fairing.blend(shape, [low], [high], from_reach=0.0))


def test_leaves_its_sides_as_asked(tubes):
    shape, low, high = tubes
    _, report = fairing.blend(shape, [low], [high], from_departure="perpendicular", to_departure="iso")
    assert report["within_tolerance"] and all(side["departure"]["max"] < 0.1 for side in report["sides"])
    _, flipped = fairing.blend(shape, [low], [high], to_flip=True)
    assert [side["flipped"] for side in flipped["sides"]] == [False, True]
    assert not any(side["backwards"] for side in flipped["sides"])
    refused("ReachVariesRound", lambda: fairing.blend(shape, [low], [high], from_reach_end=2.0))
    refused("UnknownChoice", lambda: fairing.blend(shape, [low], [high], to_departure="along"))


def test_starts_inside_the_faces(tubes):
    shape, low, high = tubes
    plain, _ = fairing.blend(shape, [low], [high])
    longer, report = fairing.blend(shape, [low], [high], from_setback=1.0, to_setback=2.0)
    assert report["within_tolerance"] and [side["edge"] for side in report["sides"]] == [low, high]
    assert abs(longer.BoundBox.ZLength - plain.BoundBox.ZLength - 3.0) < 1e-5
    refused("SetbackTooLarge", lambda: fairing.blend(shape, [low], [high], from_setback=1000.0))
    refused("SetbackNegative", lambda: fairing.blend(shape, [low], [high], to_setback=-1.0))


def test_starts_at_a_drawn_curve(planes):
    shape, low, high = planes
    line = Part.makeLine(App.Vector(-1, 6, 0.1), App.Vector(21, 8, 0.1))
    drawn = Part.Compound([shape, line])
    number = len(drawn.Edges)
    surface, report = fairing.blend(drawn, [low], [high], from_curve=[f"Edge{number}"])
    assert report["within_tolerance"] and [side["edge"] for side in report["sides"]] == [low, high]
    start = min(surface.Edges, key=lambda edge: edge.CenterOfMass.y)
    for point in start.discretize(9):
        assert abs(point.z) < 1e-6 and abs(point.y - 6.0 - (point.x + 1.0) / 11.0) < 1e-6
    (note,) = report["notes"]
    assert (note["edge"], round(note["value"], 9)) == (number, 0.1) and "laid onto face" in note["text"]
    whole, _ = fairing.blend(drawn, [low], [high], from_curve=[number], result="base")
    assert len(whole.Faces) == 3 and abs(sum(face.Area for face in whole.Faces if face.CenterOfMass.z < 1e-6)
                                         - 20.0 * 7.0) < 1e-4
    refused("SetbackTwice", lambda: fairing.blend(drawn, [low], [high], from_curve=[number], from_setback=1.0))
    corners = [next(k for k, vertex in enumerate(drawn.Vertexes, 1) if vertex.Point.isEqual(App.Vector(*point), 1e-6))
               for point in ((0, 10, 0), (0, 20, 8))]
    refused("SetbackPairs", lambda: fairing.blend(drawn, [low], [high], from_curve=[number], pairs=[corners]))
    refused("EdgeOutOfRange", lambda: fairing.blend(drawn, [low], [high], to_curve=[99]))
    far = refused("SetbackCurveOff", lambda: fairing.blend(drawn, [low], [high], to_curve=[number]))
    assert far.edge == number and far.value > 7.9
    with pytest.raises(ValueError):
        fairing.blend(drawn, [low], [high], from_curve=["Face1"])


@pytest.mark.parametrize("ends, code", [
    (((5, 6, 0), (21, 6, 0)), "SetbackCurveShort"),
    (((10, -1, 0), (10, 11, 0)), "SetbackCurveBeside"),
])
def test_refuses_curves_that_cut_nothing_off(planes, ends, code):
    shape, low, high = planes
    drawn = Part.Compound([shape, Part.makeLine(*(App.Vector(*end) for end in ends))])
    refused(code, lambda: fairing.blend(drawn, [low], [high], from_curve=[len(drawn.Edges)]))


def test_refuses_curves_of_several_pieces_and_closed_ones(planes):
    shape, low, high = planes
    pieces = [Part.makeLine(App.Vector(-1, 6, 0), App.Vector(9, 6, 0)),
              Part.makeLine(App.Vector(11, 6, 0), App.Vector(21, 6, 0))]
    drawn = Part.Compound([shape, *pieces])
    count = len(drawn.Edges)
    refused("SetbackCurveBroken", lambda: fairing.blend(drawn, [low], [high], from_curve=[count, count - 1]))
    drawn = Part.Compound([shape, Part.makeCircle(2, App.Vector(10, 5, 0))])
    refused("SetbackCurveUnlike", lambda: fairing.blend(drawn, [low], [high], from_curve=[len(drawn.Edges)]))


@pytest.mark.parametrize("energy", ["thin-plate", "membrane", "mean-curvature-gradient", "triharmonic", "total-curvature"])
def test_a_strip_between_pipes_is_round(tubes, energy):
    shape, low, high = tubes
    faces, report = fairing.blend(shape, [low], [high], energy=energy)
    assert report["within_tolerance"] and report["largest_angle"] <= ANGLE
    surface = faces.Faces[0].Surface
    u0, u1, v0, v1 = surface.bounds()
    for share in (0.3, 0.5, 0.8):  # at one height, all round
        ring = [surface.value(u0 + k / 7 * (u1 - u0), v0 + share * (v1 - v0)) for k in range(8)]
        radii = [math.hypot(point.x, point.y) for point in ring]
        assert max(radii) - min(radii) < 0.01 and 5.0 < min(radii) < 11.0


def test_a_kept_blend_reaches_as_one_that_is_made_anew(tubes):
    shape, low, high = tubes
    native = exchange.native_shape(shape)
    kept = native.blend([low], [high])
    moved, anew = kept.reaching(1.6, 0.8), native.blend([low], [high], from_reach=1.6, to_reach=0.8)
    assert moved.within_tolerance and moved.verdict == anew.verdict
    assert (moved.mesh(8)[0] == anew.mesh(8)[0]).all()
    refused("ReachNotPositive", lambda: kept.reaching(1.0, 0.0))


def test_tells_how_it_leaves_either_side(tubes):
    shape, low, high = tubes
    arms = exchange.native_shape(shape).blend([low], [high]).arms
    for (point, vector), radius, height, up in zip(arms, (10, 6), (20, 35), (1, -1)):
        assert math.hypot(*point[:2]) == pytest.approx(radius, abs=1e-4) and point[2] == pytest.approx(height)
        assert App.Vector(*vector).getAngle(App.Vector(0, 0, up)) < math.radians(ANGLE)


def test_finds_the_whole_chain_of_an_edge():
    halves = [Part.makeCircle(10, App.Vector(), App.Vector(0, 0, 1), a, a + 180) for a in (0, 180)]
    shape = Part.makeShell([half.extrude(App.Vector(0, 0, 20)) for half in halves])
    rim = [number for number, edge in enumerate(shape.Edges, 1)
           if edge.BoundBox.ZMin > 19.9]
    assert len(rim) == 2
    native = exchange.native_shape(shape)
    for edge in rim:
        edges, closed = native.whole_chain([edge])
        assert sorted(edges) == rim and closed
    assert native.whole_chain(rim[:1], rim[1:]) == (rim[:1], False), "not the edges of the other side"


@pytest.fixture(scope="module")
def ended():
    """The planes, a curve from end to end on the left, a wall (face 3) on the right; numbers of sides and curve."""
    curve = Part.BezierCurve()
    curve.setPoles([App.Vector(*pole) for pole in ((0, 10, 0), (0, 14, 0), (0, 16, 8), (0, 20, 8))])
    wall = Part.makePlane(60, 60, App.Vector(20, 50, -20), App.Vector(1, 0, 0))
    shape = Part.Compound([Part.makePlane(20, 10), Part.makePlane(20, 10, App.Vector(0, 20, 8)), wall, curve.toShape()])
    return shape, edge_at(shape, (10, 10, 0)), edge_at(shape, (10, 20, 8)), edge_at(shape, (0, 15, 4))


def test_the_ends_follow_edges_and_faces(ended):
    shape, start, end, curve = ended
    face, report = fairing.blend(shape, [start], [end], ends=[f"Edge{curve}"], end_faces=["Face3"])
    assert face.isValid() and report["within_tolerance"]
    assert sorted(side["edge"] for side in report["sides"]) == sorted([0, curve, start, end])
    for point in shape.Edges[curve - 1].discretize(20):
        assert face.distToShape(Part.Vertex(point))[0] <= report["limits"]["gap"]
    assert face.BoundBox.XMax == pytest.approx(20, abs=1e-5)


def test_refuses_ends_that_make_no_sense(ended, tubes):
    shape, start, end, curve = ended
    error = refused("EndOffFace", lambda: fairing.blend(shape, [start], [end], ends=[curve], end_faces=[1]))
    assert error.face == 1 and error.value > 1.0
    refused("EndOnSide", lambda: fairing.blend(shape, [start], [end], ends=[start]))
    refused("EndTwice", lambda: fairing.blend(shape, [start], [end], end_faces=[3, 3]))
    tube_shape, low, high = tubes
    refused("EndsUnused", lambda: fairing.blend(tube_shape, [low], [high], end_faces=[1]))
    with pytest.raises(ValueError, match="not a face"):
        fairing.blend(shape, [start], [end], end_faces=["Edge1"])
