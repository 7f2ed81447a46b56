# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure 10 of [MoretonSequin1992] on its own data: surfaces through the eight corners of a cube.

    scripts/with_freecad --output DIR examples/moreton_sequin_1992/cube.py

By symmetry the minimum variation curves between the corners are arcs of great circles, and the surface is perpendicular
to the planes they lie in: each of the six sides is a hole with these four edges. Prints a table of radii and curvatures,
1 everywhere on the sphere, and writes moreton_sequin_figure_10.png into DIR: the Gaussian curvature on the surfaces in
the table's order, grey where it is the sphere's, red where it is half as much again, blue where it is half.
"""

import math
import os
import sys

import FreeCAD as App
import Part

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

import painting  # noqa: E402

import fairing  # noqa: E402

RADIUS = 10.0
# By their names in the paper. G1 alone leaves a surface open: there the membrane chooses.
ENERGIES = {
    "G1": "membrane",
    "linearised strain energy": "thin-plate",
    "strain energy": "total-curvature",
    "MVS": "minimum-variation",
}
CELLS, TILE, TURN, TILT = 40, 300, 25.0, 30.0  # of a side; pixels; degrees
SCALE = 0.42 * TILE / RADIUS
RANGE = 0.5  # of the Gaussian curvature about 1, in the picture


def corner(*signs) -> App.Vector:
    return App.Vector(*signs) * (RADIUS / math.sqrt(3.0))


def side():
    """The upper side of the cube: four arcs, and the normals of the planes through the middle that they lie in."""
    corners = [corner(-1, -1, 1), corner(1, -1, 1), corner(1, 1, 1), corner(-1, 1, 1)]
    arcs, planes = [], {}
    for number, (start, end) in enumerate(zip(corners, corners[1:] + corners[:1]), 1):
        middle = (start + end).normalize() * RADIUS
        arcs.append(Part.Arc(start, middle, end).toShape())
        planes[f"Edge{number}"] = tuple(start.cross(end).normalize())
    return Part.Compound(arcs), planes


def measured(surface) -> list:
    """A grid of (point, Gaussian, mean curvature) of a patch, of a sphere of radius 1."""
    u0, u1, v0, v1 = surface.bounds()
    grid = []
    for i in range(CELLS + 1):
        grid.append([])
        for j in range(CELLS + 1):
            u, v = u0 + (u1 - u0) * i / CELLS, v0 + (v1 - v0) * j / CELLS
            grid[-1].append((surface.value(u, v) * (1.0 / RADIUS), surface.curvature(u, v, "Gauss") * RADIUS ** 2,
                             abs(surface.curvature(u, v, "Mean")) * RADIUS))
    return grid


def turns() -> list:
    """The rotations that take the upper side to all six."""
    x, y = App.Vector(1, 0, 0), App.Vector(0, 1, 0)
    return [App.Rotation(axis, angle) for axis, angle in ((x, 0), (x, 90), (x, 180), (x, 270), (y, 90), (y, 270))]


def place(point, value, column: int):
    x, y, depth = painting.seen(tuple(point * RADIUS), TURN, TILT)
    return TILE * (column + 0.5) + SCALE * x, 0.5 * TILE - SCALE * y, depth, value


def span(values) -> str:
    return f"{min(values):9.4f} to {max(values):.4f}"


def main() -> None:
    print(f"{'':28}{'radius':>19}{'mean curvature':>20}{'Gaussian':>20}{'steps':>7}{'seconds':>9}")
    arcs, planes = side()
    canvas = painting.Canvas(len(ENERGIES) * TILE, TILE)
    for column, (title, energy) in enumerate(ENERGIES.items()):
        patch, report = fairing.fill(arcs, list(planes), symmetry=planes, energy=energy, layout="quad")
        grid = measured(patch.Faces[0].Surface)
        told = [sample for line in grid for sample in line]
        solve = report["solve"]
        steps = len(solve["shape"]["steps"]) if solve.get("shape") else 0
        print(f"{title:28}{span([point.Length for point, _, _ in told])}{span([mean for _, _, mean in told])}"
              f"{span([gauss for _, gauss, _ in told])}{steps:7}{solve['total_time']:9.2f}")
        for turn in turns():
            canvas.draw([[place(turn.multVec(point), gauss, column) for point, gauss, _ in line] for line in grid])
    canvas.write(os.path.join(os.environ["FAIRING_OUTPUT"], "moreton_sequin_figure_10.png"),
                 lambda gauss: painting.heat((gauss - 1.0) / RANGE))


if __name__ == "__main__":
    main()
