# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric fill: a Part::FeaturePython that fills a hole of another object and keeps the numbers."""

from __future__ import annotations

import dataclasses
from typing import Iterable, Optional

import FreeCAD as App

from .. import exchange, subelements
from ..choices import with_pairs
from ..fill_request import FillRequest
from . import fill_properties as properties, guide_objects, links
from .guides import guides_of, native_text
from .placement import container_for_results, container_of, shape_in
from .solved_feature import SolvedFeature

NOTHING_PICKED = "No edge is picked: pick an edge of the hole, or the face to be replaced."


class FillFeature(SolvedFeature):
    """Proxy of a fill."""

    TYPE = "Fill"
    properties = properties

    def solve(self, obj: App.DocumentObject):
        base = obj.Edges[0] if obj.Edges else None
        return solve(properties.read_request(obj), base, container_of(obj))


def make_fill(base: App.DocumentObject, picks: Iterable[subelements.Pick], *, name: str = "Fill", reference=None,
              guides=(), through=(), **options) -> App.DocumentObject:
    """Makes a fill of one hole of the base beside it in the document, computed.

    picks      names of edges of the hole's border, ["Edge7"]: one is enough; or the face to be replaced
    reference  an object, (object, ["Face1", ...]), or a list of these: faces and meshes that guide by the weights
               lambda_ and gamma
    guides     handles {"point": (x, y, z), "normal": (x, y, z), "radius": mm, "weight": 1.0}, with "direction": (object,
               "Face1") in place of a normal where a face, an edge or a datum tells it; feature curves {"curve":
               (object, ["Edge3"]), "radius": mm}, with "faces" or a "normal" in place of the faces beside the edges
    through    objects, or (object, ["Vertex1", "Edge3", ...]), that the surface passes through
    options    continuity, edge_continuity, tangents, symmetry, layout, energy, lambda_, gamma, gap_tolerance (mm),
               angle_tolerance (degrees), degree, max_poles, result: see fairing.fill()
    Raises FairingError (or NativeModuleError) with one sentence, and then the document is as it was.
    """
    container, guides = container_for_results(base), guides_of(guides)
    request = FillRequest.of(picks, reference=links.reference_data(reference, container),
                             guide=native_text(guides, container), through=links.through_data(through, container),
                             **options)
    solve(request, base, container)
    obj = base.Document.addObject("Part::FeaturePython", name)
    if container:
        container.addObject(obj)
    FillFeature(obj)
    properties.write_request(obj, request, base, links.several(reference), links.links_of(through))
    guide_objects.write(obj, guides)
    if App.GuiUp:
        from ..views.fill_view import FillView

        FillView(obj.ViewObject)
    obj.Document.recompute([obj])
    return obj


def change_fill(obj: App.DocumentObject, picks: Optional[Iterable[subelements.Pick]] = None, *, base=None,
                **changes) -> App.DocumentObject:
    """Changes some choices of a fill (those of make_fill) and computes it again; the others stay as they are. Of guides
    those that have the "name" of one of its guides change it.

    Raises FairingError with one sentence, and then the object is as it was.
    """
    container, base = container_of(obj), base or (obj.Edges[0] if obj.Edges else None)
    reference = links.several(changes.pop("reference", obj.Reference))
    guides = guides_of(changes.pop("guides", guide_objects.read(obj)))
    through = links.links_of(changes.pop("through", obj.Through))
    request = dataclasses.replace(
        properties.read_request(obj), reference=links.reference_data(reference, container),
        guide=native_text(guides, container), through=links.through_data(through, container), **with_pairs(changes))
    if picks is not None:
        fresh = FillRequest.of(picks)
        request = dataclasses.replace(request, edges=fresh.edges, faces=fresh.faces)
    solve(request, base, container)
    properties.write_request(obj, request, base, reference, through)
    guide_objects.write(obj, guides)
    obj.Document.recompute([obj])
    return obj


def solve(request: FillRequest, base: App.DocumentObject, container):
    """The native Fill of a request in a container's coordinates. Raises ValueError, FairingError, NativeModuleError."""
    if base is None or not (request.edges or request.faces):
        raise ValueError(NOTHING_PICKED)
    return request.solve(exchange.data_of(shape_in(container, base)))
