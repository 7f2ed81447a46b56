# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of curvature as arrays: of shapes, of fills and of edits, against the formulas of known surfaces."""

import numpy as np
import Part
import pytest

import fairing
from fairing import _fairing, exchange
from fairing.pictures import QUANTITIES


def picture_of(shape, faces=(), divisions=40):
    return exchange.native_shape(shape).curvature_picture(list(faces), divisions)


def test_a_cylinder_face_has_the_mean_curvature_of_its_radius():
    pipe = Part.makeCylinder(8, 30)
    points, triangles, mean = fairing.curvature_picture(pipe, faces=["Face1"])
    assert points.shape[1] == triangles.shape[1] == 3 and mean.shape == (len(points),)
    assert np.allclose(mean, -1.0 / 16.0, atol=1e-12)
    assert np.allclose(np.hypot(points[:, 0], points[:, 1]), 8.0, atol=1e-5)
    _, _, greatest = fairing.curvature_picture(pipe, "k1", faces=[1])
    assert np.allclose(greatest, 0.0, atol=1e-12)


def test_a_torus_has_its_formula_at_every_vertex():
    ring, tube = 20.0, 6.0
    points, _, gauss = fairing.curvature_picture(Part.makeTorus(ring, tube), "gauss")
    around = (np.hypot(points[:, 0], points[:, 1]) - ring) / tube  # the cosine of the tube's angle
    assert np.allclose(gauss, around / (tube * (ring + tube * around)), atol=1e-6)


def test_triangles_are_as_fine_as_asked():
    box = Part.makeBox(30, 40, 50)
    points, triangles, _ = fairing.curvature_picture(box, divisions=10)
    corners = points[triangles]
    longest = max(np.linalg.norm(corners[:, k] - corners[:, (k + 1) % 3], axis=1).max() for k in range(3))
    assert longest <= np.sqrt(30.0 ** 2 + 40.0 ** 2 + 50.0 ** 2) / 10.0 * (1.0 + 1e-5)


def test_a_place_is_told_exactly_with_its_face():
    sphere = Part.makeSphere(5)
    picture = picture_of(sphere)
    points, _, triangles = picture.mesh()
    place = picture.at(len(triangles) // 2, 0.3, 0.4)
    assert place["face"] == 1 and set(place["values"]) == set(QUANTITIES)
    assert place["values"]["mean"] == pytest.approx(-0.2, abs=1e-9)
    assert np.linalg.norm(place["point"]) == pytest.approx(5.0, abs=1e-9)  # on the surface, not on the triangle
    with pytest.raises(IndexError):
        picture.at(len(triangles), 0.0, 0.0)


def test_a_range_is_symmetric_but_for_the_gradient():
    picture = picture_of(Part.makeTorus(20, 6))
    low, high = picture.range("mean")
    assert low == -high and high == pytest.approx(0.5 * (1 / 6 + 1 / 26), rel=0.02)
    assert picture.range("mean-gradient")[0] == 0.0
    with pytest.raises(_fairing.FairingError):
        picture.range("warmth")


def test_a_fill_agrees_with_the_faces_it_becomes(shape, edges):
    fill = shape.fill(edges[:1])
    values = fill.curvature_picture(40).values()
    _, _, triangles = fill.curvature_picture(40).mesh()
    assert len(triangles) == 2 * 40 * 40
    faces = picture_of(exchange.part_shape(fill.brep())).values()
    assert np.percentile(values[:, 0], 50) == pytest.approx(np.percentile(faces[:, 0], 50), rel=0.05)
    assert values[:, 0].min() == pytest.approx(faces[:, 0].min(), rel=0.02)


def test_a_trimmed_fill_is_drawn_within_its_border(shape, edges):
    fill = shape.fill(edges[:1], layout="trimmed")
    points, normals, triangles = fill.curvature_picture(32).mesh()
    corners = points[triangles].astype(float)
    area = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
    assert area == pytest.approx(fill.report["fairness"]["area"], rel=5e-3)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)


def test_normals_of_a_fill_and_its_neighbours_point_the_same_way(shape, edges):
    """So do the colours of a signed quantity, and stripes run on."""
    fill = shape.fill(edges[:1])
    side = next(side for side in fill.report["sides"] if side["face"])
    beside = shape.curvature_picture([side["face"]])
    mine, theirs = fill.curvature_picture().mesh(), beside.mesh()
    middle = np.array(side["gap"]["where"])
    nearest = [mesh[1][np.argmin(np.linalg.norm(mesh[0] - middle, axis=1))] for mesh in (mine, theirs)]
    assert nearest[0] @ nearest[1] > 0.9


def test_an_edit_has_its_picture_too():
    box = Part.makeBox(20, 20, 20)
    native = exchange.native_shape(box)
    edit = native.edit(1, spans=4, degree=3)
    assert np.abs(edit.curvature_picture(16).values()[:, :4]).max() < 1e-9  # a plane stays one


def test_faces_that_are_not_there_are_named():
    with pytest.raises(_fairing.FairingError) as caught:
        fairing.curvature_picture(Part.makeBox(1, 1, 1), faces=["Face9"])
    assert (caught.value.code, caught.value.face) == ("FaceOutOfRange", 9)
    with pytest.raises(ValueError):
        fairing.curvature_picture(Part.makeBox(1, 1, 1), "warmth")
