# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests inside FreeCAD share: the example, geometry to assert, documents on disk."""

import inspect
import os
import sys
import tempfile
import traceback

import FreeCAD as App
import Part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "examples", "four_sided_hole"))

import make_example  # noqa: E402

ANGLE_TOLERANCE = 0.02  # degrees, Fairing's default
SAMPLES = 23  # along an edge; not a number the solver uses


def example(name="Example"):
    """A new document with the example's sheet, and the names of the edges round its hole."""
    document = make_example.make_document(name)
    return document, document.Base, make_example.hole_edges(document.Base.Shape)


def sheet_with_four_holes():
    """The example's sheet cut into 5 x 5 faces, four of them left out that touch neither each other nor the rim."""
    faces = []
    for i in range(5):
        for j in range(5):
            if i % 2 == 0 or j % 2 == 0:
                piece = make_example.sheet()
                piece.segment(i / 5, (i + 1) / 5, j / 5, (j + 1) / 5)
                faces.append(piece.toShape())
    shell = Part.makeShell(faces)
    shell.sewShape()
    return shell


def four_holes(name="Holes"):
    """A new document with that sheet."""
    document = App.newDocument(name)
    base = document.addObject("Part::Feature", "Base")
    base.Shape = sheet_with_four_holes()
    document.recompute()
    return document, base


def fairing_holes(base):
    import fairing

    return fairing.holes(base.Shape)


def free_edges(shape):
    return [edge for edge in shape.Edges if len(shape.ancestorsOfType(edge, Part.Face)) == 1]


def hole_diagonal(base, edges):
    return Part.Compound([base.Shape.getElement(name) for name in edges]).BoundBox.DiagonalLength


def largest_gap(shape, base, edges):
    """Largest distance of points of the hole's edges from the surface of a face, mm: not from its border, which a
    kernel may have made a copy of the edges."""
    return max(_foot(face, point)[0] for face in shape.Faces for name in edges
               for point in base.Shape.getElement(name).discretize(SAMPLES))


def largest_angle(shape, base, edges):
    """Largest angle between a face and the base's faces along the hole's edges, degrees, whatever way they face."""
    largest = 0.0
    for name in edges:
        edge = base.Shape.getElement(name)
        neighbour = base.Shape.ancestorsOfType(edge, Part.Face)[0]
        for point in edge.discretize(SAMPLES):
            ours, theirs = _normal(shape.Faces[0], point), _normal(neighbour, point)
            angle = App.Units.Quantity(ours.getAngle(theirs), "rad").getValueAs("deg").Value
            largest = max(largest, min(angle, 180.0 - angle))
    return largest


def is_filled(obj, base, edges):
    """Asserts that a fill is one valid face that closes the hole tangentially, measured here."""
    assert obj.State == ["Up-to-date"], obj.State
    assert obj.Shape.isValid() and len(obj.Shape.Faces) == 1, obj.Shape.ShapeType
    gap, angle = largest_gap(obj.Shape, base, edges), largest_angle(obj.Shape, base, edges)
    assert gap <= 1e-6 * hole_diagonal(base, edges), f"gap {gap} mm"
    assert angle <= ANGLE_TOLERANCE, f"angle {angle} degrees"
    assert obj.WithinTolerance and obj.LargestAngle.Value <= ANGLE_TOLERANCE, obj.Verdict


def saved(document):
    """Saves a document under a new name and returns the path."""
    path = os.path.join(tempfile.mkdtemp(), document.Name + ".FCStd")
    document.saveAs(path)
    return path


def face_where(obj, holds):
    """The name of the first face of an object that something holds of."""
    return next(f"Face{number}" for number, face in enumerate(obj.Shape.Faces, 1) if holds(face))


def refused(action):
    """The sentence of the ValueError an action fails with."""
    try:
        action()
    except ValueError as error:
        return str(error)
    raise AssertionError("ValueError expected")


def run_all(names):
    """Calls every function defined by a test script, each on its own; the process ends with 1 where one fails."""
    failed = 0
    for name, test in list(names.items()):
        if inspect.isfunction(test) and test.__module__ == "__main__" and not inspect.signature(test).parameters:
            try:
                test()
                print(f"passed  {name}")
            except Exception:
                failed += 1
                print(f"FAILED  {name}\n{traceback.format_exc()}")
            for document in list(App.listDocuments()):
                App.closeDocument(document)
    sys.exit(1 if failed else 0)


def _foot(face, point):
    """(distance, u, v) of the nearest point on the surface below a face."""
    u, v = face.Surface.parameter(point)
    return face.Surface.value(u, v).distanceToPoint(point), u, v


def _normal(face, point):
    _, u, v = _foot(face, point)
    return face.Surface.normal(u, v)
