# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a blend, whose edges may lie on several objects, as edges of one shape."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterable, Mapping, Optional

import FreeCAD as App
import Part

from .. import subelements
from ..blend_request import BlendRequest
from .joined_shapes import JoinedShapes, Place
from .links import Link, links_of, several

NO_SIDE = "A side of the blend has no edge: pick an edge on either side."


@dataclasses.dataclass(frozen=True)
class Side:
    """Picked edges, and those that are met in another way than the rest, {(object, 7): "G0"}."""

    edges: tuple[Place, ...]
    wishes: Mapping[Place, str] = dataclasses.field(default_factory=dict)

    @staticmethod
    def of(given, wishes: Optional[Mapping[Any, str]] = None) -> "Side":
        """From a link, (object, ["Edge7"]), or a list of links; wishes by "Edge7", or by "Pipe.Edge7" where there are
        several objects. Raises ValueError where there is no edge, or something else is named."""
        edges = tuple((obj, edge) for obj, names in several(given) for edge in subelements.only_edges(names))
        if not edges:
            raise ValueError(NO_SIDE)
        side = Side(edges)
        named = {side.place_of(name): word for name, word in (wishes or {}).items()}
        return dataclasses.replace(side, wishes=named)

    @property
    def objects(self) -> list[App.DocumentObject]:
        return list(dict.fromkeys(obj for obj, _ in self.edges))

    def links(self) -> list[Link]:
        return [(obj, [f"Edge{edge}" for base, edge in self.edges if base is obj]) for obj in self.objects]

    def named_wishes(self) -> dict[str, str]:
        """The wishes as scripts give them, in the order of their edges' numbers."""
        ordered = sorted(self.wishes.items(), key=lambda item: (self.objects.index(item[0][0]), item[0][1]))
        return {self.name_of(edge): word for edge, word in ordered}

    def lines(self) -> list[str]:
        return [f"{name}={word}" for name, word in self.named_wishes().items()]

    def place_of(self, name, kind: str = "Edge") -> Place:
        """An edge, or a vertex, by "Edge7", or by "Pipe.Edge7" where there are several objects. Raises ValueError."""
        base, _, local = name.rpartition(".") if isinstance(name, str) else ("", "", name)
        named = [obj for obj in self.objects if obj.Name == base or not base]
        if len(named) != 1:
            sample = self.name_of((self.objects[0], 7), kind)
            raise ValueError(f"{name!r} does not belong to this side: write such as {sample}.")
        return named[0], subelements.only_edges(local)[0] if kind == "Edge" else subelements.vertex_number(local)

    def name_of(self, place: Place, kind: str = "Edge") -> str:
        return f"{place[0].Name}.{kind}{place[1]}" if len(self.objects) > 1 else f"{kind}{place[1]}"


Pair = tuple[Place, Place]  # vertices, one of either side, that belong together
Curves = tuple[list[Link], list[Link]]  # what either side is set back to: edges, or objects for all of theirs
NO_CURVES: Curves = ([], [])


class BlendSides:
    """Both sides, and the shape that holds the objects of both, the curves they are set back to, what the ends
    follow and the edges that show cuts, in a container's coordinates."""

    def __init__(self, from_side: Side, to_side: Side, container, pairs: Iterable[Pair] = (),
                 curves: Curves = NO_CURVES, ends: Iterable[Link] = (), cuts: Iterable[Link] = ()):
        self.from_side, self.to_side, self.pairs, self.curves = from_side, to_side, tuple(pairs), curves
        self.ends, self.cuts = links_of(ends), links_of(cuts)
        self._cut_edges = edges_of(self.cuts)
        self._curve_edges = [edges_of(curve) for curve in curves]
        objects = from_side.objects + to_side.objects + [obj for obj, _ in self.ends]
        self.joined = JoinedShapes(objects, container, sum(self._curve_edges, self._cut_edges))

    def request(self, **choices) -> BlendRequest:
        """What is asked of the whole shape. Raises ValueError where an object has no edge of that number."""
        wishes = {self.joined.number(*edge): word for side in (self.from_side, self.to_side)
                  for edge, word in side.wishes.items()}
        pairs = [tuple(self.joined.vertex_number(*place) for place in pair) for pair in self.pairs]
        curves = dict(zip(("from_curve", "to_curve"), map(self._numbers, self._curve_edges)))
        ends, faces = self.end_numbers()
        return BlendRequest.of(self._numbers(self.from_side.edges), self._numbers(self.to_side.edges), wishes, pairs,
                               **{**curves, "ends": ends, "end_faces": faces, "cuts": self._numbers(self._cut_edges),
                                  **choices})

    def end_numbers(self) -> tuple[list[int], list[int]]:
        """The edges and the faces of the whole shape that the ends follow. Raises ValueError where there is none of
        that number, or something else is named."""
        edges, faces = [], []
        for obj, names in self.ends:
            for name in names:
                if subelements.is_face(name):
                    faces.append(self.joined.face_number(obj, subelements.only_faces(name)[0]))
                else:
                    edges.append(self.joined.number(obj, subelements.only_edges(name)[0]))
        return edges, faces

    def name_of(self, side: dict) -> str:
        """What a side of a report runs along: an edge, or the face it slides on."""
        return self.joined.name(side["edge"]) if side["edge"] else self.joined.face_name(side["face"])

    def _numbers(self, edges: Iterable[Place]) -> list[int]:
        return [self.joined.number(*edge) for edge in edges]


def pairs_of(given, from_side: Side, to_side: Side) -> tuple[Pair, ...]:
    """From ("Vertex3", "Vertex7"), with objects in front where a side has several. Raises ValueError."""
    pairs = [tuple(pair) for pair in given]
    for pair in pairs:
        if len(pair) != 2:
            raise ValueError(f"{pair!r} is no pair of vertices: one of either side is needed.")
    return tuple((from_side.place_of(first, "Vertex"), to_side.place_of(second, "Vertex")) for first, second in pairs)


def named_pairs(pairs: Iterable[Pair], from_side: Side, to_side: Side) -> list[tuple[str, str]]:
    """The inverse."""
    return [(from_side.name_of(first, "Vertex"), to_side.name_of(second, "Vertex")) for first, second in pairs]


def edges_of(curve: Iterable[Link]) -> list[Place]:
    """The edges that links mean; an object without names means all of its. Raises ValueError where there is none, or
    something else is named."""
    places = []
    for obj, names in curve:
        numbers = subelements.only_edges(names) if names else range(1, len(Part.getShape(obj).Edges) + 1)
        if not numbers:
            raise ValueError(f"{obj.Label} has no edge.")
        places += [(obj, number) for number in numbers]
    return places
