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
from .blend_chains import BlendChains
from .commands import link_command, object_command, run_as_one_step

MESH_POINTS = 33  # along either direction of a patch: smooth to the eye, drawn within a frame
FROM, TO = range(2)
CHOICES = ("continuity", "from_reach", "to_reach", "energy", "gap_tolerance", "angle_tolerance", "degree", "max_poles",
           "result")


class BlendSession:
    """One blend being made or edited. `loops` holds the edges of either side, `problem` why none is asked."""

    def __init__(self, document: App.Document, request: BlendRequest, sides=(None, None), obj=None):
        self.document, self.request, self.obj = document, request, obj
        self.sides: list[Optional[Side]] = list(sides)
        self.loops: list[list[dict]] = [[], []]
        self.problem = NO_SIDE
        self._chains: Optional[BlendChains] = None
        self._blend = None  # the native Blend of what is asked now, whatever its reaches

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
        return container_for_results(first.objects[0]) if first else None

    @property
    def placement(self) -> App.Placement:
        return placement_of(self.container)

    @property
    def loop(self) -> list[dict]:
        """The edges of both sides."""
        return self.loops[FROM] + self.loops[TO]

    def pick(self, position: int, base: App.DocumentObject, name: str) -> None:
        """Adds an edge to a side."""
        edge, side = (base, subelements.only_edges(name)[0]), self.sides[position]
        if side is None:
            self.sides[position] = Side((edge,))
        elif edge not in side.edges:
            self.sides[position] = dataclasses.replace(side, edges=side.edges + (edge,))

    def drop(self, number: int) -> None:
        """Takes a picked edge of the whole shape away."""
        for position, side in enumerate(self.sides):
            own = [row["place"] for row in self.loops[position] if row["edge"] == number]
            if side and own:
                kept = tuple(edge for edge in side.edges if edge != own[0])
                wishes = {edge: word for edge, word in side.wishes.items() if edge in kept}
                self.sides[position] = Side(kept, wishes) if kept else None

    def number_of(self, base: App.DocumentObject, name: str) -> int:
        """The number in the whole shape of an edge of either side, 0 for any other."""
        place = base, subelements.only_edges(name)[0]
        return next((row["edge"] for row in self.loop if row["place"] == place), 0)

    def is_picked(self, number: int) -> bool:
        """Whether an edge of the whole shape was picked, and not found by itself."""
        return any(row["edge"] == number and not row["found"] for row in self.loop)

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
                    kept = {place: wish for place, wish in side.wishes.items() if place != row["place"]}
                    wishes = kept if word == self.request.continuity else {**kept, row["place"]: word}
                    self.sides[position] = dataclasses.replace(side, wishes=wishes)

    def update(self) -> None:
        """Looks up the edges after a change."""
        self.loops, self._chains, self._blend = [[], []], None, None
        self.problem = NO_SIDE if None in self.sides else ""
        present = [side for side in self.sides if side]
        if not present:
            return
        try:
            self._chains = BlendChains(BlendSides(present[0], present[-1], self.container))
            self.loops = self._chains.rows(self.sides, self.request.continuity)
        except ValueError as error:
            self.problem = str(error)
            return
        self.problem = self.problem or self._chains.problem

    def job(self):
        """What a background thread computes: the native Blend and its mesh. Touches plain data only."""
        request, brep = self._chains.sides.request(**self._choices()), self._chains.brep

        def solve(progress):
            blend = request.solve(brep, progress)
            return blend, blend.mesh(MESH_POINTS)

        return solve

    def keep(self, blend) -> None:
        """Keeps what the last job made, for what needs a blend before another is asked for."""
        self._blend = blend

    def reach(self, position: int, value: float):
        """Another reach of one side. Returns the blend that has it and its mesh at the cost of one solve; None where
        no blend is kept. Raises FairingError."""
        self.change(**{("from_reach", "to_reach")[position]: value})
        if self._blend is None:
            return None
        reached = self._blend.reaching(self.request.from_reach, self.request.to_reach)
        return reached, reached.mesh(MESH_POINTS)

    @property
    def arms(self) -> list:
        """How the kept blend leaves either side at reach 1, as the native Blend tells; none where none is kept."""
        return self._blend.arms if self._blend and self.has_reach else []

    def commit(self) -> None:
        """Writes the blend into the document as one step to undo, by commands the macro recorder understands."""
        title = "Blend faces" if self.obj is None else f"Edit {self.obj.Label}"
        run_as_one_step(self.document, title, self._command())
        if self.obj is None:
            self.obj = self.document.ActiveObject

    @property
    def has_reach(self) -> bool:
        """Whether there are two sides that could reach farther; a junction reaches as its energy likes best."""
        return None not in self.sides and not (self._chains and self._chains.is_junction)

    def _choices(self) -> dict:
        chosen = {name: getattr(self.request, name) for name in CHOICES}
        return chosen if self.has_reach else {**chosen, "from_reach": 1.0, "to_reach": 1.0}

    def _command(self) -> str:
        """The Python line that does what OK does: only what differs from the defaults, or from the object as it is."""
        links = [_links_command(side) for side in self.sides]
        if self.obj is None:
            head, before, known = f"fairing.make_blend({', '.join(links)}", BlendRequest(), [{}, {}]
        else:
            head = f"fairing.change_blend({object_command(self.obj)}"
            before = BlendRequest(**properties.read_choices(self.obj))
            old = [properties.from_side(self.obj), properties.to_side(self.obj)]
            known = []
            for name, link, was in zip(("from_edges", "to_edges"), links, old):
                is_other = link != _links_command(was)
                head += f", {name}={link}" if is_other else ""
                known.append({} if is_other else was.named_wishes())
        tail = "".join(f", {name}={side.named_wishes()!r}"
                       for name, side, was in zip(("from_continuity", "to_continuity"), self.sides, known)
                       if side.named_wishes() != was)
        tail += "".join(f", {name}={value!r}" for name, value in self._choices().items()
                        if value != getattr(before, name))
        return f"{head}{tail})"


def _links_command(side: Side) -> str:
    commands = [link_command(link) for link in side.links()]
    return commands[0] if len(commands) == 1 else f"[{', '.join(commands)}]"
