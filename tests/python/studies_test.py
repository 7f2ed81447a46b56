# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples that make the studies of papers again: what they draw and compute with."""

import os
import struct
import sys

import pytest

import fairing

EXAMPLES = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "examples")
sys.path[:0] = [EXAMPLES, *(os.path.join(EXAMPLES, name) for name in ("kiciak_2011", "moreton_sequin_1992"))]
import cube  # noqa: E402
import nets  # noqa: E402
import painting  # noqa: E402
import patches  # noqa: E402


def test_halved_spans_are_the_same_patch():
    points = nets.net_of(nets.SURFACES["saddle"], 4)
    rows = [points[i * 10:(i + 1) * 10] for i in range(10)]
    finer = patches.halved(rows)
    assert len(finer) == len(finer[0]) == 2 * (10 - 3) + 3
    for line, other in zip(patches.grid(rows, 9), patches.grid(finer, 9)):
        for (point, normal), (same, upright) in zip(line, other):
            assert point == pytest.approx(same, abs=1e-14) and normal == pytest.approx(upright, abs=1e-12)


def test_the_nearer_surface_is_painted(tmp_path):
    canvas = painting.Canvas(8, 4)

    def square(depth, value, right):
        return [[(x, y, depth, value) for x in (-1.0, right)] for y in (-1.0, 5.0)]
    canvas.draw(square(1.0, 10.0, 4.2))
    canvas.draw(square(0.0, 20.0, 6.2))
    across = canvas.values[:canvas.width]
    assert across[0] == 10.0 and across[10] == 20.0 and across[-1] is None
    canvas.write(str(tmp_path / "picture.png"), lambda value: (255, 0, 0))
    data = (tmp_path / "picture.png").read_bytes()
    assert data.startswith(b"\x89PNG") and struct.unpack(">II", data[16:24]) == (8, 4)


def test_minimum_variation_through_the_corners_of_a_cube_is_a_sphere():
    arcs, planes = cube.side()
    faces, report = fairing.fill(arcs, list(planes), symmetry=planes, energy="minimum-variation", layout="quad")
    assert report["within_tolerance"]
    for line in cube.measured(faces.Faces[0].Surface):
        for point, gauss, mean in line:
            assert point.Length == pytest.approx(1.0, abs=1e-6)
            assert gauss == pytest.approx(1.0, abs=2e-3) and mean == pytest.approx(1.0, abs=1e-3)
