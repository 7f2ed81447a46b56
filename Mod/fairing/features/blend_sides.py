# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a blend, whose edges may lie on several objects, as edges of one shape."""

from __future__ import annotations

import dataclasses
from typing import Any, Mapping, Optional

import FreeCAD as App

from .. import subelements
from ..blend_request import BlendRequest
from .joined_shapes import Edge, JoinedShapes
from .links import Link, links_of

NO_SIDE = "A side of the blend has no edge: pick an edge on either side."


@dataclasses.dataclass(frozen=True)
class Side:
    """Picked edges, and those that are met in another way than the rest, {(object, 7): "G0"}."""

    edges: tuple[Edge, ...]
    wishes: Mapping[Edge, str] = dataclasses.field(default_factory=dict)

    @staticmethod
    def of(given, wishes: Optional[Mapping[Any, str]] = None) -> "Side":
        """From a link, (object, ["Edge7"]), or a list of links; wishes by "Edge7", or by "Pipe.Edge7" where there are
        several objects. Raises ValueError where there is no edge, or something else is named."""
        edges = tuple((obj, edge) for obj, names in side_links(given) for edge in subelements.only_edges(names))
        if not edges:
            raise ValueError(NO_SIDE)
        side = Side(edges)
        return dataclasses.replace(side, wishes={side._edge_of(name): word for name, word in (wishes or {}).items()})

    @property
    def objects(self) -> list[App.DocumentObject]:
        return list(dict.fromkeys(obj for obj, _ in self.edges))

    def links(self) -> list[Link]:
        return [(obj, [f"Edge{edge}" for base, edge in self.edges if base is obj]) for obj in self.objects]

    def named_wishes(self) -> dict[str, str]:
        """The wishes as scripts give them, in the order of their edges' numbers."""
        ordered = sorted(self.wishes.items(), key=lambda item: (self.objects.index(item[0][0]), item[0][1]))
        return {self._name_of(edge): word for edge, word in ordered}

    def lines(self) -> list[str]:
        return [f"{name}={word}" for name, word in self.named_wishes().items()]

    def _edge_of(self, name) -> Edge:
        base, _, local = str(name).rpartition(".") if isinstance(name, str) else ("", "", name)
        named = [obj for obj in self.objects if obj.Name == base or not base]
        if len(named) != 1:
            raise ValueError(f"{name!r} is no edge of this side: write such as {self._name_of(self.edges[0])}.")
        return named[0], subelements.only_edges(local)[0]

    def _name_of(self, edge: Edge) -> str:
        return f"{edge[0].Name}.Edge{edge[1]}" if len(self.objects) > 1 else f"Edge{edge[1]}"


class BlendSides:
    """Both sides, and the shape that holds the objects of both, in a container's coordinates."""

    def __init__(self, from_side: Side, to_side: Side, container):
        self.from_side, self.to_side = from_side, to_side
        self.joined = JoinedShapes(from_side.objects + to_side.objects, container)

    def request(self, **choices) -> BlendRequest:
        """What is asked of the whole shape. Raises ValueError where an object has no edge of that number."""
        wishes = {self.joined.number(*edge): word for side in (self.from_side, self.to_side)
                  for edge, word in side.wishes.items()}
        return BlendRequest.of(self._numbers(self.from_side), self._numbers(self.to_side), wishes, **choices)

    def _numbers(self, side: Side) -> list[int]:
        return [self.joined.number(*edge) for edge in side.edges]


def side_links(given) -> list[Link]:
    """A link an object out of what callers may give for a side: a link, a list of links, or None."""
    is_list = isinstance(given, (tuple, list)) and all(isinstance(item, (tuple, list)) for item in given)
    return links_of(given if is_list else [given] if given else ())
