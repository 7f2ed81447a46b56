# SPDX-License-Identifier: LGPL-2.1-or-later
"""What guides the surface of a session, without widgets: the reference, handles and curves."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import FreeCAD as App

from ..features import guide_objects, links
from ..features.guides import FeatureCurve, Guide, guides_of, merged_text, script_of
from ..features.placement import container_for_results, container_of, placement_of
from .commands import link_command

MESH_POINTS = 33  # along either direction of a patch: smooth to the eye, drawn within a frame


class GuidedSession:
    """What sessions have in common: a `document`, a `request`, the `obj` that is changed or None, and the `base` that
    the surface is made on, as BREP in `_brep`. `reference` holds links, `guides` handles and curves, both in the container's
    coordinates."""

    def __init__(self):
        self.reference: list[links.Link] = []
        self.guides: tuple[Guide, ...] = ()
        self._natives: dict[Guide, dict] = {}  # a dragged handle leaves the others as they are
        self._followed = None  # what a native result was asked last, and by what

    @property
    def container(self):
        """Where the result lives, and in whose coordinates everything here is."""
        if self.obj:
            return container_of(self.obj)
        return container_for_results(self.base) if self.base else None

    @property
    def placement(self) -> App.Placement:
        return placement_of(self.container)

    def change(self, **changes: Any) -> None:
        """Other choices, by the names of the request's members."""
        self.request = dataclasses.replace(self.request, **changes)

    def job(self):
        """What a background thread computes: the native result and its mesh. Touches plain data only."""
        request, brep = self.asked()

        def solve(progress):
            made = request.solve(brep, progress)
            return made, made.mesh(MESH_POINTS)

        return solve

    def neighbours(self, report: dict) -> tuple[bytes, list[int]]:
        """The faces that a result with this report meets: BREP and their numbers in it, none where they are not to be
        drawn beside it."""
        return self._brep, sorted({side["face"] for side in report["sides"]} - {0})

    def asked(self) -> tuple:
        """The request, and BREP of the shape it is about."""
        return self.request, self._brep

    def set_reference(self, reference) -> None:
        """[(object, [names])]. Raises ValueError where one holds nothing that guides, and then all is as before."""
        several = links.several(reference)
        self.change(reference=links.reference_data(several, self.container))
        self.reference = several

    def set_guides(self, guides) -> None:
        """Raises ValueError where one cannot be looked up, and then all is as before."""
        guides = guides_of(guides)
        for guide in guides:
            if guide not in self._natives:
                self._natives[guide] = guide.native(self.container)
        self.change(guide=merged_text((isinstance(guide, FeatureCurve), self._natives[guide]) for guide in guides))
        self._natives = {guide: self._natives[guide] for guide in guides}
        self.guides = guides

    def change_guide(self, position: int, **changes) -> None:
        """Other values of one guide, by the names of its members. Raises ValueError."""
        guides = list(self.guides)
        guides[position] = dataclasses.replace(guides[position], **changes)
        self.set_guides(guides)

    def normal_of(self, position: int):
        """Of a handle, looked up where it is taken from something."""
        return tuple(self._natives[self.guides[position]]["normal"])

    @property
    def is_guided(self) -> bool:
        return bool(self.reference or self.guides)

    @property
    def has_points(self) -> bool:
        """Whether anything tells where the surface is to be, and not only how it leans."""
        return bool(self.reference)

    def guided(self, fill):
        """A native result as it is under the guidance of now, at the cost of one solve, and its mesh. Only a guide that is
        new is looked up. Raises FairingError."""
        request = self.request
        is_known, self._followed = self._followed == (fill, request.guide), None
        made = fill.guiding(request.lambda_, request.gamma, None if is_known else json.loads(request.guide))
        self._followed = fill, request.guide
        return made, made.mesh(MESH_POINTS)

    def _read_guidance(self, obj: App.DocumentObject) -> None:
        self.reference = links.several(obj.Reference)
        self.set_guides(guide_objects.read(obj))

    def _look_guidance_up(self) -> None:
        """Again, in the coordinates of another container."""
        self._natives = {}
        self.set_reference(self.reference)
        self.set_guides(self.guides)

    def guidance_command(self) -> str:
        """The arguments of a script that say what differs from the session's object, or from no guidance."""
        before, known = [], ()
        if self.obj is not None:
            before, known = links.several(self.obj.Reference), guide_objects.read(self.obj)
        text = ""
        if self.reference != before:
            text += f", reference=[{', '.join(map(link_command, self.reference))}]"
        if self.guides != known:
            text += f", guides=[{', '.join(map(_guide_command, self.guides))}]"
        return text


def _guide_command(guide: Guide) -> str:
    values = ", ".join(f"{name!r}: {_value_command(name, value)}" for name, value in script_of(guide).items())
    return f"{{{values}}}"


def _value_command(name: str, value) -> str:
    if name == "direction":
        return link_command(value)
    if name in ("curve", "faces"):
        return f"[{', '.join(map(link_command, value))}]"
    return repr(value)
