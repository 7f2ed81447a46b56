# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the fill panel is working on, without its widgets: the picks, the choices, the hole they make, the result."""

from __future__ import annotations

import dataclasses
from typing import Optional

import FreeCAD as App

from .. import exchange, subelements
from ..features import links
from ..features.fill_feature import NOTHING_PICKED, FillFeature
from ..features.fill_properties import read_request
from ..features.placement import shape_in
from ..fill_request import FillRequest
from .commands import link_command, make_as_one_step, object_command, run_as_one_step
from .guided_session import GuidedSession


class FillSession(GuidedSession):
    """One fill being made or edited. `loop` holds the sides of the hole, `problem` why there is none."""

    def __init__(self, document: App.Document, request: FillRequest, base=None, obj=None):
        super().__init__()
        self.document, self.request, self.obj = document, request, obj
        self.base = None
        self.through: list[links.Link] = []
        self.loop: list[dict] = []
        self.problem = NOTHING_PICKED
        self._shape = self._brep = None
        if base is not None:
            self._use_base(base)

    @classmethod
    def of_object(cls, obj: App.DocumentObject) -> "FillSession":
        """To edit a fill."""
        session = cls(obj.Document, read_request(obj), obj.Edges[0] if obj.Edges else None, obj)
        session._read_guidance(obj)
        session.through = links.links_of(obj.Through)
        session.find_loop()
        return session

    def pick(self, base: App.DocumentObject, names) -> None:
        """Adds picks. Those on another object, on another hole, or a face, start a new hole."""
        names = list(names)
        if base is not self.base:
            self.clear()
            self._use_base(base)
        if self.request.edges and all(map(subelements.is_edge, names)):
            self._set_picks(self.request.picks() + [name for name in names if name not in self.request.picks()])
            if not self.problem:
                return
        self._set_picks(names)

    def clear(self) -> None:
        self.base, self.loop, self.problem = None, [], NOTHING_PICKED
        self.request = dataclasses.replace(self.request, edges=(), faces=(), edge_continuity=(), tangents=(),
                                           symmetry=())

    def set_continuity(self, word: str, edge: Optional[int] = None) -> None:
        """Of one edge, or of all."""
        if edge is None:
            self.change(continuity=word, edge_continuity=())
        else:
            wishes = dict(self.request.edge_continuity)
            wishes[edge] = word
            self.change(edge_continuity=tuple(sorted(
                (number, wish) for number, wish in wishes.items() if wish != self.request.continuity)))

    def set_through(self, through) -> None:
        """[(object, [names])]. Raises ValueError where one has nothing to pass through, and then all is as before."""
        merged = links.links_of(through)
        self.change(through=links.through_data(merged, self.container))
        self.through = merged

    def edge_in_loop(self, name: str) -> int:
        """The number of an edge of the hole, 0 for any other name."""
        numbers = subelements.edge_numbers([name])
        return numbers[0] if numbers and numbers[0] in [side["edge"] for side in self.loop] else 0

    def find_loop(self) -> None:
        """Finds the sides of the hole the picks belong to."""
        self.loop, self.problem = [], ""
        if not (self.base and (self.request.edges or self.request.faces)):
            self.problem = NOTHING_PICKED
            return
        try:
            self.loop = self._shape.boundary(**self.request.loop_arguments())
        except ValueError as error:
            self.problem = str(error)

    def commit(self) -> None:
        """Writes the fill into the document as one step to undo, by commands the macro recorder understands."""
        if self.obj is None:
            self.obj = make_as_one_step(self.document, "Fill hole", self._command(), FillFeature.TYPE)
        else:
            run_as_one_step(self.document, f"Edit {self.obj.Label}", self._command())
        self._read_guidance(self.obj)  # with the names of new guides

    def _use_base(self, base: App.DocumentObject) -> None:
        self.base = base
        self._brep = exchange.data_of(shape_in(self.container, base))
        self._shape = exchange.native_shape_of(self._brep)
        self._look_guidance_up()
        if self.through:
            self.set_through(self.through)

    def _set_picks(self, names) -> None:
        fresh = FillRequest.of(names)
        self.change(edges=fresh.edges, faces=fresh.faces, edge_continuity=(), tangents=(), symmetry=())
        self.find_loop()

    def _command(self) -> str:
        """The Python line that does what OK does: only what differs from the defaults, or from the object as it is."""
        base = object_command(self.base)
        if self.obj is None:
            head, before, parts = f"fairing.make_fill({base}, {self.request.picks()!r}", FillRequest(), []
        else:
            head = f"fairing.change_fill({object_command(self.obj)}"
            before, parts = read_request(self.obj), links.links_of(self.obj.Through)
            if not self.obj.Edges or self.obj.Edges[0] is not self.base or self.request.picks() != before.picks():
                head += f", {self.request.picks()!r}, base={base}"
        tail = "".join(f", {name}={value!r}" for name, value in self.request.differences(before).items())
        tail += self.guidance_command()
        if self.through != parts:
            tail += f", through=[{', '.join(map(link_command, self.through))}]"
        return f"{head}{tail})"
