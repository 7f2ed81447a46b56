# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filling and joining shapes from a script, without a document."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional

import Part

from . import exchange, native, subelements
from .blend_request import BlendRequest
from .choices import guide_text, triple
from .edit_request import EditRequest
from .fill_all_request import FillAllRequest
from .fill_request import FillRequest


def fill(shape: Part.Shape, edges: Iterable[subelements.Pick] = (), *, faces: Iterable[subelements.Pick] = (),
         continuity: str = "G1", edge_continuity: Optional[Mapping[Any, str]] = None,
         reference: Optional[Part.Shape] = None, guide: Any = (), through: Iterable[Any] = (),
         **options) -> tuple[Part.Shape, dict]:
    """Fills one hole of a shape. Returns the new faces and the report on them.

    edges            any edges of the hole's border, "Edge7" or 7: one is enough where the border is free
    faces            the face to be replaced, instead of edges
    continuity       "G2" meets the neighbours in curvature, "G1" tangentially, "G0" only touches them
    edge_continuity  edges that differ, {"Edge7": "G0"}
    tangents         edges met along a direction in place of a face, {"Edge7": (0, 0, 1)}
    symmetry         edges in a symmetry plane, with its normal, {"Edge9": (1, 0, 0)}
    through          points (x, y, z) and shapes whose edges and vertices the faces pass through
    reference        faces whose normals (weight lambda_) and points (weight gamma) guide the surface
    guide            normals to follow (weight lambda_): handles [{"point": (x, y, z), "normal": (x, y, z), "weight": w,
                     "radius": mm}, ...], or {"normals": handles, "field": {"n": n, "m": m, "normals": [...],
                     "weights": [...], "corners": [p00, p10, p01]}} with a field over the whole patch
    options          layout, energy, inner_continuity (how patches meet each other, "G1" or "G2"), lambda_, gamma,
                     gap_tolerance (mm), angle_tolerance (degrees), degree, max_poles, result ("patches", "shell" or
                     "base"): see choices.Choices
    Raises FairingError with one sentence where that cannot be done.
    """
    picks = _edge_names(edges) + _face_names(faces)
    request = FillRequest.of(picks, edge_continuity, continuity=continuity,
                             reference=exchange.data_of(reference) if reference else None,
                             guide=guide_text(guide), through=tuple(_through(item) for item in through), **options)
    done = request.solve(exchange.data_of(shape))
    return exchange.part_shape(done.brep()), done.report


def fill_all(shape: Part.Shape, *, skipped: Iterable[subelements.Pick] = (),
             reference: Optional[Part.Shape] = None, guide: Any = (), **options) -> tuple[Part.Shape, list[dict]]:
    """Fills every hole of a shape, side by side. Returns the new faces and a report a hole.

    skipped  edges whose holes are left out
    options  outer_borders (the rims of open sheets, too) and those of fill(), but for `through`
    A hole that cannot be filled leaves the others alone: its report is {"edges": ["Edge7", ...], "error": sentence}.
    Raises FairingError where none can be filled.
    """
    request = FillAllRequest.of(skipped, reference=exchange.data_of(reference) if reference else None,
                                guide=guide_text(guide), **options)
    done = request.solve(exchange.data_of(shape))
    reports = [dict(hole.fill.report if hole.fill else {"error": hole.error},
                    edges=[f"Edge{number}" for number in hole.edges]) for hole in done.holes]
    return exchange.part_shape(done.brep()), reports


