# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shaping a face anew: fairing.edit(), fairing edit, and guides as files and dicts."""

import json
import math
import os
import subprocess

import FreeCAD as App
import Part
import numpy as np
import pytest

import fairing
from fairing import _fairing as native
from interrupts import interrupted

PROGRAM = os.environ["FAIRING_BINARY"]
SIDE = 40.0


def face_of(height, count=9):
    """A bicubic face over a square, z = height(x, y) in shares of the side."""
    shares = [k / (count - 1) for k in range(count)]
    surface = Part.BSplineSurface()
    surface.interpolate([[App.Vector(SIDE * s, SIDE * t, height(s, t)) for t in shares] for s in shares])
    return surface.toShape()


@pytest.fixture(scope="module")
def face():
    return face_of(lambda s, t: 2.0 * math.sin(3.0 * s) * math.cos(2.0 * t))


def field(n, m):
    """Normals of a surface that swells in the middle."""
    return {"n": n, "m": m, "normals": [[0.8 * (i / n - 0.5), 0.8 * (j / m - 0.5), 1.0]
                                        for i in range(n + 1) for j in range(m + 1)]}


def border_points(shape):
    return [edge.valueAt(edge.FirstParameter + k / 7 * (edge.LastParameter - edge.FirstParameter))
            for edge in shape.Edges for k in range(8)]


def test_more_weight_follows_the_field_and_the_border_stays(face):
    angles = []
    for weight in (0.0, 1.0, 10.0, 50.0, 500.0):
        made, report = fairing.edit(face, "Face1", guide={"field": field(8, 8)}, lambda_=weight)
        angles.append(report["after"]["rms_angle"])
        assert made.ShapeType == "Face" and made.isValid()
        assert report["border_move"] <= 1e-12 * report["diagonal"]
        for a, b in zip(border_points(face), border_points(made)):
            assert a.distanceToPoint(b) <= 1e-12 * report["diagonal"]
    assert all(after < before for before, after in zip(angles, angles[1:]))


def test_handles_take_vectors_and_numbers_alike(face):
    at, wish = App.Vector(20, 20, 0), App.Vector(0.5, 0, 1)
    by_vector, _ = fairing.edit(face, 1, guide=[{"point": at, "normal": wish, "radius": 15}], lambda_=100)
    by_numbers, _ = fairing.edit(face, 1, guide=[{"point": (20, 20, 0), "normal": [0.5, 0, 1], "radius": 15.0}],
                                 lambda_=100)
    assert by_vector.CenterOfMass == by_numbers.CenterOfMass
    assert by_vector.CenterOfMass.distanceToPoint(face.CenterOfMass) > 1e-3


def test_a_reference_attracts_and_its_share_is_told(face):
    raised = face.translated(App.Vector(0, 0, 3))
    made, report = fairing.edit(face, 1, reference=raised, gamma=1e6, spans=18)
    assert report["after"]["rms_distance"] < 0.6 * report["before"]["rms_distance"]
    assert report["after"]["covered"] > 0.9
    away = face.translated(App.Vector(200, 0, 0))
    with pytest.raises(fairing.FairingError, match="covers nothing"):
        fairing.edit(face, 1, reference=away, gamma=1.0)


def test_a_spline_field_is_taken_over_the_patch(face):
    # Control points (x, y, 1) over a Bezier patch of degree 2 x 1.
    normals = [[0.4 * (i - 1), 0.2 * (2 * j - 1), 1.0] for i in range(3) for j in range(2)]
    _, free = fairing.edit(face, 1, guide={"field": {"degree": [2, 1], "normals": normals}})
    _, report = fairing.edit(face, 1, guide={"field": {"degree": [2, 1], "normals": normals}}, lambda_=100)
    assert report["after"]["rms_angle"] < free["after"]["rms_angle"]


