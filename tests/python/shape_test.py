# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native Shape: counting, finding holes, reading their boundary, filling them."""

import FreeCAD
import numpy as np
import Part
import pytest

from fairing import _fairing, exchange


def test_counts_edges_and_faces_as_freecad_does(shape, sheet):
    assert (shape.edge_count, shape.face_count) == (len(sheet.Edges), len(sheet.Faces))


def test_finds_the_hole_and_on_request_the_rim(shape, edges):
    assert [set(loop) for loop in shape.holes()] == [set(edges)]
    assert sorted(len(loop) for loop in shape.holes(outer_borders=True)) == [4, 12]


def test_every_pick_leads_to_the_same_loop(shape, edges):
    loops = [shape.find_loop([edge]) for edge in edges] + [shape.find_loop(edges[::-1])]
    assert all(loop == loops[0] for loop in loops)


def test_boundary_runs_head_to_tail_along_the_edges(shape, sheet, edges):
    sides = shape.boundary(edges[:1], edge_continuity={edges[1]: "G0"})
    for side, following in zip(sides, sides[1:] + sides[:1]):
        assert np.allclose(side["points"][-1], following["points"][0], atol=1e-9)
        edge, face = sheet.Edges[side["edge"] - 1], sheet.Faces[side["face"] - 1]
        assert any(edge.isSame(other) for other in face.Edges)
        assert side["length"] == pytest.approx(edge.Length, rel=1e-6)
        assert side["continuity"] == ("G0" if side["edge"] == edges[1] else "G1")


def test_fill_is_within_tolerance_and_says_so(shape, edges):
    fill = shape.fill(edges[:1])
    assert fill.within_tolerance and fill.verdict.startswith("Meets all 4 edges")
    assert fill.report["largest_angle"] <= 0.02
    assert fill.report["largest_gap"] <= 1e-6 * fill.report["diagonal"]
    assert {side["edge"] for side in fill.report["sides"]} == set(edges)
    assert len(fill.table.splitlines()) >= 5


def test_faces_come_back_as_valid_bspline_faces(shape, sheet, edges):
    patch = exchange.part_shape(shape.fill(edges[:1]).brep())
    assert patch.isValid() and [face.Surface.TypeId for face in patch.Faces] == ["Part::GeomBSplineSurface"]
    assert patch.Area == pytest.approx(shape.fill(edges[:1]).report["fairness"]["area"], rel=1e-6)


def test_normals_face_the_way_the_neighbours_do(shape, sheet, edges):
    points, normals, _ = shape.fill(edges[:1]).mesh(8)
    corner = make_vector(points[0])
    faces = [sheet.Faces[side["face"] - 1] for side in shape.boundary(edges[:1])]
    neighbour = min(faces, key=lambda face: face.distToShape(Part.Vertex(corner))[0])
    assert np.dot(normals[0], neighbour.normalAt(*neighbour.Surface.parameter(corner))) > 0.999


def test_mesh_lies_on_the_surface_and_is_oriented_like_its_normals(shape, edges):
    fill = shape.fill(edges[:1])
    points, normals, triangles = fill.mesh(divisions=10)
    assert points.dtype == normals.dtype == np.float32 and triangles.dtype == np.int32
    assert points.shape == normals.shape == (121, 3) and triangles.shape == (200, 3)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
    a, b, c = (points[triangles[:, k]].astype(float) for k in range(3))
    cross = np.cross(b - a, c - a)
    assert np.all(np.einsum("ij,ij->i", cross, normals[triangles[:, 0]]) > 0.0)
    surface = exchange.part_shape(fill.brep()).Faces[0].Surface
    for point in points[::7]:
        foot = surface.value(*surface.parameter(make_vector(point)))
        assert foot.distanceToPoint(make_vector(point)) < 1e-4
    assert 0.5 * np.linalg.norm(cross, axis=1).sum() == pytest.approx(fill.report["fairness"]["area"], rel=5e-3)


def test_reads_freecads_binary_shapes_too(sheet, edges, tmp_path):
    path = tmp_path / "sheet.bin"
    sheet.exportBinary(str(path))
    assert [set(loop) for loop in _fairing.Shape(path.read_bytes()).holes()] == [set(edges)]


def test_measure_agrees_with_the_report_of_the_fill(shape, edges):
    fill = shape.fill(edges[:1])
    report = shape.measure(_fairing.Shape(fill.brep()), edges[:1])
    assert report["within_tolerance"]
    assert report["largest_angle"] == pytest.approx(fill.report["largest_angle"], rel=0.2)


def test_guiding_normals_turn_the_surface(shape, edges):
    free = shape.fill(edges[:1])
    middle = np.array(free.mesh(2)[0][4], float)
    guide = [{"point": middle, "normal": (0.5, 0.0, 1.0), "radius": 40.0}]
    guided = shape.fill(edges[:1], guide=guide, lambda_=1e2)
    wanted = np.array([0.5, 0.0, 1.0]) / np.hypot(0.5, 1.0)
    assert np.dot(guided.mesh(2)[1][4], wanted) > np.dot(free.mesh(2)[1][4], wanted) + 1e-3
    assert guided.within_tolerance


def make_vector(point):
    return FreeCAD.Vector(*map(float, point))
