# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel of Edit Surface is working on, without its widgets: the face, the choices, the result."""

from __future__ import annotations

import FreeCAD as App

from .. import exchange
from ..edit_request import EditRequest
from ..features.edit_feature import NO_FACE, EditFeature, face_number
from ..features.edit_properties import read_request
from ..features.placement import shape_in
from .commands import make_as_one_step, object_command, run_as_one_step
from .guided_session import GuidedSession

LINE_POINTS = 65  # of an edge


class EditSession(GuidedSession):
    """One edit being made or changed. `lines` holds the edges of the face as points, `problem` why there is none."""

    loop = ()  # no edges to be met, as other sessions have
    is_guided = has_points = True  # by the face itself, if by nothing else

    def __init__(self, document: App.Document, request: EditRequest, base=None, obj=None):
        super().__init__()
        self.document, self.request, self.obj = document, request, obj
        self.base, self.lines, self.problem, self._brep = None, [], NO_FACE, b""
        if base is not None:
            self._use(base)

    @classmethod
    def of_object(cls, obj: App.DocumentObject) -> "EditSession":
        """To change an edit."""
        session = cls(obj.Document, read_request(obj), obj.Face[0] if obj.Face else None, obj)
        session._read_guidance(obj)
        return session

    @property
    def name(self) -> str:
        """Of the face, as people read it."""
        return f"{self.base.Label}: Face{self.request.face}" if self.base else ""

    def pick(self, base: App.DocumentObject, name: str) -> None:
        """Another face. Of a new edit the result replaces it where its object has others."""
        self.change(face=face_number(name))
        self._use(base)
        if self.obj is None:
            self.change(result="base" if len(shape_in(None, base).Faces) > 1 else "patches")

    def neighbours(self, report: dict) -> tuple[bytes, list[int]]:
        """The faces that have an edge of the face."""
        faces = shape_in(self.container, self.base).Faces
        own = {edge.hashCode() for edge in faces[self.request.face - 1].Edges}
        return self._brep, [number for number, face in enumerate(faces, 1)
                            if number != self.request.face and own & {edge.hashCode() for edge in face.Edges}]

    def commit(self) -> None:
        """Writes the edit into the document as one step to undo, by commands the macro recorder understands."""
        if self.obj is None:
            self.obj = make_as_one_step(self.document, "Edit surface", self._command(), EditFeature.TYPE)
        else:
            run_as_one_step(self.document, f"Edit {self.obj.Label}", self._command())
        self._read_guidance(self.obj)  # with the names of new guides

    def _use(self, base: App.DocumentObject) -> None:
        self.base, self.lines, self.problem = base, [], ""
        shape = shape_in(self.container, base)
        self._brep = exchange.data_of(shape)
        if 1 <= self.request.face <= len(shape.Faces):
            self.lines = [edge.discretize(LINE_POINTS) for edge in shape.Faces[self.request.face - 1].Edges
                          if not edge.Degenerated]
        self._look_guidance_up()

    def _command(self) -> str:
        """The Python line that does what OK does: only what differs from the defaults, or from the object as it is."""
        base, face = object_command(self.base), f"Face{self.request.face}"
        if self.obj is None:
            head, before = f"fairing.make_edit({base}, {face!r}", EditRequest()
        else:
            head, before = f"fairing.change_edit({object_command(self.obj)}", read_request(self.obj)
            if not self.obj.Face or self.obj.Face[0] is not self.base or self.request.face != before.face:
                head += f", {face!r}, base={base}"
        tail = "".join(f", {name}={value!r}" for name, value in self.request.differences(before).items())
        return f"{head}{tail}{self.guidance_command()})"
