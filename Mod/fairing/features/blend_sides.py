# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a blend, which may lie on two objects, as edges of one shape."""

from __future__ import annotations

import dataclasses
from typing import Any, Mapping, Optional

import FreeCAD as App
import Part

from .. import subelements
from ..blend_request import BlendRequest
from .links import link_of
from .placement import shape_in

NO_SIDE = "A side of the blend has no edge: pick an edge on either side."


@dataclasses.dataclass(frozen=True)
class Side:
    """Edges of one object, and those of its edges that are met in another way than the rest, {"Edge7": "G0"}."""

    base: App.DocumentObject
    edges: tuple[int, ...]
    wishes: dict[int, str]

    @staticmethod
    def of(given, wishes: Optional[Mapping[Any, str]] = None) -> "Side":
        """From a link, (object, ["Edge7"]). Raises ValueError where it is none, or names what is no edge."""
        link = link_of(given)
        if link is None or not link[1]:
            raise ValueError(NO_SIDE)
        wishes = {subelements.only_edges(edge)[0]: word for edge, word in (wishes or {}).items()}
        return Side(link[0], subelements.only_edges(link[1]), wishes)

    def link(self):
        return self.base, [f"Edge{edge}" for edge in self.edges]

    def lines(self) -> list[str]:
        return [f"Edge{edge}={word}" for edge, word in sorted(self.wishes.items())]


class BlendSides:
    """One shape that holds the objects of both sides, in a container's coordinates, and whose edge is whose in it."""

    def __init__(self, from_side: Side, to_side: Side, container):
        self.from_side, self.to_side = from_side, to_side
        self._objects = [from_side.base] + ([to_side.base] if to_side.base is not from_side.base else [])
        self._shapes = [shape_in(container, obj) for obj in self._objects]
        self.shape = self._shapes[0] if len(self._shapes) == 1 else self._joined()

    def request(self, **choices) -> BlendRequest:
        """What is asked of the whole shape. Raises ValueError where an object has no edge of that number."""
        wishes = {self.number(side.base, edge): word for side in (self.from_side, self.to_side)
                  for edge, word in side.wishes.items()}
        return BlendRequest.of(self._numbers(self.from_side), self._numbers(self.to_side), wishes, **choices)

    def place(self, number: int) -> tuple[App.DocumentObject, str]:
        """The object that an edge of the whole shape belongs to, and the edge's name there."""
        if len(self._shapes) == 1:
            return self._objects[0], f"Edge{number}"
        edge = self.shape.Edges[number - 1]
        return next((obj, f"Edge{own}") for obj, shape in zip(self._objects, self._shapes)
                    for own, other in enumerate(shape.Edges, 1) if other.isSame(edge))

    def name(self, number: int) -> str:
        """The name of an edge of the whole shape, with its object's in front where there are two."""
        obj, name = self.place(number)
        return name if len(self._shapes) == 1 else f"{obj.Name}.{name}"

    def faces_beside(self, obj: App.DocumentObject, edge: int) -> list[int]:
        """The numbers of the faces of one object that have this edge of it."""
        shape = self._shapes[self._objects.index(obj)]
        beside = shape.ancestorsOfType(shape.Edges[edge - 1], Part.Face)
        return [number for number, face in enumerate(shape.Faces, 1) if any(face.isSame(other) for other in beside)]

    def _joined(self) -> Part.Shape:
        for obj, shape in zip(self._objects, self._shapes):
            if shape.isNull():
                raise ValueError(f"{obj.Label} has no shape.")
        return Part.Compound(self._shapes)

    def _numbers(self, side: Side) -> list[int]:
        return [self.number(side.base, edge) for edge in side.edges]

    def number(self, obj: App.DocumentObject, edge: int) -> int:
        """An edge of one object as a number of the whole shape. Raises ValueError where the object lacks it."""
        if len(self._shapes) == 1:
            return edge  # the native module checks it
        edges = self._shapes[self._objects.index(obj)].Edges
        if not 1 <= edge <= len(edges):
            raise ValueError(f"There is no edge {edge}: {obj.Label} has {len(edges)}.")
        return next(n for n, other in enumerate(self.shape.Edges, 1) if other.isSame(edges[edge - 1]))
