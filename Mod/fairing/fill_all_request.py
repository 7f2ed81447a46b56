# SPDX-License-Identifier: LGPL-2.1-or-later
"""What filling all holes of a shape is asked to do, and the one place that has it solved."""

from __future__ import annotations

import dataclasses
from typing import Any

from . import native, subelements
from .choices import SOLVED, Choices, by_edge


@dataclasses.dataclass(frozen=True)
class FillAllRequest(Choices):
    """Which holes, and the choices for all of them."""

    outer_borders: bool = False
    skipped: tuple[int, ...] = ()  # holes that have one of these edges are left out

    @staticmethod
    def of(skipped=(), edge_continuity=None, tangents=None, symmetry=None, **options) -> "FillAllRequest":
        """From names such as "Edge7" (or edge numbers) and the other members by name."""
        return FillAllRequest(skipped=tuple(sorted(subelements.edge_numbers(skipped))),
                              edge_continuity=by_edge(edge_continuity), tangents=by_edge(tangents),
                              symmetry=by_edge(symmetry), **options)

    def skipped_names(self) -> list[str]:
        return [f"Edge{number}" for number in self.skipped]

    def arguments(self) -> dict[str, Any]:
        """Keyword arguments of the native Shape.fill_all()."""
        return {**self.common_arguments(), "outer_borders": self.outer_borders, "skipped": set(self.skipped)}

    def solve(self, brep: bytes, progress=None):
        """The native FillAll of this request on a shape given as BREP text.

        May be called from any thread; the GIL is released while solving. Raises FairingError or NativeModuleError.
        """
        return SOLVED.get_or_make(
            brep, self, lambda progress: native.module().Shape(brep).fill_all(progress=progress, **self.arguments()),
            progress)
