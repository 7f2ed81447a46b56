# SPDX-License-Identifier: LGPL-2.1-or-later
"""One request solved with several energies."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterable, Iterator, Optional

from .choices import ENERGIES


@dataclasses.dataclass(frozen=True)
class Solved:
    """What became of it with one energy: a native Fill, or why there is none."""

    energy: str
    fill: Any = None
    error: Optional[Exception] = None

    def report(self) -> dict:
        return {**(self.fill.report if self.fill else {"error": str(self.error)}), "energy": self.energy}


def solve_each(request, brep: bytes, energies: Iterable[str] = ENERGIES, progress=None) -> Iterator[Solved]:
    """One after the other. A native Progress that is aborted ends it; an energy that fails leaves the others alone.
    Raises NativeModuleError."""
    for energy in energies:
        try:
            yield Solved(energy, dataclasses.replace(request, energy=energy).solve(brep, progress))
        except ValueError as error:
            if progress is not None and progress.aborted:
                return
            yield Solved(energy, error=error)


def largest_angle(report: dict) -> float:
    return max(report["largest_angle"], report["largest_corner_angle"])


def asks_for_curvature(report: dict) -> bool:
    return any(side["asked"] == "G2" for side in report["sides"])
