# SPDX-License-Identifier: LGPL-2.1-or-later
"""What may be chosen about any fill, one hole or all of them, as plain data; and the results solved last."""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import json
import threading
from collections import OrderedDict
from typing import Any, Mapping, Optional

from . import subelements

# The words documents, files and scripts store: change none, add only. The first one is what a new property shows.
CONTINUITIES = ("G0", "G1", "G2")
LAYOUTS = ("auto", "quad", "star", "o-grid", "trimmed")
ENERGIES = ("thin-plate", "membrane", "mean-curvature-gradient", "mean-curvature-gradient-minimum", "minimum-variation",
            "total-curvature", "triharmonic")
INNER = ("G1", "G2")  # how patches meet each other
LONG_ENERGIES = ("mean-curvature-gradient-minimum", "minimum-variation", "total-curvature")  # by steps, to the end
RESULTS = ("patches", "shell", "base")
EDIT_ENERGIES = ("thin-plate", "membrane")  # of an edit
KEEPS = ("auto", *CONTINUITIES)  # what an edit keeps of a border

DEPARTURES = ("free", "perpendicular", "iso")
MATCHES = ("auto", "length", "corners")

BY_EDGE = ("edge_continuity", "tangents", "symmetry")  # members that belong to single edges

Triple = tuple[float, float, float]


@dataclasses.dataclass(frozen=True)
class Choices:
    """How edges are to be met, what is minimised and how exact it has to be."""

    continuity: str = "G1"
    edge_continuity: tuple[tuple[int, str], ...] = ()  # only the edges that differ from `continuity`
    tangents: tuple[tuple[int, Triple], ...] = ()  # edges met along a direction in place of a face
    symmetry: tuple[tuple[int, Triple], ...] = ()  # edges in a symmetry plane, with its normal
    layout: str = "auto"
    energy: str = "mean-curvature-gradient"
    inner_continuity: str = "G1"  # how patches meet each other
    lambda_: float = 0.0  # weight of the guiding normals
    gamma: float = 0.0  # weight of the reference surface
    reference: Optional[bytes] = dataclasses.field(default=None, repr=False)  # BREP of the faces that guide
    guide: str = dataclasses.field(default="[]", repr=False)  # JSON: handles, a field
    gap_tolerance: Optional[float] = None  # mm; None: a millionth of the hole's diagonal
    angle_tolerance: float = 0.02  # degrees
    degree: int = 0  # 0: chosen from the edges
    max_poles: int = 2500
    result: str = "patches"

    NOT_SCRIPTED = ("reference", "guide")  # members that scripts give in another way

    def continuity_of(self, edge: int) -> str:
        return dict(self.edge_continuity).get(edge, self.continuity)

    def differences(self, other: "Choices") -> dict[str, Any]:
        """Choices that differ from another request's, as scripts give them."""
        changed = {}
        for field in dataclasses.fields(self):
            value = getattr(self, field.name)
            if field.name not in self.NOT_SCRIPTED and value != getattr(other, field.name):
                in_pairs = field.name in BY_EDGE
                changed[field.name] = {f"Edge{edge}": wish for edge, wish in value} if in_pairs else value
        return changed

    def common_arguments(self) -> dict[str, Any]:
        """Keyword arguments that the native fill() and fill_all() share."""
        return {
            "continuity": self.continuity, "edge_continuity": dict(self.edge_continuity),
            "tangents": dict(self.tangents), "symmetry": dict(self.symmetry), "layout": self.layout,
            "energy": self.energy, "inner_continuity": self.inner_continuity, "lambda_": self.lambda_,
            "gamma": self.gamma, "reference": self.reference, "guide": json.loads(self.guide),
            "tolerance": self.gap_tolerance, "angle": self.angle_tolerance, "degree": self.degree,
            "max_poles": self.max_poles, "result": self.result,
        }


def by_edge(wishes: Optional[Mapping[Any, Any]]) -> tuple:
    """{"Edge7": wish} or {7: wish} as pairs by ascending edge number; vectors become tuples."""
    pairs = ((subelements.edge_numbers([edge])[0], wish) for edge, wish in (wishes or {}).items())
    return tuple(sorted((edge, wish if isinstance(wish, str) else triple(wish)) for edge, wish in pairs))


def with_pairs(changes: Mapping[str, Any]) -> dict[str, Any]:
    """Changes as scripts give them, with what belongs to single edges as pairs."""
    return {name: by_edge(value) if name in BY_EDGE else value for name, value in changes.items()}


def triple(vector) -> Triple:
    """A vector as three plain numbers. Raises ValueError where it is none."""
    numbers = tuple(float(number) for number in vector)
    if len(numbers) != 3:
        raise ValueError(f"{vector!r} is no point or direction: three numbers are needed")
    return numbers


def guide_text(guide: Any) -> str:
    """Handles, or a dict with handles and a field, as JSON: sequences of any kind become lists."""
    return json.dumps(guide, default=list)


class Recent:
    """The few results used last, so that OK does not compute again what the preview has shown. Any thread may ask."""

    def __init__(self, size: int):
        self._size, self._items, self._lock = size, OrderedDict(), threading.Lock()
        self._taken: dict = {}

    def get_or_make(self, brep: bytes, request: Choices, make, progress=None):
        """The result of a request on a shape; where it is not known it is made, by make(progress). One that was stopped
        for the best so far is not kept: who asks again is to have all of it."""
        key = _key(request, brep)
        with self._lock:
            if key in self._taken:
                return self._taken[key]
            if key in self._items:
                self._items.move_to_end(key)
                return self._items[key]
        made = make(progress)
        if progress is not None and progress.finishing:
            return made
        with self._lock:
            self._items[key] = made
            while len(self._items) > self._size:
                self._items.popitem(last=False)
        return made

    @contextlib.contextmanager
    def taking(self, request: Choices, brep: bytes, result):
        """While it lasts, a result answers a request, even one that was stopped: what the user sees is what OK takes."""
        key = _key(request, brep)
        with self._lock:
            self._taken[key] = result
        try:
            yield
        finally:
            with self._lock:
                del self._taken[key]


def _key(request: Choices, brep: bytes):
    return hashlib.sha1(brep).digest(), request


SOLVED = Recent(size=len(ENERGIES) + 2)  # a comparison, and what was before it
