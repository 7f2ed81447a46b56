# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where curvature pictures look up their colours: the law of reflection, and ranges."""

import numpy as np
import pytest

from fairing.panels import picture_colors as colors

UP, BACK = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
PARALLEL = colors.Camera(UP, BACK, None)


def leaning(degrees):
    """A normal that leans up from the line of sight."""
    angle = np.radians(degrees)
    return np.array([[0.0, np.sin(angle), np.cos(angle)]])


def stripe(normals, camera=PARALLEL, points=None, stripes=36):
    points = np.zeros_like(normals) if points is None else points
    return colors.stripes_at(points, normals, camera, stripes)[:, 0]


@pytest.mark.parametrize("degrees", [-40.0, -7.0, 0.0, 12.5, 60.0])
def test_a_mirror_that_leans_shows_a_line_twice_as_far_round(degrees):
    assert stripe(leaning(degrees)) == pytest.approx(36 * 2.0 * degrees / 360.0, abs=1e-5)


def test_leaning_sideways_alone_shows_the_same_line():
    angle = np.radians(20.0)
    assert stripe(np.array([[np.sin(angle), 0.0, np.cos(angle)]])) == pytest.approx(0.0, abs=1e-6)


def test_stripes_do_not_depend_on_the_side_a_normal_points_to():
    normals = np.random.default_rng(0).normal(size=(50, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    assert np.allclose(stripe(normals), stripe(-normals), atol=1e-5)


def test_a_perspective_camera_far_off_sees_what_a_parallel_one_does():
    normals, points = np.repeat(leaning(25.0), 3, axis=0), np.array([[0.0, 0, 0], [5, 5, 0], [-5, 2, 1]])
    far = colors.Camera(UP, BACK, np.array([0.0, 0.0, 1e6]))
    assert np.allclose(stripe(normals, far, points), stripe(normals), atol=1e-3)
    near = colors.Camera(UP, BACK, np.array([0.0, 0.0, 20.0]))
    plane = stripe(np.repeat(leaning(0.0), 3, axis=0), near, points)
    assert plane[0] == pytest.approx(0.0, abs=1e-6) and plane[1] > plane[2] > 0.1, "a plane has stripes, too"


def test_values_are_looked_up_between_the_ends_of_a_range():
    places = colors.places_in(np.array([-2.0, -1.0, 0.0, 1.0, 7.0, np.nan]), -1.0, 1.0)
    ends = 0.5 / colors.STEPS, 1.0 - 0.5 / colors.STEPS
    assert places[:5, 0] == pytest.approx([ends[0], ends[0], 0.5, ends[1], ends[1]])
    assert np.all(places[:5, 1] == 0.25) and places[5, 1] == 0.75
    image = colors.scale_image(True)
    assert image.shape == (2, colors.STEPS, 3) and tuple(image[1, 0]) == colors.UNKNOWN


def test_a_signed_scale_is_blue_below_pale_at_nought_and_red_above():
    low, middle, high = colors.scale(True)[[0, colors.STEPS // 2, -1]].astype(int)
    assert low[2] > 2 * low[0] and high[0] > 2 * high[2] and middle.min() > 220


def test_a_stripe_is_half_dark_and_half_light():
    line = colors.zebra_image()[0, :, 0].astype(float)
    assert line.mean() == pytest.approx(0.5 * (colors.DARK + colors.LIGHT), abs=2.0)
    assert line[0] == line[-1] == colors.LIGHT and line[colors.STEPS // 2] == colors.DARK
