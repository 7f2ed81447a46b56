# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filling and joining shapes from a script, without a document."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional

import Part

from . import exchange, native, subelements
from .blend_request import BlendRequest
from .choices import ENERGIES, guide_text, triple
from .comparison import solve_each
from .edit_request import EditRequest
from .fill_all_request import FillAllRequest
from .fill_request import FillRequest
from .pictures import QUANTITIES


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
    request = _fill_request(edges, faces=faces, continuity=continuity, edge_continuity=edge_continuity,
                            reference=reference, guide=guide, through=through, **options)
    done = request.solve(exchange.data_of(shape))
    return exchange.part_shape(done.brep()), done.report


def compare(shape: Part.Shape, edges: Iterable[subelements.Pick] = (), *, energies: Iterable[str] = ENERGIES,
            faces: Iterable[subelements.Pick] = (), **options) -> list[dict]:
    """Fills one hole with one energy after the other. Returns a report each, with its "energy"; report["fairness"] has
    the values of all energies on it.

    energies  which, and in which order; all by default
    edges, faces, options  those of fill()
    One that fails leaves the others alone: its report is {"energy": ..., "error": sentence}. Raises FairingError where
    none succeeds.
    """
    return _compared(_fill_request(edges, faces=faces, **options), shape, energies)


def compare_blend(shape: Part.Shape, from_edges: Iterable[subelements.Pick], to_edges: Iterable[subelements.Pick], *,
                  energies: Iterable[str] = ENERGIES, **options) -> list[dict]:
    """The same of a blend; from_edges, to_edges and options are those of blend()."""
    return _compared(_blend_request(from_edges, to_edges, **options), shape, energies)


def curvature_picture(shape: Part.Shape, quantity: str = "mean", *, faces: Iterable[subelements.Pick] = (),
                      divisions: int = 64) -> tuple:
    """Faces as triangles with their curvature at every vertex, exact there: points (n x 3), triangles (m x 3) and
    values (n).

    quantity   "mean" (H, 1/mm), "gauss" (K, 1/mm^2), "k1", "k2" (the principal curvatures, k1 >= k2, 1/mm) or
               "mean-gradient" (|grad H|, 1/mm^2); positive where a face bends towards its normal
    faces      "Face3" or 3; none: all
    divisions  edges of triangles are no longer than the diagonal of the faces over it, up to some 200 000 points a face
    Raises ValueError for another quantity, FairingError for a face that is not there.
    """
    column = QUANTITIES.index(quantity)
    picture = exchange.native_shape(shape).curvature_picture(list(subelements.only_faces(faces)), divisions)
    points, _, triangles = picture.mesh()
    return points, triangles, picture.values()[:, column]


def show_curvature(shapes: Iterable[Any], picture: str = "mean") -> bool:
    """Opens the panel of Curvature Picture in FreeCAD's window.

    shapes   objects of the active document, or pairs of one and the names of faces: [(obj, ["Face3"])]
    picture  a quantity of curvature_picture(), or "zebra"
    False, with a message, where the panel cannot be. Raises RuntimeError without a window, ValueError for another
    picture.
    """
    import FreeCAD as App

    if not App.GuiUp:
        raise RuntimeError("Curvature is shown in FreeCAD's window: there is none. curvature_picture() gives arrays.")
    from .panels.curvature_panel import CurvaturePanel

    picks = [shape if isinstance(shape, tuple) else (shape, ()) for shape in shapes]
    return CurvaturePanel.show([(obj, list(names)) for obj, names in picks], picture)


def fill_all(shape: Part.Shape, *, skipped: Iterable[subelements.Pick] = (),
             reference: Optional[Part.Shape] = None, guide: Any = (), **options) -> tuple[Part.Shape, list[dict]]:
    """Fills every hole of a shape, side by side. Returns the new faces and a report a hole.

    skipped  edges whose holes are left out
    options  outer_borders (the rims of open sheets, too) and those of fill(), but for `through`
    A hole that cannot be filled leaves the others alone: its report is {"edges": ["Edge7", ...], "error": sentence}.
    Raises FairingError where none can be filled.
    """
    request = FillAllRequest.of(skipped, **_guidance(reference, guide), **options)
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
    request = _blend_request(from_edges, to_edges, continuity=continuity, edge_continuity=edge_continuity, pairs=pairs,
                             ends=ends, end_faces=end_faces, ring=ring, cuts=cuts, reference=reference, guide=guide,
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
    done = EditRequest(face=number, energy=energy, lambda_=lambda_, gamma=gamma, keep=keep, degree=degree, spans=spans,
                       result=result, **_guidance(reference, guide)).solve(exchange.data_of(shape))
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


def _blend_request(from_edges, to_edges, *, edge_continuity=None, pairs=(), reference=None, guide=(),
                   **options) -> BlendRequest:
    return BlendRequest.of(from_edges, to_edges, edge_continuity, pairs, **_guidance(reference, guide), **options)


def _compared(request, shape: Part.Shape, energies: Iterable[str]) -> list[dict]:
    solved = list(solve_each(request, exchange.data_of(shape), energies))
    if solved and not any(item.fill for item in solved):
        raise solved[0].error
    return [item.report() for item in solved]


def _fill_request(edges, *, faces=(), edge_continuity=None, reference=None, guide=(), through=(),
                  **options) -> FillRequest:
    return FillRequest.of(_edge_names(edges) + _face_names(faces), edge_continuity,
                          **_guidance(reference, guide),
                          through=tuple(_through(item) for item in through), **options)


def _guidance(reference: Optional[Part.Shape], guide) -> dict:
    """As requests have it."""
    return {"reference": exchange.data_of(reference) if reference else None, "guide": guide_text(guide)}


def _through(item):
    return exchange.data_of(item) if isinstance(item, Part.Shape) else triple(item)


def _edge_names(picks) -> list:
    return [picks] if isinstance(picks, (str, int)) else list(picks)


def _face_names(picks) -> list[str]:
    picks = [picks] if isinstance(picks, (str, int)) else picks
    return [f"Face{pick}" if isinstance(pick, int) else pick for pick in picks]
