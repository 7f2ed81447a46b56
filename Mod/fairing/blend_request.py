# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a blend between two chains of edges is asked to do, and the one place that has it solved."""

from __future__ import annotations

import dataclasses
import json
from typing import Any, Iterable, Mapping, Optional

from . import native, subelements
from .choices import DEPARTURES, MATCHES, SOLVED, Choices, by_edge

NATIVE_NAMES = {"gap_tolerance": "tolerance", "angle_tolerance": "angle"}


@dataclasses.dataclass(frozen=True)
class BlendRequest:
    """One blend: the picks of either side, and the choices."""

    from_edges: tuple[int, ...] = ()
    to_edges: tuple[int, ...] = ()
    continuity: str = Choices.continuity
    edge_continuity: tuple[tuple[int, str], ...] = ()  # only the edges that differ from `continuity`
    from_reach: float = 1.0  # above 0: how far the strip goes on before it turns away; 1: what the energy likes best
    to_reach: float = 1.0
    from_reach_end: Optional[float] = None  # at the end of an open side, linear between; None: as at its start
    to_reach_end: Optional[float] = None
    from_departure: str = DEPARTURES[0]  # direction in which the strip leaves the edges
    to_departure: str = DEPARTURES[0]
    from_flip: bool = False  # leave that side the other way, over its face
    to_flip: bool = False
    from_setback: float = 0.0  # mm, how far inside the faces the strip starts
    to_setback: float = 0.0
    from_curve: tuple[int, ...] = ()  # edges of the curve in the faces where the strip starts instead
    to_curve: tuple[int, ...] = ()
    match: str = MATCHES[0]  # which points of the sides belong together
    alignment: float = 0.0  # -0.5 to 0.5, turns closed sides against each other
    pairs: tuple[tuple[int, int], ...] = ()  # vertices of both sides that belong together
    ends: tuple[int, ...] = ()  # edges that join the ends of open sides
    end_faces: tuple[int, ...] = ()  # faces that these ends follow
    ring: bool = False  # the chains of to_edges are open and come to a vertex with that of from_edges
    cuts: tuple[int, ...] = ()  # edges from rim to rim that show where a junction is cut
    energy: str = Choices.energy
    inner_continuity: str = Choices.inner_continuity
    lambda_: float = 0.0  # weight of the guiding normals
    gamma: float = 0.0  # weight of the reference surface
    reference: Optional[bytes] = dataclasses.field(default=None, repr=False)  # BREP of the faces that guide
    guide: str = dataclasses.field(default="[]", repr=False)  # JSON: handles, curves
    gap_tolerance: Optional[float] = None  # mm; None: a millionth of the diagonal of both chains
    angle_tolerance: float = Choices.angle_tolerance  # degrees
    degree: int = 0  # 0: chosen from the edges
    max_poles: int = Choices.max_poles
    result: str = Choices.result

    @staticmethod
    def of(from_edges: Iterable[subelements.Pick], to_edges: Iterable[subelements.Pick],
           edge_continuity: Optional[Mapping[Any, str]] = None, pairs: Iterable[Any] = (),
           from_curve: Iterable[subelements.Pick] = (), to_curve: Iterable[subelements.Pick] = (),
           ends: Iterable[subelements.Pick] = (), end_faces: Iterable[subelements.Pick] = (),
           cuts: Iterable[subelements.Pick] = (), **options) -> "BlendRequest":
        """From names such as "Edge7" and "Face3" (or numbers), pairs such as ("Vertex3", "Vertex7"), and the other
        members by name. Raises ValueError with a name that is no edge's, no face's, or no vertex's."""
        return BlendRequest(from_edges=subelements.only_edges(from_edges), to_edges=subelements.only_edges(to_edges),
                            from_curve=subelements.only_edges(from_curve),
                            to_curve=subelements.only_edges(to_curve), edge_continuity=by_edge(edge_continuity),
                            pairs=tuple(map(subelements.vertex_pair, pairs)), ends=subelements.only_edges(ends),
                            end_faces=subelements.only_faces(end_faces), cuts=subelements.only_edges(cuts), **options)

    def arguments(self) -> dict[str, Any]:
        """Keyword arguments of the native Shape.blend()."""
        given = dataclasses.asdict(self)
        lists = ("from_edges", "to_edges", "from_curve", "to_curve", "pairs", "ends", "end_faces", "cuts")
        given.update({name: list(given[name]) for name in lists}, edge_continuity=dict(self.edge_continuity),
                     guide=json.loads(self.guide))
        return {NATIVE_NAMES.get(name, name): value for name, value in given.items()}

    def solve(self, brep: bytes, progress=None):
        """The native Fill of this request on a shape given as BREP text.

        May be called from any thread; the GIL is released while solving. Raises FairingError or NativeModuleError.
        """
        return SOLVED.get_or_make(
            brep, self, lambda progress: native.module().Shape(brep).blend(progress=progress, **self.arguments()), progress)
