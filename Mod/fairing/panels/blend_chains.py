# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a blend's sides as the panel lists them: the picked ones, and those found by themselves."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App

from .. import exchange
from ..features.blend_sides import BlendSides, Side

LINE_POINTS = 65  # of an edge
SAME = 1e-7  # mm, FreeCAD's own for points


class BlendChains:
    """The shape of both sides as the native module takes it, and the chains in it. `problem` says why picked edges make
    no chain; is_junction whether there are more than two, is_closed whether
    all of them close."""

    def __init__(self, sides: BlendSides):
        self.sides, self.problem, self.is_junction, self.is_closed = sides, "", False, True
        self.brep = exchange.data_of(sides.joined.shape)
        self._native = exchange.native_shape_of(self.brep)
        self._edges = sides.joined.shape.Edges

    def rows(self, sides: list[Optional[Side]], continuity: str) -> list[list[dict]]:
        """Of either side one row an edge, chain by chain; none where it has no picks. Raises ValueError where an
        object has no edge of that number."""
        picked = [[self.sides.joined.number(*edge) for edge in side.edges] if side else [] for side in sides]
        for number in picked[0] + picked[1]:
            if not 1 <= number <= len(self._edges):
                base, own = self.sides.joined.place(number)
                raise ValueError(f"There is no edge {own}: {base.Label} has {len(self._edges)}.")
        return [[self._row(number, number not in own, side, continuity) for number in self._whole(own, others)]
                for side, own, others in zip(sides, picked, picked[::-1])]

    def side_of_vertex(self, loops: list[list[dict]], base, number: int) -> Optional[int]:
        """The side whose rows have an edge of an object that ends at a vertex of it."""
        vertexes = self.sides.joined.own_shape(base).Vertexes if base in self.sides.joined.objects else []
        if not 1 <= number <= len(vertexes):
            return None
        point = vertexes[number - 1].Point
        return next((side for side, rows in enumerate(loops) for row in rows if row["place"][0] is base
                     for end in (row["points"][0], row["points"][-1]) if point.isEqual(App.Vector(*end), SAME)), None)

    def _whole(self, own: list[int], others: list[int]) -> list[int]:
        """The picked edges in the order of their chains, with those that continue them smoothly."""
        try:
            chains = self._native.chains(own) if own else []
            chains.sort(key=lambda chain: min(map(own.index, chain)))
            self.is_junction = self.is_junction or len(chains) > 1
            ends = self.sides.end_numbers() if chains else ()
            found = [self._native.whole_chain(chain, others + own, *ends) for chain in chains]
        except ValueError as error:
            self.problem = self.problem or str(error)
            return own
        self.is_closed = self.is_closed and all(closed for _, closed in found)
        return list(dict.fromkeys(number for chain, _ in found for number in chain))

    def _row(self, number: int, found: bool, side: Side, continuity: str) -> dict:
        joined = self.sides.joined
        place, faces = joined.place(number), joined.faces_beside(number)
        points = self._edges[number - 1].discretize(LINE_POINTS)
        return {"edge": number, "place": place, "name": joined.name(number), "found": found,
                "face": faces[0] if faces else 0, "has_normal": bool(faces),
                "continuity": side.wishes.get(place, continuity) if faces else "G0",
                "points": [tuple(point) for point in points]}
