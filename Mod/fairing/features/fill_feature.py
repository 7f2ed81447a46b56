# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric fill: a Part::FeaturePython that fills a hole of another object and keeps the numbers."""

from __future__ import annotations

import dataclasses
from typing import Iterable, Optional

import FreeCAD as App

from .. import exchange, subelements
from ..choices import with_pairs
from ..fill_request import FillRequest
from . import fill_properties as properties, links
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
              through=(), **options) -> App.DocumentObject:
    """Makes a fill of one hole of the base beside it in the document, computed.

    picks      names of edges of the hole's border, ["Edge7"]: one is enough; or the face to be replaced
    reference  an object, or (object, ["Face1", ...]), whose faces guide by the weights lambda_ and gamma
    through    objects, or (object, ["Vertex1", "Edge3", ...]), that the surface passes through
    options    continuity, edge_continuity, tangents, symmetry, layout, energy, lambda_, gamma, gap_tolerance (mm),
               angle_tolerance (degrees), degree, max_poles, result: see fairing.fill()
    Raises FairingError (or NativeModuleError) with one sentence, and then the document is as it was.
    """
    container = container_for_results(base)
    request = FillRequest.of(picks, reference=links.reference_data(reference, container),
                             through=links.through_data(through, container), **options)
    solve(request, base, container)
    obj = base.Document.addObject("Part::FeaturePython", name)
    if container:
        container.addObject(obj)
    FillFeature(obj)
    properties.write_request(obj, request, base, links.link_of(reference), links.links_of(through))
    if App.GuiUp:
        from ..views.fill_view import FillView

        FillView(obj.ViewObject)
    obj.Document.recompute([obj])
    return obj


def change_fill(obj: App.DocumentObject, picks: Optional[Iterable[subelements.Pick]] = None, *, base=None,
                **changes) -> App.DocumentObject:
    """Changes some choices of a fill (those of make_fill) and computes it again; the others stay as they are.

    Raises FairingError with one sentence, and then the object is as it was.
    """
    container, base = container_of(obj), base or (obj.Edges[0] if obj.Edges else None)
    reference = links.link_of(changes.pop("reference", obj.Reference))
    through = links.links_of(changes.pop("through", obj.Through))
    request = dataclasses.replace(
        properties.read_request(obj), reference=links.reference_data(reference, container),
        through=links.through_data(through, container), **with_pairs(changes))
    if picks is not None:
        fresh = FillRequest.of(picks)
        request = dataclasses.replace(request, edges=fresh.edges, faces=fresh.faces)
    solve(request, base, container)
    properties.write_request(obj, request, base, reference, through)
    obj.Document.recompute([obj])
    return obj


def solve(request: FillRequest, base: App.DocumentObject, container):
    """The native Fill of a request in a container's coordinates. Raises ValueError, FairingError, NativeModuleError."""
    if base is None or not (request.edges or request.faces):
        raise ValueError(NOTHING_PICKED)
    return request.solve(exchange.data_of(shape_in(container, base)))