def blend(shape: Part.Shape, from_edges: Iterable[subelements.Pick], to_edges: Iterable[subelements.Pick], *,
          continuity: str = "G1", edge_continuity: Optional[Mapping[Any, str]] = None, pairs: Iterable[Any] = (),
          ends: Iterable[subelements.Pick] = (), end_faces: Iterable[subelements.Pick] = (), ring: bool = False,
          cuts: Iterable[subelements.Pick] = (), reference: Optional[Part.Shape] = None, guide: Any = (),
          **options) -> tuple[Part.Shape, dict]:
    """Joins chains of free edges of a shape: two by one strip, three and more by a junction. Returns the new faces and
    the report on them.

    from_edges       edges the strip starts from, "Edge7" or 7: one of a smooth chain is enough
    to_edges         edges it ends at; both chains are open, or both are closed
    continuity       "G2" meets the faces beside the edges in curvature, "G1" tangentially, "G0" only touches them
    edge_continuity  edges that differ, {"Edge7": "G0"}
    pairs            vertices of both sides that belong together, [("Vertex3", "Vertex7")]
    ends             edges that join the ends of open sides: the strip meets them as it does its sides
    end_faces        faces its ends follow, "Face3" or 3: along the edges of their border, else sliding on them
    ring             whether the chains of to_edges are open ones that come to a vertex with that of from_edges, with
                     gaps between them; three and more closed chains make a junction anyway
    cuts             edges from rim to rim whose ends are those of the cuts of a junction
    reference        faces that guide, and
    guide            normals to follow: see fill()
    options          of either side, with from_ or to_ in front: reach (above 0: how far the strip goes on before it
                     turns away, 1 = what the energy likes best), reach_end (where it differs at the end of an open
                     side), departure ("free", "perpendicular" or "iso"), flip, setback (mm), curve (edges that make a
                     curve on its faces: set back to there); match ("auto", "length" or "corners"), alignment (-0.5 to
                     0.5), energy, inner_continuity ("G1" or "G2"), lambda_, gamma, gap_tolerance (mm), angle_tolerance
                     (degrees), degree, max_poles, result ("patches", "shell" or "base"): see
                     blend_request.BlendRequest
    Raises FairingError with one sentence where that cannot be done.
    """
    request = BlendRequest.of(from_edges, to_edges, edge_continuity, pairs, ends=ends, end_faces=end_faces, ring=ring,
                              cuts=cuts, continuity=continuity,
                              reference=exchange.data_of(reference) if reference else None, guide=guide_text(guide),
                              **options)
    done = request.solve(exchange.data_of(shape))
    return exchange.part_shape(done.brep()), done.report


def edit(shape: Part.Shape, face: subelements.Pick, *, reference: Optional[Part.Shape] = None, guide: Any = (),
         lambda_: float = 0.0, gamma: float = 0.0, energy: str = "thin-plate", keep: Optional[str] = None,
         degree: int = 0, spans: int = 0, result: str = "patches") -> tuple[Part.Shape, dict]:
    """Shapes one face of a shape anew, its border kept. Returns the new face and the report on it.

    face       the face, "Face3" or 3
    lambda_    weight of the guiding normals
    gamma      weight of the reference surface
    reference  faces whose normals and points guide; without any the face itself does
    guide      normals to follow in place of those: handles or a field, see fill(); a field lies over the face's own
               parameters unless it names its corners
    energy     "thin-plate" or "membrane"
    keep       what stays along the border: "G0", "G1" or "G2"; None: "G1", or "G0" for the membrane
    degree     3 to 9: raises the face's degree to it
    spans      1 to 64: splits the face into as many along each direction
    result     "patches": the new face; "shell": a shell of it; "base": the shape with the new face in its place
    Raises FairingError with one sentence where that cannot be done.
    """
    number, = subelements.face_numbers(_face_names(face)) or (0,)
    done = EditRequest(face=number, energy=energy, lambda_=lambda_, gamma=gamma,
                       reference=exchange.data_of(reference) if reference else None, guide=guide_text(guide), keep=keep,
                       degree=degree, spans=spans, result=result).solve(exchange.data_of(shape))
    return exchange.part_shape(done.brep()), done.report


def holes(shape: Part.Shape, *, outer_borders: bool = False) -> list[list[str]]:
    """The loops of free edges of a shape, each as the names of its edges in order."""
    loops = exchange.native_shape(shape).holes(outer_borders)
    return [[f"Edge{number}" for number in loop] for loop in loops]


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


def _through(item):
    return exchange.data_of(item) if isinstance(item, Part.Shape) else triple(item)


def _edge_names(picks) -> list:
    return [picks] if isinstance(picks, (str, int)) else list(picks)


def _face_names(picks) -> list[str]:
    picks = [picks] if isinstance(picks, (str, int)) else picks
    return [f"Face{pick}" if isinstance(pick, int) else pick for pick in picks]
