# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a blend between two chains of edges is asked to do, and the one place that has it solved."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterable, Mapping, Optional

from . import native, subelements
from .choices import SOLVED, Choices, by_edge


@dataclasses.dataclass(frozen=True)
class BlendRequest:
    """One blend: the picks of either side, and the choices."""

    from_edges: tuple[int, ...] = ()
    to_edges: tuple[int, ...] = ()
    continuity: str = Choices.continuity
    edge_continuity: tuple[tuple[int, str], ...] = ()  # only the edges that differ from `continuity`
    from_reach: float = 1.0  # above 0: how far the strip goes on before it turns away; 1: what the energy likes best
    to_reach: float = 1.0
    from_reach_end: Optional[float] = None  # of an open side: the reach grows to it linearly; None: the same
    to_reach_end: Optional[float] = None
    from_departure: str = "free"  # the strip leaves "free", "perpendicular" to the edge, or along "iso" curves
    to_departure: str = "free"
    from_flip: bool = False  # leaves that side the other way, over its face
    to_flip: bool = False
    from_setback: float = 0.0  # mm into the faces of that side, which are trimmed back to there
    to_setback: float = 0.0
    energy: str = Choices.energy
    gap_tolerance: Optional[float] = None  # mm; None: a millionth of the diagonal of both chains
    angle_tolerance: float = Choices.angle_tolerance  # degrees
    degree: int = 0  # 0: chosen from the edges
    max_poles: int = Choices.max_poles
    result: str = Choices.result

    @staticmethod
    def of(from_edges: Iterable[subelements.Pick], to_edges: Iterable[subelements.Pick],
           edge_continuity: Optional[Mapping[Any, str]] = None, **options) -> "BlendRequest":
        """From names such as "Edge7" (or edge numbers) and the other members by name. Raises ValueError with a name
        that is no edge's."""
        return BlendRequest(from_edges=subelements.only_edges(from_edges), to_edges=subelements.only_edges(to_edges),
                            edge_continuity=by_edge(edge_continuity), **options)

    def arguments(self) -> dict[str, Any]:
        """Keyword arguments of the native Shape.blend()."""
        return {"from_edges": list(self.from_edges), "to_edges": list(self.to_edges), "continuity": self.continuity,
                "edge_continuity": dict(self.edge_continuity), "from_reach": self.from_reach,
                "to_reach": self.to_reach, "from_reach_end": self.from_reach_end, "to_reach_end": self.to_reach_end,
                "from_departure": self.from_departure, "to_departure": self.to_departure,
                "from_flip": self.from_flip, "to_flip": self.to_flip,
                "from_setback": self.from_setback, "to_setback": self.to_setback, "energy": self.energy,
                "tolerance": self.gap_tolerance, "angle": self.angle_tolerance, "degree": self.degree,
                "max_poles": self.max_poles, "result": self.result}

    def solve(self, brep: bytes, progress=None):
        """The native Fill of this request on a shape given as BREP text.

        May be called from any thread; the GIL is released while solving. Raises FairingError or NativeModuleError.
        """
        return SOLVED.get_or_make(
            brep, self, lambda: native.module().Shape(brep).blend(progress=progress, **self.arguments()))
