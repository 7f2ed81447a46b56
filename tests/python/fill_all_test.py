# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filling all holes, directions and inner constraints from Python."""

import Part
import pytest
from FreeCAD import Vector

import fairing
from fairing import _fairing, exchange


@pytest.fixture(scope="module")
def plane():
    """A plane sheet of 5 x 3 faces without two that touch neither each other nor the rim."""
    faces = [Part.makePlane(10, 10, Vector(10 * i, 10 * j, 0))
             for i in range(5) for j in range(3) if (i, j) not in ((1, 1), (3, 1))]
    shell = Part.makeShell(faces)
    shell.sewShape()
    return shell


def test_every_hole_is_filled_and_told(plane):
    filled = exchange.native_shape(plane).fill_all()
    assert filled.within_tolerance and len(filled.holes) == 2
    for hole, loop in zip(filled.holes, exchange.native_shape(plane).holes()):
        assert hole.edges == loop and hole.error == "" and hole.fill.within_tolerance
        assert hole.fill.composition.startswith("Layout quad: 1 patch")
    assert len(filled.table.splitlines()) == 3
    holes = filled.holes
    del filled
    assert holes[0].fill.report["largest_gap"] < 1e-6, "a hole keeps alive what it belongs to"


def test_shape_and_reports_come_back(plane):
    shape, reports = fairing.fill_all(plane, result="base")
    assert shape.isValid() and abs(shape.Area - 1500) < 1e-6 and len(reports) == 2
    assert all(report["within_tolerance"] and len(report["edges"]) == 4 for report in reports)


def test_skipped_holes_stay_open(plane):
    first, second = fairing.holes(plane)
    shape, reports = fairing.fill_all(plane, skipped=[second[2]])
    assert len(shape.Faces) == 1 and reports[0]["edges"] == first
    with pytest.raises(_fairing.FairingError) as caught:
        fairing.fill_all(plane, skipped=[first[0], second[0]])
    assert caught.value.code == "NoHole"


def test_a_hole_that_fails_is_told_in_its_report(plane):
    edge = fairing.holes(plane)[0][0]
    along = plane.getElement(edge)
    shape, reports = fairing.fill_all(plane, tangents={edge: along.tangentAt(along.FirstParameter)})
    assert len(shape.Faces) == 1
    assert "runs along the edge" in reports[0]["error"] and edge in reports[0]["edges"]
    assert reports[1]["within_tolerance"]


def test_progress_counts_all_holes(plane):
    progress = _fairing.Progress()
    exchange.native_shape(plane).fill_all(progress=progress)
    assert progress.fraction == 1.0
    stopped = _fairing.Progress()
    stopped.abort()
    with pytest.raises(_fairing.FairingError) as caught:
        exchange.native_shape(plane).fill_all(progress=stopped)
    assert caught.value.code == "Cancelled"


def test_a_symmetry_plane_takes_the_place_of_a_face():
    arcs = [Part.Arc(Vector(0, y, 0), Vector(20, y, 5), Vector(40, y, 0)).toShape() for y in (0, 20)]
    lines = [Part.makeLine(Vector(x, 0, 0), Vector(x, 20, 0)) for x in (0, 40)]
    frame = Part.makeCompound(arcs + lines)
    _, report = fairing.fill(frame, [1, 2, 3, 4], symmetry={"Edge1": (0, 1, 0), 2: Vector(0, -1, 0)})
    asked = {side["edge"]: side["asked"] for side in report["sides"]}
    assert asked == {1: "G1", 2: "G1", 3: "G0", 4: "G0"} and report["within_tolerance"]


@pytest.mark.parametrize("through, code", [([(0, 0, 1e6)], "InnerConstraintOff"),
                                           ([Part.makeLine(Vector(0, 0, 1e6), Vector(0, 0, 2e6))], "InnerConstraintOff")])
def test_what_lies_too_far_off_is_refused(sheet, edges, through, code):
    with pytest.raises(_fairing.FairingError) as caught:
        fairing.fill(sheet, edges[:1], through=through)
    assert caught.value.code == code


def test_a_point_of_two_numbers_is_refused(sheet, edges):
    with pytest.raises(ValueError, match="three numbers"):
        fairing.fill(sheet, edges[:1], through=[(1, 2)])
