# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input: a FairingError with its code, the edge and one sentence each."""

import math

import Part
import pytest

from fairing import _fairing, exchange


@pytest.mark.parametrize("options, code", [
    ({"tolerance": 0.0}, "ToleranceNotPositive"),
    ({"tolerance": -1e-3}, "ToleranceNotPositive"),
    ({"tolerance": math.nan}, "ToleranceNotPositive"),
    ({"angle": 0.0}, "AngleNotPositive"),
    ({"angle": math.nan}, "AngleNotPositive"),
    ({"lambda_": -1.0}, "WeightNegative"),
    ({"lambda_": math.nan}, "WeightNegative"),
    ({"gamma": -1.0}, "WeightNegative"),
    ({"gamma": math.nan}, "WeightNegative"),
    ({"degree": 2}, "DegreeTooLow"),
    ({"degree": 2, "energy": "thin-plate"}, "DegreeOutOfRange"),
    ({"energy": "soap"}, "UnknownChoice"),
    ({"continuity": "G7"}, "UnknownChoice"),
    ({"result": "everything"}, "UnknownChoice"),
    ({"edge_continuity": {1: "G0"}}, "EdgeNotInLoop"),
])
def test_options_that_make_no_sense(shape, edges, options, code):
    with pytest.raises(_fairing.FairingError) as caught:
        shape.fill(edges[:1], **options)
    assert caught.value.code == code
    assert_one_sentence(caught.value)


def test_edge_out_of_range_names_the_edge(shape):
    with pytest.raises(_fairing.FairingError) as caught:
        shape.fill([99])
    assert (caught.value.code, caught.value.edge, caught.value.value) == ("EdgeOutOfRange", 99, 24)
    assert_one_sentence(caught.value)


def test_edges_of_two_loops(shape, edges):
    rim = next(loop for loop in shape.holes(outer_borders=True) if set(loop) != set(edges))
    assert_fails_with("SeveralLoops", shape, [edges[0], rim[0]])


def test_a_layout_that_does_not_suit_the_corners():
    triangle = exchange.native_shape(Part.makePolygon([(0, 0, 0), (10, 0, 0), (3, 8, 2), (0, 0, 0)]))
    with pytest.raises(_fairing.FairingError) as caught:
        triangle.fill([1, 2, 3], layout="quad")
    assert (caught.value.code, caught.value.value) == ("WrongSideCount", 3)
    assert_one_sentence(caught.value)


def test_too_many_sides():
    corners = [(100 * math.cos(2 * math.pi * i / 65), 100 * math.sin(2 * math.pi * i / 65), 0) for i in range(65)]
    polygon = exchange.native_shape(Part.makePolygon(corners + corners[:1]))
    assert_fails_with("TooManySides", polygon, list(range(1, 66)))


def test_an_edge_of_a_closed_solid():
    box = exchange.native_shape(Part.makeBox(10, 10, 10))
    assert_fails_with("EdgeNotFree", box, [1])
    assert_fails_with("NothingPicked", box, [])


def test_a_loop_that_does_not_close():
    wire = Part.makePolygon([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0.5, 0)])
    error = assert_fails_with("LoopNotClosed", exchange.native_shape(wire), [1, 2, 3, 4])
    assert error.value == pytest.approx(0.5) and error.where is not None


@pytest.mark.parametrize("data", [b"", b"no shape at all", bytes(range(256)) * 20],
                         ids=["empty", "text", "binary"])
def test_bytes_that_are_no_shape(data):
    with pytest.raises(_fairing.FairingError) as caught:
        _fairing.Shape(data)
    assert_one_sentence(caught.value)


def test_errors_are_value_errors():
    assert issubclass(_fairing.FairingError, ValueError)


def assert_fails_with(code, shape, picks):
    with pytest.raises(_fairing.FairingError) as caught:
        shape.fill(picks)
    assert caught.value.code == code, caught.value
    assert_one_sentence(caught.value)
    return caught.value


def assert_one_sentence(error):
    text = str(error)
    assert text and "\n" not in text and text.endswith(".") and text[0].isupper()
