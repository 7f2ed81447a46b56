# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the blend panel is working on, without its widgets: the two sides, the choices, the result."""

from __future__ import annotations

import dataclasses
from typing import Optional

import FreeCAD as App

from .. import subelements
from ..blend_request import BlendRequest
from ..features import blend_properties as properties
from ..features.blend_feature import BlendFeature
from ..features.blend_sides import NO_SIDE, BlendSides, Pair, Side
from ..features.links import Link, links_of
from ..features.placement import container_for_results, container_of
from .blend_chains import BlendChains
from .blend_command import blend_command
from .commands import make_as_one_step, run_as_one_step
from .guided_session import MESH_POINTS, GuidedSession

FROM, TO = range(2)
# Choices that a strip alone has: a junction is asked none of them.
STRIP_CHOICES = ("from_reach_end", "to_reach_end", "from_departure", "to_departure",
                 "from_flip", "to_flip", "from_setback", "to_setback", "match", "alignment")
CHOICES = tuple(properties.NAMES)

_REACHES = (("from_reach", "from_reach_end"), ("to_reach", "to_reach_end"))


class BlendSession(GuidedSession):
    """One blend being made or edited. `loops` holds the edges of either side, `problem` why none is asked."""

    def __init__(self, document: App.Document, request: BlendRequest, sides=(None, None), obj=None):
        super().__init__()
        self.document, self.request, self.obj = document, request, obj
        self.sides: list[Optional[Side]] = list(sides)
        self.pairs: tuple[Pair, ...] = ()
        self.curves: list[list[Link]] = [[], []]  # what either side is set back to
        self.ends: list[Link] = []  # what the ends follow
        self.cuts: list[Link] = []  # edges that show where a junction is cut
        self.loops: list[list[dict]] = [[], []]
        self.problem = NO_SIDE
        self._chains: Optional[BlendChains] = None
        self._blend = None  # the native Blend of what is asked now, whatever its reaches

    @classmethod
    def of_object(cls, obj: App.DocumentObject) -> "BlendSession":
        """To edit a blend. Raises ValueError where its properties make no sense."""
        sides = (properties.from_side(obj), properties.to_side(obj))
        session = cls(obj.Document, BlendRequest(**properties.read_choices(obj)), sides, obj)
        session.pairs, session.ends = properties.read_pairs(obj), links_of(obj.Ends)
        session.cuts = links_of(obj.Cuts)
        session.curves = list(properties.read_curves(obj))
        session._read_guidance(obj)
        return session

    @property
    def container(self):
        """Where the result lives, and in whose coordinates everything here is."""
        if self.obj:
            return container_of(self.obj)
        first = self.sides[FROM] or self.sides[TO]
        return container_for_results(first.objects[0]) if first else None

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

    def measured_end(self, base: App.DocumentObject, name: str, report: dict) -> Optional[dict]:
        """The side of a report that runs along an edge, or on a face, that an end follows."""
        joined, of_sides = self._chains.sides.joined, {row["edge"] for row in self.loop}
        if subelements.is_face(name):
            kind, number = "face", joined.face_number(base, subelements.only_faces(name)[0])
        else:
            kind, number = "edge", joined.number(base, subelements.only_edges(name)[0])
        return next((side for side in report["sides"] if side[kind] == number and side["edge"] not in of_sides), None)

    def clear(self) -> None:
        self.sides, self.ends, self.cuts = [None, None], [], []

    def side_of_vertex(self, base: App.DocumentObject, name: str) -> Optional[int]:
        """Which side's edges a vertex ends, None for neither."""
        return self._chains.side_of_vertex(self.loops, base, subelements.vertex_number(name)) if self._chains else None

    def set_curve(self, position: int, links: list[Link]) -> None:
        """What a side is set back to, [(object, [names])]: the whole object where there are no names."""
        self.curves[position] = links_of(links)

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
            objects = {obj for side in present for obj in side.objects}
            self.pairs = tuple(pair for pair in self.pairs if objects.issuperset(obj for obj, _ in pair))
            pairs = self.pairs if len(present) == 2 else ()
            ends, cuts = (self.ends, self.cuts) if len(present) == 2 else ((), ())
            self._chains = BlendChains(
                BlendSides(present[0], present[-1], self.container, pairs, tuple(self.curves), ends, cuts))
            self.loops = self._chains.rows(self.sides, self.request.continuity)
        except ValueError as error:
            self.problem = str(error)
            return
        self.problem = self.problem or self._chains.problem

    def asked(self) -> tuple:
        """The request, and BREP of the shape it is about."""
        idle = {} if self.is_strip else dict.fromkeys(("from_curve", "to_curve", "ends", "end_faces"), ())
        idle.update({} if self.is_junction else {"cuts": ()})
        idle.update(reference=self.request.reference, guide=self.request.guide)
        return self._chains.sides.request(**self.choices(), **idle), self._chains.brep

    def neighbours(self, report: dict) -> tuple[bytes, list[int]]:
        asked = self.choices()
        is_cut = asked["from_setback"] > 0.0 or asked["to_setback"] > 0.0 or any(self.asked_curves)
        faces = set() if is_cut else {side["face"] for side in report["sides"]}  # set back, they are other ones
        return self._chains.brep, sorted(faces - {0})

    def keep(self, blend) -> None:
        """Keeps what the last job made, for what needs a blend before another is asked for."""
        self._blend = blend

    def reach(self, position: int, value: float):
        """Another reach of one side. Returns the blend that has it and its mesh at the cost of one solve; None where
        no strip is kept. Raises FairingError."""
        self.change(**{_REACHES[position][0]: value})
        if self._blend is None or not self.is_strip:
            return None
        asked = self.choices()
        reached = self._blend.reaching(**{name: asked[name] for names in _REACHES for name in names})
        return reached, reached.mesh(MESH_POINTS)

    def middle_reach(self, position: int) -> float:
        """Reach in the middle of a side."""
        start, end = (getattr(self.request, name) for name in _REACHES[position])
        return start if end is None or self.is_closed else 0.5 * (start + end)

    def scale_reach(self, position: int, middle: float) -> float:
        """Lets the reach at the end of a side grow as that in its middle does. Returns the one at its start."""
        factor = middle / self.middle_reach(position)
        start, end = (getattr(self.request, name) for name in _REACHES[position])
        if end is not None:
            self.change(**{_REACHES[position][1]: round(factor * end, 2)})
        return round(factor * start, 2)

    @property
    def arms(self) -> list:
        """How the kept blend leaves either side at reach 1, as the native Blend tells; none where none is kept."""
        return self._blend.arms if self._blend and self.is_strip else []

    def commit(self) -> None:
        """Writes the blend into the document as one step to undo, by commands the macro recorder understands."""
        if self.obj is None:
            self.obj = make_as_one_step(self.document, "Blend faces", blend_command(self), BlendFeature.TYPE)
        else:
            run_as_one_step(self.document, f"Edit {self.obj.Label}", blend_command(self))
        self._read_guidance(self.obj)  # with the names of new guides

    @property
    def is_strip(self) -> bool:
        """Whether there are two sides of one chain each, and not a junction."""
        return None not in self.sides and not (self._chains and self._chains.is_junction)

    @property
    def is_ring(self) -> bool:
        """Whether there are three chains or more, not all of them closed."""
        return None not in self.sides and not self.is_strip and not self._chains.is_closed

    @property
    def is_junction(self) -> bool:
        """Whether there are three chains or more, all of them closed."""
        return None not in self.sides and not self.is_strip and self._chains.is_closed

    @property
    def asked_cuts(self) -> list[Link]:
        """Edges that show the cuts: of a junction alone."""
        return self.cuts if self.is_junction else []

    @property
    def asked_ends(self) -> list[Link]:
        """What the ends follow: a junction has none."""
        return self.ends if self.is_strip else []

    @property
    def is_closed(self) -> bool:
        return self.is_strip and self._chains is not None and self._chains.is_closed

    @property
    def asked_curves(self) -> list[list[Link]]:
        """The curves, as choices() has the choices."""
        return self.curves if self.is_strip else [[], []]

    def choices(self) -> dict:
        """What is asked: of what is chosen that which makes sense with the sides as they are."""
        plain = BlendRequest()
        idle = set() if self.is_strip else set(STRIP_CHOICES)
        idle |= {"from_reach_end", "to_reach_end"} if self.is_closed else {"alignment"}
        idle |= set() if self.is_ring else {"ring"}
        return {name: getattr(plain if name in idle else self.request, name) for name in CHOICES}