def test_meshes_lie_on_the_face_also_where_it_is_trimmed(face):
    plate = Part.makePlane(SIDE, SIDE).cut(Part.makeCylinder(6, 2, App.Vector(20, 20, -1)))
    for shape, spans, size in ((face, 0, SIDE * SIDE), (plate, 24, SIDE * SIDE - math.pi * 36)):
        edit = native.Shape(shape.exportBrepToString().encode()).edit(
            1, guide=[{"point": (8, 8, 0), "normal": (0.4, 0, 1), "radius": 8}], lambda_=100, degree=3, spans=spans)
        points, normals, triangles = edit.mesh(24)
        made = Part.Shape()
        made.importBrepFromString(edit.brep().decode())
        surface = made.Faces[0].Surface
        assert max(surface.value(*surface.parameter(App.Vector(*map(float, point)))).distanceToPoint(
            App.Vector(*map(float, point))) for point in points) < 1e-4  # single precision
        assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
        sides = points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]]
        across = np.cross(*sides)
        assert np.all(np.einsum("ij,ij->i", across, normals[triangles[:, 0]]) > 0.0)  # counter-clockwise
        flat = 0.5 * np.abs(across[:, 2]).sum()  # their shadow on the plane
        assert abs(flat - size) < 0.01 * size


def test_the_base_takes_the_new_face(face):
    box = Part.makeBox(SIDE, SIDE, SIDE)
    whole, report = fairing.edit(box, 1, guide=[{"point": (0, 20, 20), "normal": (1, 0.4, 0), "radius": 15}], lambda_=100,
                                 degree=3, spans=8, result="base")
    assert whole.ShapeType == "Solid" and whole.isValid() and len(whole.Faces) == 6 and report["largest_move"] > 0.1


@pytest.mark.parametrize("guide, code, why", [
    ([{"point": (20, 20, 0), "normal": (0, 0, 0), "radius": 5}], "GuideInvalid", "its normal is zero"),
    ([{"point": (120, 20, 0), "normal": (0, 0, 1), "radius": 5}], "HandleOff", "Handle 1"),
    ({"field": {"n": 2, "m": 2, "normals": [[0, 0, 1]]}}, "GuideInvalid", "its field needs 9 normals and has 1"),
    ({"handles": []}, "GuideInvalid", 'no list called "normals"'),
])
def test_wrong_guides_are_told_in_a_sentence(face, guide, code, why):
    with pytest.raises(fairing.FairingError, match=why) as failed:
        fairing.edit(face, 1, guide=guide, lambda_=1.0)
    assert failed.value.code == code


def test_wrong_choices_are_told_in_a_sentence(face):
    for arguments, code in (({"energy": "mean-curvature-gradient"}, "UnknownChoice"), ({"keep": "G3"}, "UnknownChoice"),
                            ({"degree": 11}, "DegreeOutOfRange"), ({"spans": -1}, "SpansOutOfRange"),
                            ({"lambda_": -1.0}, "WeightNegative")):
        with pytest.raises(fairing.FairingError) as failed:
            fairing.edit(face, 1, **arguments)
        assert failed.value.code == code
    with pytest.raises(fairing.FairingError, match="no face 2"):
        fairing.edit(face, "Face2")


def test_fills_take_a_field_that_says_where_it_lies(sheet, edges):
    free, report = fairing.fill(sheet, edges[:1], energy="thin-plate")
    assert report["guidance"] is None
    corners = {}
    for edge in edges:
        for vertex in sheet.Edges[edge - 1].Vertexes:
            corners[tuple(round(c, 6) for c in vertex.Point)] = vertex.Point
    by_place = sorted(corners.values(), key=lambda p: (p.x + p.y, p.x))
    lying = dict(field(6, 6), corners=[by_place[0], max(corners.values(), key=lambda p: p.x - p.y),
                                       min(corners.values(), key=lambda p: p.x - p.y)])
    angles, centres = [], []
    for weight in (0.0, 100.0, 10000.0):
        made, report = fairing.fill(sheet, edges[:1], energy="thin-plate", layout="quad", guide={"field": lying},
                                    lambda_=weight)
        angles.append(report["guidance"]["rms_angle"])
    assert angles[0] > angles[1] > angles[2]
    for picks in (edges, edges[::-1]):
        made, report = fairing.fill(sheet, picks, energy="thin-plate", layout="quad", guide={"field": lying},
                                    lambda_=100.0)
        centres.append(made.CenterOfMass)
        assert report["guidance"]["rms_angle"] == pytest.approx(angles[1], abs=1e-6)
    with pytest.raises(fairing.FairingError, match='"corners"'):
        fairing.fill(sheet, edges[:1], guide={"field": field(6, 6)}, lambda_=1.0)
    with pytest.raises(fairing.FairingError, match="lies on one patch"):
        fairing.fill(sheet, edges[:1], layout="star", guide={"field": lying}, lambda_=1.0)


