# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares energies as figure 10 of [MoretonSequin1992] does: which of them finds the sphere, cone or torus that a hole
was cut into, from its tangent borders alone.

    scripts/with_freecad examples/moreton_sequin_1992/compare.py

Prints, for every surface and energy, the largest distance from the true surface over the hole's diagonal, the integral
of k1^2 + k2^2, Gauss-Newton steps and seconds.
"""

import FreeCAD as App
import Part

import fairing

ENERGIES = {  # by their names in the paper
    "linearised strain energy": "thin-plate",
    "strain energy": "total-curvature",
    "(mean curvature)": "mean-curvature-gradient-minimum",
    "MVS": "minimum-variation",
}
SAMPLES = 15  # along either parameter of a patch


def sphere():
    surface = Part.Sphere()
    surface.Radius = 10.0
    return surface


def cone():
    return Part.Cone(App.Vector(0, 0, 0), App.Vector(0, 0, 20), 4.0, 12.0)


def torus():
    surface = Part.Toroid()
    surface.MajorRadius, surface.MinorRadius = 20.0, 6.0
    return surface


SURFACES = {  # with the parameters between which the hole lies, and of the border of the shape
    "sphere": (sphere(), (0.0, 0.4, 1.4, 1.8), (-0.5, -0.2, 0.8, 1.1)),
    "cone": (cone(), (0.0, 0.4, 1.6, 2.0), (2.0, 5.0, 14.0, 17.0)),
    "torus, outside": (torus(), (0.0, 0.2, 0.8, 1.0), (-0.8, -0.4, 0.8, 1.2)),
    "torus, inside": (torus(), (0.0, 0.3, 1.1, 1.4), (1.9, 2.3, 3.7, 4.1)),
}


def with_hole(surface, u: tuple, v: tuple) -> Part.Shape:
    """3 x 3 faces of a surface without the middle one, sewn."""
    cells = [(i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    faces = [surface.toShape(u[i], u[i + 1], v[j], v[j + 1]) for i, j in cells]
    shell = Part.Shell(faces)
    shell.sewShape()
    return shell


def hole_of(shape: Part.Shape) -> list:
    """The names of the edges of the hole: it is shorter than the outer border."""
    return min(fairing.holes(shape), key=lambda names: sum(shape.getElement(name).Length for name in names))


def largest_distance(patch: Part.Shape, surface) -> float:
    largest = 0.0
    for face in patch.Faces:
        u0, u1, v0, v1 = face.ParameterRange
        for i in range(SAMPLES):
            for j in range(SAMPLES):
                step_u, step_v = i / (SAMPLES - 1), j / (SAMPLES - 1)
                point = face.valueAt(u0 + (u1 - u0) * step_u, v0 + (v1 - v0) * step_v)
                foot = surface.value(*surface.parameter(point))
                largest = max(largest, (point - foot).Length)
    return largest


def main() -> None:
    print(f"{'surface':16}{'energy':28}{'distance':>10}{'k1^2 + k2^2':>14}{'steps':>7}{'seconds':>9}")
    for name, (surface, u, v) in SURFACES.items():
        shape = with_hole(surface, u, v)
        edges = hole_of(shape)
        for title, energy in ENERGIES.items():
            patch, report = fairing.fill(shape, edges, energy=energy)
            distance = largest_distance(patch, surface) / report["diagonal"]
            solve = report["solve"]
            print(f"{name:16}{title:28}{distance:10.1e}{report['fairness']['total_curvature']:14.6f}"
                  f"{len(solve['shape']['steps']):7}{solve['total_time']:9.2f}")


main()
