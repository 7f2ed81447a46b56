# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filling shapes from a script, without a document."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional

import Part

from . import exchange, native, subelements
from .fill_request import FillRequest


def fill(shape: Part.Shape, edges: Iterable[subelements.Pick] = (), *, faces: Iterable[subelements.Pick] = (),
         continuity: str = "G1", edge_continuity: Optional[Mapping[Any, str]] = None,
         reference: Optional[Part.Shape] = None, **options) -> tuple[Part.Shape, dict]:
    """Fills one hole of a shape. Returns the new faces and the report on them.

    edges            any edges of the hole's border, "Edge7" or 7: one is enough where the border is free
    faces            the face to be replaced, instead of edges
    continuity       "G1" meets the neighbours tangentially, "G0" only touches them
    edge_continuity  edges that differ, {"Edge7": "G0"}
    reference        faces whose normals (weight lambda_) and points (weight gamma) guide the surface
    options          energy, lambda_, gamma, gap_tolerance (mm), angle_tolerance (degrees), degree, max_poles,
                     result ("patches", "shell" or "base"): see FillRequest
    Raises FairingError with one sentence where that cannot be done.
    """
    picks = _edge_names(edges) + _face_names(faces)
    request = FillRequest.of(picks, edge_continuity, continuity=continuity,
                             reference=exchange.data_of(reference) if reference else None, **options)
    done = request.solve(exchange.data_of(shape))
    return exchange.part_shape(done.brep()), done.report


def holes(shape: Part.Shape) -> list[list[str]]:
    """The loops of free edges of a shape, each as the names of its edges in order."""
    return [[f"Edge{number}" for number in loop] for loop in exchange.native_shape(shape).holes()]


def report(shape: Part.Shape, patches: Part.Shape, edges: Iterable[subelements.Pick] = (), *,
           faces: Iterable[subelements.Pick] = (), continuity: str = "G1",
           edge_continuity: Optional[Mapping[Any, str]] = None, gap_tolerance: Optional[float] = None,
           angle_tolerance: float = 0.02) -> dict:
    """Measures any faces against the hole they are meant to fill; the arguments are those of fill()."""
    request = FillRequest.of(_edge_names(edges) + _face_names(faces), edge_continuity, continuity=continuity)
    return exchange.native_shape(shape).measure(
        native.module().Shape(exchange.data_of(patches)), edges=list(request.edges), faces=list(request.faces),
        continuity=continuity, edge_continuity=dict(request.edge_continuity), tolerance=gap_tolerance,
        angle=angle_tolerance)


def _edge_names(picks) -> list:
    return [picks] if isinstance(picks, (str, int)) else list(picks)


def _face_names(picks) -> list[str]:
    picks = [picks] if isinstance(picks, (str, int)) else picks
    return [f"Face{pick}" if isinstance(pick, int) else pick for pick in picks]
