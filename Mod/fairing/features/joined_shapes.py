# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of several objects as one, and which edge or vertex of it is whose."""

from __future__ import annotations

from typing import Iterable

import FreeCAD as App
import Part

from .placement import shape_in

Place = tuple[App.DocumentObject, int]  # an edge, or a vertex, by its number in an object


class JoinedShapes:
    """One shape that holds the shapes of objects, in a container's coordinates; that of a lone object as it is.

    Of other objects it may hold single edges.
    """

    def __init__(self, objects: Iterable[App.DocumentObject], container, edges: Iterable[Place] = ()):
        self.objects = list(dict.fromkeys(objects))
        single = [place for place in dict.fromkeys(edges) if place[0] not in self.objects]
        self._shapes = {obj: shape_in(container, obj) for obj in self.objects + [obj for obj, _ in single]}
        for obj, shape in self._shapes.items():
            if shape.isNull():
                raise ValueError(f"{obj.Label} has no shape.")
        parts = [self._shapes[obj] for obj in self.objects] + [self._single(*place) for place in single]
        self.is_joined = len(parts) > 1
        self.shape = Part.Compound(parts) if self.is_joined else parts[0]
        self._known: dict[str, tuple[dict, dict]] = {}

    def own_shape(self, obj: App.DocumentObject) -> Part.Shape:
        """That of one object, in the container's coordinates."""
        return self._shapes[obj]

    def number(self, obj: App.DocumentObject, edge: int) -> int:
        """An edge of one object as a number of the whole shape. Raises ValueError where the object lacks it."""
        return self._number("Edges", "edge", (obj, edge))

    def vertex_number(self, obj: App.DocumentObject, vertex: int) -> int:
        """The same for a vertex."""
        return self._number("Vertexes", "vertex", (obj, vertex))

    def face_number(self, obj: App.DocumentObject, face: int) -> int:
        """The same for a face."""
        return self._number("Faces", "face", (obj, face))

    def place(self, number: int) -> Place:
        """The object that an edge of the whole shape belongs to, and the edge's number there."""
        return self._place("Edges", number)

    def name(self, number: int) -> str:
        """The name of an edge of the whole shape, with its object's in front where there are several."""
        obj, edge = self.place(number)
        return f"{obj.Name}.Edge{edge}" if len(self.objects) > 1 else f"Edge{edge}"

    def face_name(self, number: int) -> str:
        """The same for a face."""
        obj, face = self._place("Faces", number)
        return f"{obj.Name}.Face{face}" if len(self.objects) > 1 else f"Face{face}"

    def faces_beside(self, number: int) -> list[int]:
        """The numbers, in their own object, of the faces that have an edge of the whole shape."""
        obj, edge = self.place(number)
        shape = self._shapes[obj]
        beside = shape.ancestorsOfType(shape.Edges[edge - 1], Part.Face)
        return [number for number, face in enumerate(shape.Faces, 1) if any(face.isSame(other) for other in beside)]

    def _single(self, obj: App.DocumentObject, edge: int) -> Part.Shape:
        edges = self._shapes[obj].Edges
        if not 1 <= edge <= len(edges):
            raise self._none("Edges", "edge", (obj, edge))
        return edges[edge - 1]

    def _none(self, kind: str, word: str, place: Place) -> ValueError:
        obj, own = place
        return ValueError(f"There is no {word} {own}: {obj.Label} has {len(getattr(self._shapes[obj], kind))}.")

    def _number(self, kind: str, word: str, place: Place) -> int:
        if not self.is_joined:
            return place[1]  # the native module checks it
        numbers = self._find(kind)[1]
        if place not in numbers:
            raise self._none(kind, word, place)
        return numbers[place]

    def _place(self, kind: str, number: int) -> Place:
        return self._find(kind)[0][number] if self.is_joined else (self.objects[0], number)

    def _find(self, kind: str) -> tuple[dict[int, Place], dict[Place, int]]:
        """Whose the whole shape's "Edges", "Vertexes" or "Faces" are, by their numbers, and the numbers by that; where
        objects share one the first of them has it. Looked up once a kind."""
        if kind not in self._known:
            own: dict[int, list] = {}
            for obj, shape in self._shapes.items():
                for number, there in enumerate(getattr(shape, kind), 1):
                    own.setdefault(there.hashCode(), []).append((there, (obj, number)))
            found = {number: [place for there, place in own[part.hashCode()] if there.isSame(part)]
                     for number, part in enumerate(getattr(self.shape, kind), 1)}
            self._known[kind] = ({number: places[0] for number, places in found.items()},
                                 {place: number for number, places in found.items() for place in places})
        return self._known[kind]
