# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the blend panel is working on, without its widgets: the two sides, the choices, the result."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional

import FreeCAD as App

from .. import exchange, subelements
from ..blend_request import BlendRequest
from ..features import blend_properties as properties
from ..features.blend_sides import NO_SIDE, BlendSides, Side
from ..features.placement import container_for_results, container_of, placement_of
from .commands import link_command, object_command, run_as_one_step

MESH_POINTS = 33  # along either direction of a patch: smooth to the eye, drawn within a frame
LINE_POINTS = 65  # of an edge
FROM, TO = range(2)
CHOICES = ("continuity", "energy", "gap_tolerance", "angle_tolerance", "degree", "max_poles", "result")


class BlendSession:
    """One blend being made or edited. `loops` holds the picked edges of either side, `problem` why none is asked."""

    def __init__(self, document: App.Document, request: BlendRequest, sides=(None, None), obj=None):
        self.document, self.request, self.obj = document, request, obj
        self.sides: list[Optional[Side]] = list(sides)
        self.loops: list[list[dict]] = [[], []]
        self.problem = NO_SIDE
        self._joined: Optional[BlendSides] = None

    @classmethod
    def of_object(cls, obj: App.DocumentObject) -> "BlendSession":
        """To edit a blend. Raises ValueError where its properties make no sense."""
        sides = (properties.from_side(obj), properties.to_side(obj))
        return cls(obj.Document, BlendRequest(**properties.read_choices(obj)), sides, obj)

    @property
    def container(self):
        """Where the result lives, and in whose coordinates everything here is."""
        if self.obj:
            return container_of(self.obj)
        first = self.sides[FROM] or self.sides[TO]
        return container_for_results(first.base) if first else None

    @property
    def placement(self) -> App.Placement:
        return placement_of(self.container)

    @property
    def loop(self) -> list[dict]:
        """The picked edges of both sides."""
        return self.loops[FROM] + self.loops[TO]

    def pick(self, position: int, base: App.DocumentObject, name: str) -> None:
        """Adds an edge to a side. One of another object starts the side anew."""
        side, number = self.sides[position], subelements.only_edges(name)
        if side and side.base is base:
            self.sides[position] = dataclasses.replace(side, edges=tuple(dict.fromkeys(side.edges + number)))
        else:
            self.sides[position] = Side(base, number, {})

    def number_of(self, base: App.DocumentObject, name: str) -> int:
        """The number of a picked edge in the whole shape, 0 for any other."""
        return next((row["edge"] for row in self.loop if (row["base"], row["own"]) == (base, name)), 0)

    def clear(self) -> None:
        self.sides = [None, None]

    def change(self, **changes: Any) -> None:
        """Other choices, by the names of BlendRequest."""
        self.request = dataclasses.replace(self.request, **changes)

    def set_continuity(self, word: str, edge: Optional[int] = None) -> None:
        """Of one edge of the whole shape, or of all."""
        if edge is None:
            self.change(continuity=word)
        for position, side in enumerate(self.sides):
            if side and edge is None:
                self.sides[position] = dataclasses.replace(side, wishes={})
            for row in self.loops[position]:
                if row["edge"] == edge:
                    number = subelements.only_edges(row["own"])[0]
                    kept = {own: wish for own, wish in side.wishes.items() if own != number}
                    wishes = kept if word == self.request.continuity else {**kept, number: word}
                    self.sides[position] = dataclasses.replace(side, wishes=wishes)

    def update(self) -> None:
        """Looks up the picked edges after a change."""
        self.loops, self._joined = [[], []], None
        self.problem = NO_SIDE if None in self.sides else ""
        present = [side for side in self.sides if side]
        if not present:
            return
        try:
            joined = BlendSides(present[0], present[-1], self.container)
            self.loops = [self._rows(joined, side) if side else [] for side in self.sides]
        except ValueError as error:
            self.problem = str(error)
            return
        self._joined = joined

    def job(self):
        """What a background thread computes: the native Fill and its mesh. Touches plain data only."""
        request = self._joined.request(**self._choices())
        brep = exchange.data_of(self._joined.shape)

        def solve(progress):
            blend = request.solve(brep, progress)
            return blend, blend.mesh(MESH_POINTS)

        return solve

    def commit(self) -> None:
        """Writes the blend into the document as one step to undo, by commands the macro recorder understands."""
        title = "Blend faces" if self.obj is None else f"Edit {self.obj.Label}"
        run_as_one_step(self.document, title, self._command())
        if self.obj is None:
            self.obj = self.document.ActiveObject

    def _rows(self, joined: BlendSides, side: Side) -> list[dict]:
        rows = []
        for own in side.edges:
            number = joined.number(side.base, own)
            if number > len(joined.shape.Edges):
                raise ValueError(f"There is no edge {own}: {side.base.Label} has {len(joined.shape.Edges)}.")
            points = joined.shape.Edges[number - 1].discretize(LINE_POINTS)
            faces = joined.faces_beside(side.base, own)
            rows.append({"edge": number, "own": f"Edge{own}", "base": side.base, "name": f"{side.base.Name}.Edge{own}",
                         "face": faces[0] if faces else 0, "has_normal": bool(faces),
                         "continuity": side.wishes.get(own, self.request.continuity) if faces else "G0",
                         "points": [tuple(point) for point in points]})
        return rows

    def _choices(self) -> dict:
        return {name: getattr(self.request, name) for name in CHOICES}

    def _command(self) -> str:
        """The Python line that does what OK does: only what differs from the defaults, or from the object as it is."""
        links = [link_command(side.link()) for side in self.sides]
        if self.obj is None:
            head, before, known = f"fairing.make_blend({', '.join(links)}", BlendRequest(), [{}, {}]
        else:
            head = f"fairing.change_blend({object_command(self.obj)}"
            before = BlendRequest(**properties.read_choices(self.obj))
            old = [properties.from_side(self.obj), properties.to_side(self.obj)]
            known = [side.wishes for side in old]
            for name, link, side, was in zip(("from_edges", "to_edges"), links, self.sides, old):
                if link != link_command(was.link()):
                    head += f", {name}={link}"
                    known[old.index(was)] = {}
        tail = "".join(f", {name}={{{', '.join(f'{edge!r}: {word!r}' for edge, word in pairs)}}}"
                       for name, pairs in _changed_wishes(self.sides, known))
        tail += "".join(f", {name}={value!r}" for name, value in self._choices().items()
                        if value != getattr(before, name))
        return f"{head}{tail})"


def _changed_wishes(sides, known):
    for name, side, was in zip(("from_continuity", "to_continuity"), sides, known):
        if side.wishes != was:
            yield name, [(f"Edge{edge}", word) for edge, word in sorted(side.wishes.items())]
