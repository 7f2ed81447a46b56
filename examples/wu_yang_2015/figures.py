# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of [WuYang2015], made again with input of our own (data.py): solves them all and prints a table a figure.

    scripts/with_freecad examples/wu_yang_2015/figures.py
"""

import os
import sys

import Part

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import data  # noqa: E402

import fairing  # noqa: E402


class Figure:
    """The pictures of one figure, in the paper's order, and the line of its table that belongs to each."""

    HEAD = (f"{'':32}{'lambda':>8}{'gamma':>7}{'energy':>10}{'rms angle':>11}{'largest':>9}{'rms to S':>10}"
            f"{'border moved':>14}")

    def __init__(self, title: str):
        self.title, self.lines, self.shapes = title, [], []

    def start(self, name: str, surface, field=None):
        """The surface a row of pictures starts from, and the normals drawn on it."""
        self.surface, self.field = surface, field
        self.shapes.append((name, surface.toShape(), field, []))

    def edit(self, name: str, lambda_: float, gamma: float = 0.0, beside=(), **options) -> Part.Shape:
        """The surface edited; the row measures the angle to the field even where it has no weight."""
        guide = {"field": self.field} if self.field else ()
        shape, report = fairing.edit(self.surface.toShape(), 1, guide=guide, lambda_=lambda_, gamma=gamma, **options)
        self.tell(name, lambda_, gamma, report["energy"], report["after"], report["border_move"])
        self.shapes.append((name, shape, None, list(beside)))
        return shape

    def tell(self, name, lambda_, gamma, energy, after, border):
        self.lines.append(f"{name:32}{lambda_:8g}{gamma:7g}{energy:10.1f}{after['rms_angle']:11.2f}"
                          f"{after['largest_angle']:9.2f}{after['rms_distance']:10.3f}{border:14.1e}")

    def print(self):
        print(self.title)
        print(self.HEAD)
        print("\n".join(self.lines) + "\n")


def figure_1() -> Figure:
    figure = Figure("Figure 1: membrane, bi-quintic patch, polynomial normal fields")
    for degree, field, weights in (("8 x 8", data.field_of_two_humps(), ((10, 0), (50, 0), (10, 200))),
                                   ("5 x 5", data.field_of_a_hollow(), ((10, 0), (50, 0), (10, 100)))):
        figure.start(f"initial, field {degree}", data.arch(), field)
        for lambda_, gamma in weights:
            figure.edit(f"field of degree {degree}", lambda_, gamma, energy="membrane")
    return figure


def _discrete(title: str, field: dict) -> Figure:
    figure = Figure(title)
    figure.start("initial", data.wavy_edge(), field)
    figure.edit("Dirichlet surface", 0, energy="membrane")
    for lambda_ in (1, 10, 50):
        figure.edit("extended membrane", lambda_, energy="membrane")
    return figure


def figure_2() -> Figure:
    return _discrete("Figure 2: membrane, degree 8 x 8, discrete normals of a hat with a flat top",
                     data.hat_with_a_flat_top())


def figure_3() -> Figure:
    return _discrete("Figure 3: the same patch, discrete normals of a ridge beside a valley", data.ridge_and_valley())


def figure_4() -> Figure:
    """The paper's way, the two outer rows given in advance; and fill(), which finds them itself."""
    figure = Figure("Figure 4: thin plate, a hole filled by a patch of degree 7 x 7, S = the true surface")
    true, around = data.truth(), [surface.toShape() for surface in data.around_the_hole()]
    field = data.true_field(true, 20, 20)
    figure.start("true surface", true, field)
    figure.shapes[-1] = ("true surface", true.toShape(), None, around)
    figure.surface = data.patch(data.level(data.base_height, 7, 7))
    for name, lambda_ in (("outer rows given: thin plate", 0), ("outer rows given: guided", 500)):
        shape = figure.edit(name, lambda_, beside=around, keep="G1")
        figure.lines[-1] += f"   {distance(shape, true):.3f} mm rms from the true surface"
    shell = Part.makeShell(around)
    shell.sewShape()
    corners = [true.value(0, 0), true.value(1, 0), true.value(0, 1)]
    for name, lambda_ in (("fill(): thin plate", 0), ("fill(): guided", 500)):
        shape, report = fairing.fill(shell, hole_of(shell), energy="thin-plate", layout="quad", degree=7,
                                     guide={"field": dict(field, corners=corners)}, lambda_=lambda_)
        figure.tell(name, lambda_, 0, report["solve"]["energy"], report["guidance"], report["largest_gap"])
        figure.lines[-1] += f"   {distance(shape, true):.3f} mm rms from the true surface"
        figure.shapes.append((name, shape, None, around))
    return figure


def figure_5() -> Figure:
    figure = Figure("Figure 5: thin plate, bi-quintic transition surfaces")
    for name, profile, drop, lambda_ in (("ridge", data.roof_height, 20.0, 5), ("step", data.step_height, 0.0, 500)):
        sheets = [data.sheet(profile, side, drop).toShape() for side in (-1, 1)]
        figure.start(f"{name}: initial", data.transition(profile, drop), data.feature_field(profile, drop))
        figure.shapes[-1] = figure.shapes[-1][:3] + (sheets,)
        figure.edit(f"{name}: thin plate", 0, beside=sheets)
        figure.edit(f"{name}: guided", lambda_, beside=sheets)
    return figure


def hole_of(shell) -> list:
    """One edge of the hole: the free edge nearest to its middle."""
    middle = Part.Vertex(data.truth().value(0.5, 0.5))
    free = [k for k, edge in enumerate(shell.Edges, 1) if len(shell.ancestorsOfType(edge, Part.Face)) == 1]
    return [min(free, key=lambda k: shell.Edges[k - 1].distToShape(middle)[0])]


def distance(shape, true) -> float:
    """Root mean square distance of a face from a surface, on a grid of its parameters."""
    surface = shape.Faces[0].Surface
    u0, u1, v0, v1 = surface.bounds()
    squares = []
    for i in range(1, 20):
        for j in range(1, 20):
            point = surface.value(u0 + (u1 - u0) * i / 20, v0 + (v1 - v0) * j / 20)
            squares.append(point.distanceToPoint(true.value(*true.parameter(point))) ** 2)
    return (sum(squares) / len(squares)) ** 0.5


FIGURES = figure_1, figure_2, figure_3, figure_4, figure_5

if __name__ == "__main__":
    for make in FIGURES:
        make().print()
