# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a fill is asked to do, as plain data, and the one place that has it solved."""

from __future__ import annotations

import dataclasses
import hashlib
import threading
from collections import OrderedDict
from typing import Any, Mapping, Optional

from . import native, subelements

CONTINUITIES = ("G0", "G1")
ENERGIES = ("thin-plate", "membrane")
RESULTS = ("patches", "shell", "base")


@dataclasses.dataclass(frozen=True)
class FillRequest:
    """One fill: what is picked, how it is to meet its neighbours, what is minimised and how exact it has to be."""

    edges: tuple[int, ...] = ()
    faces: tuple[int, ...] = ()
    continuity: str = "G1"
    edge_continuity: tuple[tuple[int, str], ...] = ()  # only the edges that differ from `continuity`
    energy: str = "thin-plate"
    lambda_: float = 0.0  # weight of the guiding normals
    gamma: float = 0.0  # weight of the reference surface
    reference: Optional[bytes] = dataclasses.field(default=None, repr=False)  # BREP of the faces that guide
    gap_tolerance: Optional[float] = None  # mm; None: a millionth of the hole's diagonal
    angle_tolerance: float = 0.02  # degrees
    degree: int = 0  # 0: chosen from the edges
    max_poles: int = 10000
    result: str = "patches"

    @staticmethod
    def of(picks, edge_continuity: Optional[Mapping[Any, str]] = None, **options) -> "FillRequest":
        """From names such as "Edge7" or "Face3" (or edge numbers) and the other members by name."""
        picks = [picks] if isinstance(picks, (str, int)) else list(picks)
        subelements.check_names(picks)
        wishes = (edge_continuity or {}).items()
        exceptions = tuple(sorted((subelements.edge_numbers([edge])[0], word) for edge, word in wishes))
        return FillRequest(subelements.edge_numbers(picks), subelements.face_numbers(picks),
                           edge_continuity=exceptions, **options)

    def picks(self) -> list[str]:
        """The picked edges and faces by their names in FreeCAD."""
        return [f"Edge{n}" for n in self.edges] + [f"Face{n}" for n in self.faces]

    def continuity_of(self, edge: int) -> str:
        return dict(self.edge_continuity).get(edge, self.continuity)

    def differences(self, other: "FillRequest") -> dict[str, Any]:
        """Options that differ from another request's, as make_fill() takes them; picks and reference aside."""
        changed = {}
        for field in dataclasses.fields(self):
            value = getattr(self, field.name)
            if field.name not in ("edges", "faces", "reference") and value != getattr(other, field.name):
                changed[field.name] = value
        if "edge_continuity" in changed:
            changed["edge_continuity"] = {f"Edge{edge}": word for edge, word in self.edge_continuity}
        return changed

    def arguments(self) -> dict[str, Any]:
        """Keyword arguments of the native Shape.fill()."""
        return {
            "edges": list(self.edges), "faces": list(self.faces), "continuity": self.continuity,
            "edge_continuity": dict(self.edge_continuity), "energy": self.energy, "lambda_": self.lambda_,
            "gamma": self.gamma, "reference": self.reference, "tolerance": self.gap_tolerance,
            "angle": self.angle_tolerance, "degree": self.degree, "max_poles": self.max_poles, "result": self.result,
        }

    def solve(self, brep: bytes, progress=None):
        """The native Fill of this request on a shape given as BREP text.

        The last results are kept, so that OK does not compute again what the preview has shown. May be called from any
        thread; the GIL is released while solving. Raises FairingError or NativeModuleError.
        """
        key = (hashlib.sha1(brep).digest(), self)
        fill = _solved.get(key)
        if fill is None:
            fill = native.module().Shape(brep).fill(progress=progress, **self.arguments())
            _solved.put(key, fill)
        return fill


class _Recent:
    """The few results used last."""

    def __init__(self, size: int):
        self._size, self._items, self._lock = size, OrderedDict(), threading.Lock()

    def get(self, key):
        with self._lock:
            if key in self._items:
                self._items.move_to_end(key)
            return self._items.get(key)

    def put(self, key, value) -> None:
        with self._lock:
            self._items[key] = value
            while len(self._items) > self._size:
                self._items.popitem(last=False)


_solved = _Recent(size=4)
