# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel of Fill All Holes is working on, without its widgets: the object, its holes, the choices."""

from __future__ import annotations

from typing import Any

import FreeCAD as App
import numpy as np

from .. import exchange, subelements
from ..features.fill_all_feature import NO_BASE
from ..features.fill_all_properties import read_request
from ..features.placement import shape_in
from ..fill_all_request import FillAllRequest
from .commands import object_command, run_as_one_step
from .guided_session import GuidedSession

MESH_POINTS = 25  # along either direction of a patch
LINE_POINTS = 33  # along an edge


class FillAllSession(GuidedSession):
    """All holes of one object being filled. `holes` holds the edge numbers of each, those left out included,
    `problem` why there are none to fill."""

    def __init__(self, document: App.Document, request: FillAllRequest, base=None, obj=None):
        super().__init__()
        self.document, self.request, self.obj = document, request, obj
        self.base = None
        self.holes: list[list[int]] = []
        self.outer: list[list[int]] = []  # those among them that are outer borders
        self.problem = NO_BASE
        self._shape = self._brep = self._edges = None
        if base is not None:
            self.use_base(base)

    @classmethod
    def of_object(cls, obj: App.DocumentObject) -> "FillAllSession":
        """To edit such an object."""
        session = cls(obj.Document, read_request(obj), obj.Base, obj)
        session._read_guidance(obj)
        return session

    def use_base(self, base: App.DocumentObject) -> None:
        """Whose holes are filled. What was left out on another object is forgotten."""
        if self.base is not None and base is not self.base:
            self.change(skipped=(), edge_continuity=(), tangents=(), symmetry=())
        self.base = base
        shape = shape_in(self.container, base)
        self._edges = shape.Edges
        self._brep = exchange.data_of(shape)
        self._shape = exchange.native_shape_of(self._brep)
        self._look_guidance_up()
        self.find_holes()

    def change(self, **changes: Any) -> None:
        super().change(**changes)
        if "outer_borders" in changes:
            self.find_holes()

    def is_filled(self, hole: list[int]) -> bool:
        return not set(hole).intersection(self.request.skipped)

    def set_filled(self, chosen: list[bool]) -> None:
        """Which of the holes are filled, in their order."""
        self.change(skipped=tuple(sorted(min(hole) for hole, fill in zip(self.holes, chosen) if not fill)))

    def hole_with(self, name: str) -> int:
        """Position of the hole that has an edge, -1 where none has."""
        numbers = set(subelements.edge_numbers([name])) if name else set()
        return next((at for at, hole in enumerate(self.holes) if numbers.intersection(hole)), -1)

    def find_holes(self) -> None:
        self.holes, self.outer, self.problem = [], [], NO_BASE
        if self._shape is None:
            return
        inside = self._shape.holes()
        self.holes = self._shape.holes(True) if self.request.outer_borders else inside
        self.outer = [hole for hole in self.holes if hole not in inside]
        self.problem = "" if self.holes else f"{self.base.Label} has no hole to fill."

    @property
    def what_is_missing(self) -> str:
        """Why nothing can be solved, empty when something can."""
        if not self.problem and not any(map(self.is_filled, self.holes)):
            return "No hole is chosen: tick one in the list."
        return self.problem

    def lines(self, hole: list[int]) -> list[list[App.Vector]]:
        """The edges round a hole, each as points to draw."""
        return [self._edges[number - 1].discretize(Number=LINE_POINTS) for number in hole]

    def job(self):
        """What a background thread computes: the native FillAll and one mesh of all. Touches plain data only."""
        request, brep = self.request, self._brep

        def solve(progress):
            filled = request.solve(brep, progress)
            return filled, joined([hole.fill.mesh(MESH_POINTS) for hole in filled.holes if hole.fill])

        return solve

    def commit(self) -> None:
        """Writes the object into the document as one step to undo, by a command the macro recorder understands."""
        title = "Fill all holes" if self.obj is None else f"Edit {self.obj.Label}"
        run_as_one_step(self.document, title, self._command())
        if self.obj is None:
            self.obj = self.document.ActiveObject

    def _command(self) -> str:
        """The Python line that does what OK does: only what differs from the defaults, or from the object as it is."""
        if self.obj is None:
            head, before = f"fairing.make_fill_all({object_command(self.base)}", FillAllRequest()
        else:
            head = f"fairing.change_fill_all({object_command(self.obj)}"
            before = read_request(self.obj)
            if self.obj.Base is not self.base:
                head += f", base={object_command(self.base)}"
        changes = self.request.differences(before)
        if "skipped" in changes:
            changes["skipped"] = self.request.skipped_names()
        tail = "".join(f", {name}={value!r}" for name, value in changes.items())
        return f"{head}{tail}{self.guidance_command()})"


def joined(meshes):
    """One mesh out of several: points, normals, triangles."""
    if not meshes:
        return np.empty((0, 3), np.float32), np.empty((0, 3), np.float32), np.empty((0, 3), np.int32)
    starts = np.cumsum([0] + [len(points) for points, _, _ in meshes[:-1]])
    triangles = [mesh[2] + start for mesh, start in zip(meshes, starts)]
    return (np.concatenate([mesh[0] for mesh in meshes]), np.concatenate([mesh[1] for mesh in meshes]),
            np.concatenate(triangles).astype(np.int32))