def run(*arguments):
    return subprocess.run([PROGRAM, "edit", *map(str, arguments)], capture_output=True, text=True, timeout=120)


def test_the_command_line_gives_the_same(face, tmp_path):
    face.exportBrep(str(tmp_path / "face.brep"))
    (tmp_path / "guide.json").write_text(json.dumps({"field": field(8, 8)}))
    out, report = tmp_path / "out.brep", tmp_path / "report.json"
    done = run(tmp_path / "face.brep", "-o", out, "--face", "Face1", "--guide", tmp_path / "guide.json",
               "--lambda", 50, "--gamma", 2, "--keep", "G1", "--degree", 5, "--spans", 3, "--report", report)
    assert done.returncode == 0, done.stderr
    assert "angle to the normals, rms" in done.stdout and "distance to the reference" in done.stdout
    expected, numbers = fairing.edit(face, 1, guide={"field": field(8, 8)}, lambda_=50, gamma=2, keep="G1", degree=5,
                                     spans=3)
    assert json.loads(report.read_text()) == numbers
    made = Part.Shape()
    made.read(str(out))
    assert made.Faces[0].CenterOfMass.distanceToPoint(expected.CenterOfMass) < 1e-9


@pytest.mark.parametrize("arguments, sentence", [
    (["--face", "9"], "There is no face 9"),
    (["--face", "Edge1"], '"Edge1" for --face'),
    (["--face", "1", "--keep", "G7"], '"G7" for --keep'),
    (["--face", "1", "--energy", "steam"], '"steam" for --energy'),
    (["--face", "1", "--keep", "G2"], "To keep G2 at the border of face 1"),
    (["--face", "1", "--spans", "99"], "The number of spans must be from 1 to 64"),
    (["--face", "1", "--guide", "none.json"], "none.json cannot be read."),
])
def test_the_command_line_says_what_is_wrong(tmp_path, arguments, sentence):
    Part.makePlane(10, 10).exportBrep(str(tmp_path / "face.brep"))
    done = run(tmp_path / "face.brep", "-o", tmp_path / "out.brep", *arguments)
    assert done.returncode == 2 and sentence in done.stderr
    assert not (tmp_path / "out.brep").exists()


def test_an_interrupt_ends_an_edit_with_the_latest_look(face, tmp_path):
    face.exportBrep(str(tmp_path / "face.brep"))
    handle = {"point": list(face.CenterOfMass), "normal": [0.5, 0.0, 1.0], "weight": 1.0, "radius": 10.0}
    (tmp_path / "guide.json").write_text(json.dumps({"normals": [handle]}))
    status, out, told = interrupted("edit", tmp_path / "face.brep", "-o", tmp_path / "out.brep", "--face", 1, "--spans", 40,
                                    "--lambda", 100, "--gamma", 1, "--guide", tmp_path / "guide.json")
    assert status == 0 and not told, told
    assert "Note: Stopped after looking the guide up 1 of at most 6 times" in out, out
    made = Part.Shape()
    made.read(str(tmp_path / "out.brep"))
    assert made.isValid() and len(made.Faces) == 1
