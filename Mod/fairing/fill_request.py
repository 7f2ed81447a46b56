# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the fill of one hole is asked to do, and the one place that has it solved."""

from __future__ import annotations

import dataclasses
from typing import Any, Mapping, Optional, Union

from . import native, subelements
from .choices import SOLVED, Choices, Triple, by_edge

Through = Union[bytes, Triple]  # BREP of edges and vertices, or a point


@dataclasses.dataclass(frozen=True)
class FillRequest(Choices):
    """One fill: what is picked, what it passes through, and the choices."""

    edges: tuple[int, ...] = ()
    faces: tuple[int, ...] = ()
    through: tuple[Through, ...] = dataclasses.field(default=(), repr=False)

    NOT_SCRIPTED = ("edges", "faces", "through", "reference", "guide")

    @staticmethod
    def of(picks, edge_continuity: Optional[Mapping[Any, str]] = None, tangents=None, symmetry=None,
           **options) -> "FillRequest":
        """From names such as "Edge7" or "Face3" (or edge numbers) and the other members by name."""
        picks = [picks] if isinstance(picks, (str, int)) else list(picks)
        subelements.check_names(picks)
        return FillRequest(edges=subelements.edge_numbers(picks), faces=subelements.face_numbers(picks),
                           edge_continuity=by_edge(edge_continuity), tangents=by_edge(tangents),
                           symmetry=by_edge(symmetry), **options)

    def picks(self) -> list[str]:
        """The picked edges and faces by their names in FreeCAD."""
        return [f"Edge{n}" for n in self.edges] + [f"Face{n}" for n in self.faces]

    def loop_arguments(self) -> dict[str, Any]:
        """Keyword arguments of the native Shape.boundary()."""
        return {"edges": list(self.edges), "faces": list(self.faces), "continuity": self.continuity,
                "edge_continuity": dict(self.edge_continuity), "tangents": dict(self.tangents),
                "symmetry": dict(self.symmetry)}

    def arguments(self) -> dict[str, Any]:
        """Keyword arguments of the native Shape.fill()."""
        return {**self.common_arguments(), **self.loop_arguments(), "through": list(self.through)}

    def solve(self, brep: bytes, progress=None):
        """The native Fill of this request on a shape given as BREP text.

        May be called from any thread; the GIL is released while solving. Raises FairingError or NativeModuleError.
        """
        return SOLVED.get_or_make(
            brep, self, lambda progress: native.module().Shape(brep).fill(progress=progress, **self.arguments()), progress)
