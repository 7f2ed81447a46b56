# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guidance that moves: Fill.guiding() and its kin, meshes and curves that guide, blends under guidance."""

import json
import math
import os
import subprocess

import FreeCAD as App
import numpy as np
import Part
import pytest

import fairing
from fairing import _fairing, exchange

PROGRAM = os.environ["FAIRING_BINARY"]
SIDE = 30.0


def sheet_with_hole():
    """A wavy sheet of three by three faces without the middle one."""
    count = 13
    surface = Part.BSplineSurface()
    surface.interpolate([[App.Vector(SIDE * i / (count - 1), SIDE * j / (count - 1),
                                     2.0 * math.sin(4.0 * i / count) * math.cos(3.0 * j / count))
                          for j in range(count)] for i in range(count)])
    thirds = [k / 3 for k in range(4)]
    faces = [surface.copy() for _ in range(8)]
    cells = [(i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    for face, (i, j) in zip(faces, cells):
        face.segment(thirds[i], thirds[i + 1], thirds[j], thirds[j + 1])
    shell = Part.Shell([face.toShape() for face in faces])
    shell.sewShape()
    return surface, shell


def hole_of(shell):
    shape = exchange.native_shape(shell)
    return shape, min(shape.holes(), key=len)


def two_pipes():
    """Coaxial pipes with a gap from z = 10 to z = 20."""
    lower = Part.makeCylinder(5, 10, App.Vector(0, 0, 0)).Faces[0]
    upper = Part.makeCylinder(5, 10, App.Vector(0, 0, 20)).Faces[0]
    return Part.Compound([lower, upper])


def rims(shape):
    """The numbers of the edges round z = 10 and z = 20."""
    return [[number for number, edge in enumerate(shape.Edges, 1) if not edge.isSeam(shape.Faces[0])
             and edge.Closed and abs(edge.BoundBox.ZMin - z) < 1e-6] for z in (10, 20)]


@pytest.fixture(scope="module")
def fill():
    _, shell = sheet_with_hole()
    shape, edges = hole_of(shell)
    middle = [SIDE / 2, SIDE / 2, 0.0]
    return shape.fill(edges=edges, lambda_=5.0, guide=[{"point": middle, "normal": [0.5, 0, 1], "radius": 6.0}])


def test_more_weight_is_followed_more_closely(fill):
    angles = [fill.guiding(weight, 0.0).report["guidance"]["rms_angle"] for weight in (0, 1, 10, 100, 1000)]
    assert all(after < before for before, after in zip(angles, angles[1:]))


def test_the_border_is_met_at_any_weight(fill):
    assert fill.guiding(1e4, 0.0).report["largest_gap"] <= fill.report["largest_gap"] + 1e-9


def test_a_handle_turns_what_is_followed(fill):
    other = fill.guiding(500.0, 0.0, guide=[{"point": [SIDE / 2, SIDE / 2, 0], "normal": [-0.5, 0, 1], "radius": 6.0}])
    _, normals, weights = other.guide_arrows(9)
    assert (normals[:, 0] * normals[:, 2] < 0).all()
    assert ((0 < weights) & (weights <= 1 + 1e-9)).all()
    assert other.report["guidance"]["rms_angle"] < other.guiding(0.0, 0.0).report["guidance"]["rms_angle"] - 0.5


def test_control_nets_are_those_of_the_patches(fill):
    nets = fill.control_net()
    assert sum(rows * columns for rows, columns, _ in nets) == fill.report["solve"]["poles"]
    assert all(points.shape == (rows * columns, 3) for rows, columns, points in nets)


def test_a_mesh_guides_as_its_surface_does():
    surface, shell = sheet_with_hole()
    shape, edges = hole_of(shell)
    params = np.linspace(0.25, 0.75, 60)
    points = np.array([[tuple(surface.value(u, v)) for v in params] for u in params]).reshape(-1, 3)
    cells = [(i * 60 + j, (i + 1) * 60 + j, (i + 1) * 60 + j + 1, i * 60 + j + 1)
             for i in range(59) for j in range(59)]
    triangles = np.array([t for a, b, c, d in cells for t in ((a, b, c), (a, c, d))], dtype=np.int32)
    guided = shape.fill(edges=edges, lambda_=100.0, gamma=1e6, reference=_fairing.mesh_faces(points, triangles))
    assert guided.report["guidance"]["covered"] == 1.0
    assert guided.report["guidance"]["rms_distance"] < 1e-4 * SIDE
    with pytest.raises(_fairing.FairingError) as wrong:
        _fairing.mesh_faces(points, np.vstack([triangles[1:], triangles[:1, ::-1]]))
    assert wrong.value.code == "MeshFlipped"


def test_a_curve_takes_normals_from_faces_or_a_direction():
    surface, shell = sheet_with_hole()
    edge = surface.vIso(0.5).toShape()
    points, normals = _fairing.guide_curve(exchange.data_of(edge), exchange.data_of(surface.toShape()))
    for point, normal in zip(points, normals):
        wish = surface.normal(*surface.parameter(App.Vector(*point)))
        assert abs(abs(np.dot(normal, tuple(wish))) - 1.0) < 1e-6
    _, upright = _fairing.guide_curve(exchange.data_of(edge), None, (0, 0, 1))
    assert np.allclose(np.linalg.norm(upright, axis=1), 1.0)
    shape, edges = hole_of(shell)
    inside = [k for k, p in enumerate(points) if 0.4 < p[0] / SIDE < 0.6]
    curve = {"points": points[inside].tolist(), "normals": [[0, 0.4, 1]], "radius": 3.0}
    angles = [shape.fill(edges=edges, lambda_=weight, guide={"curves": [curve]}).report["guidance"]["rms_angle"]
              for weight in (0.0, 10.0, 1000.0)]
    assert angles[2] < angles[1] < angles[0]


def test_blends_follow_guides_and_move_with_them():
    pipes = two_pipes()
    lower, upper = rims(pipes)
    shape = exchange.native_shape(pipes)
    guide = [{"point": [5, 0, 15], "normal": [1, 0, 0.5], "radius": 4.0}]
    blend = shape.blend(lower, upper, lambda_=100.0, guide=guide)
    assert blend.within_tolerance
    angles = [blend.guiding(weight, 0.0).report["guidance"]["rms_angle"] for weight in (0, 1, 10, 100, 1000)]
    assert all(after < before for before, after in zip(angles, angles[1:]))
    assert abs(angles[3] - blend.report["guidance"]["rms_angle"]) < 0.5


def test_guided_blends_keep_their_reach():
    pipes = two_pipes()
    lower, upper = rims(pipes)
    blend = exchange.native_shape(pipes).blend(
        lower, upper, from_reach=1.5, lambda_=10.0, guide=[{"point": [5, 0, 15], "normal": [1, 0, 0.5], "radius": 4.0}])
    moved = blend.guiding(10.0, 0.0)
    assert exchange.part_shape(moved.brep()).Area == pytest.approx(exchange.part_shape(blend.brep()).Area, rel=1e-3)
    assert moved.report["guidance"]["rms_angle"] == pytest.approx(blend.report["guidance"]["rms_angle"], rel=0.05)


def test_scripts_guide_blends():
    pipes = two_pipes()
    lower, upper = rims(pipes)
    faces, report = fairing.blend(pipes, lower, upper, lambda_=50.0, gamma=1e3,
                                  reference=Part.makeCylinder(5.5, 10, App.Vector(0, 0, 10)).Faces[0])
    plain, _ = fairing.blend(pipes, lower, upper)
    assert report["guidance"]["covered"] > 0.9
    assert faces.BoundBox.XMax > plain.BoundBox.XMax + 0.05


def test_the_program_guides_blends(tmp_path):
    pipes = two_pipes()
    lower, upper = rims(pipes)
    pipes.exportBrep(str(tmp_path / "pipes.brep"))
    (tmp_path / "guide.json").write_text(json.dumps([{"point": [5, 0, 15], "normal": [1, 0, 0.5], "radius": 4.0}]))
    done = subprocess.run(
        [PROGRAM, "blend", "pipes.brep", "-o", "out.brep", "--from", str(lower[0]), "--to", str(upper[0]),
         "--guide", "guide.json", "--lambda", "100", "--report", "out.json"],
        cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    report = json.loads((tmp_path / "out.json").read_text())["blend"]
    same = exchange.native_shape(pipes).blend(
        lower, upper, lambda_=100.0, guide=[{"point": [5, 0, 15], "normal": [1, 0, 0.5], "radius": 4.0}])
    assert report["guidance"]["rms_angle"] == pytest.approx(same.report["guidance"]["rms_angle"], abs=1e-6)
