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
        found = self._find_places("Edges") if self.is_joined else {}
        self._places = {number: places[0] for number, places in found.items()}
        self._numbers = {place: number for number, places in found.items() for place in places}

    def own_shape(self, obj: App.DocumentObject) -> Part.Shape:
        """That of one object, in the container's coordinates."""
        return self._shapes[obj]

    def number(self, obj: App.DocumentObject, edge: int) -> int:
        """An edge of one object as a number of the whole shape. Raises ValueError where the object lacks it."""
        if not self.is_joined:
            return edge  # the native module checks it
        if (obj, edge) not in self._numbers:
            raise self._no_edge(obj, edge)
        return self._numbers[obj, edge]

    def vertex_number(self, obj: App.DocumentObject, vertex: int) -> int:
        """The same for a vertex."""
        if not self.is_joined:
            return vertex
        return self._number_of("Vertexes", "vertex", (obj, vertex))

    def face_number(self, obj: App.DocumentObject, face: int) -> int:
        """The same for a face."""
        if not self.is_joined:
            return face
        return self._number_of("Faces", "face", (obj, face))

    def place(self, number: int) -> Place:
        """The object that an edge of the whole shape belongs to, and the edge's number there."""
        return self._places[number] if self.is_joined else (self.objects[0], number)

    def name(self, number: int) -> str:
        """The name of an edge of the whole shape, with its object's in front where there are several."""
        obj, edge = self.place(number)
        return f"{obj.Name}.Edge{edge}" if len(self.objects) > 1 else f"Edge{edge}"

    def face_name(self, number: int) -> str:
        """The same for a face."""
        obj, face = self._find_places("Faces")[number][0] if self.is_joined else (self.objects[0], number)
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
            raise self._no_edge(obj, edge)
        return edges[edge - 1]

    def _no_edge(self, obj: App.DocumentObject, edge: int) -> ValueError:
        return ValueError(f"There is no edge {edge}: {obj.Label} has {len(self._shapes[obj].Edges)}.")

    def _number_of(self, kind: str, word: str, place: Place) -> int:
        for number, places in self._find_places(kind).items():
            if place in places:
                return number
        obj, own = place
        raise ValueError(f"There is no {word} {own}: {obj.Label} has {len(getattr(self._shapes[obj], kind))}.")

    def _find_places(self, kind: str) -> dict[int, list[Place]]:
        """Whose the whole shape's "Edges", "Vertexes" or "Faces" are: of several objects where these share them."""
        own: dict[int, list] = {}
        for obj, shape in self._shapes.items():
            for number, there in enumerate(getattr(shape, kind), 1):
                own.setdefault(there.hashCode(), []).append((there, (obj, number)))
        return {number: [place for there, place in own[part.hashCode()] if there.isSame(part)]
                for number, part in enumerate(getattr(self.shape, kind), 1)}
