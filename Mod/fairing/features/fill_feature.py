# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric fill: a Part::FeaturePython that fills a hole of another object and keeps the numbers."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterable, Mapping, Optional

import FreeCAD as App

from .. import exchange, migrate, subelements
from ..fill_request import FillRequest
from . import fill_properties as properties
from .placement import container_for_results, container_of, shape_in

NOTHING_PICKED = "No edge is picked: pick an edge of the hole, or the face to be replaced."


class FillFeature:
    """Proxy of a fill."""

    TYPE = "Fill"  # stored with the object, see migrate.py

    def __init__(self, obj: App.DocumentObject):
        migrate.mark(obj, self.TYPE)
        properties.add_properties(obj)
        obj.Proxy = self

    def execute(self, obj: App.DocumentObject) -> None:
        """Solves and measures. Where that fails the last good shape stays, and the verdict says why."""
        try:
            base = obj.Edges[0] if obj.Edges else None
            fill = solve(properties.read_request(obj), base, container_of(obj))
        except (ValueError, RuntimeError) as error:  # FairingError is a ValueError, NativeModuleError a RuntimeError
            properties.write_failure(obj, str(error))
            raise
        obj.Shape = exchange.part_shape(fill.brep())
        properties.write_report(obj, fill)
        if not fill.within_tolerance:
            App.Console.PrintWarning(f"{obj.Label}: {fill.verdict}\n")

    def onDocumentRestored(self, obj: App.DocumentObject) -> None:
        migrate.update(obj)
        properties.add_properties(obj)

    # Nothing of the proxy itself is saved. FreeCAD 0.20 calls the second pair of names, later versions the first.
    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads


def make_fill(base: App.DocumentObject, picks: Iterable[subelements.Pick], *, name: str = "Fill",
              edge_continuity: Optional[Mapping[Any, str]] = None, reference=None, **options) -> App.DocumentObject:
    """Makes a fill of one hole of the base beside it in the document, computed.

    picks            names of edges of the hole's border, ["Edge7"]: one is enough; or the face to be replaced
    edge_continuity  edges that differ from `continuity`, {"Edge7": "G0"}
    reference        an object, or (object, ["Face1", ...]), whose faces guide by the weights lambda_ and gamma
    options          continuity, energy, lambda_, gamma, gap_tolerance (mm), angle_tolerance (degrees), degree,
                     max_poles, result: see fairing.fill()
    Raises FairingError (or NativeModuleError) with one sentence, and then the document is as it was.
    """
    container = container_for_results(base)
    request = FillRequest.of(picks, edge_continuity, reference=reference_data(reference, container), **options)
    solve(request, base, container)
    obj = base.Document.addObject("Part::FeaturePython", name)
    if container:
        container.addObject(obj)
    FillFeature(obj)
    properties.write_request(obj, request, base, reference_link(reference))
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
    link = reference_link(changes.pop("reference", obj.Reference))
    exceptions = changes.pop("edge_continuity", None)
    request = dataclasses.replace(properties.read_request(obj), reference=reference_data(link, container), **changes)
    if picks is not None:
        fresh = FillRequest.of(picks)
        request = dataclasses.replace(request, edges=fresh.edges, faces=fresh.faces)
    if exceptions is not None:
        request = dataclasses.replace(request, edge_continuity=FillRequest.of((), exceptions).edge_continuity)
    solve(request, base, container)
    properties.write_request(obj, request, base, link)
    obj.Document.recompute([obj])
    return obj


def solve(request: FillRequest, base: App.DocumentObject, container):
    """The native Fill of a request in a container's coordinates. Raises ValueError, FairingError, NativeModuleError."""
    if base is None or not (request.edges or request.faces):
        raise ValueError(NOTHING_PICKED)
    return request.solve(exchange.data_of(shape_in(container, base)))


def reference_link(reference):
    """(object, [names]) out of what a caller may give for a reference, or None."""
    if not reference:
        return None
    obj, names = reference if isinstance(reference, (tuple, list)) else (reference, ())
    return obj, [name for name in names if name]


def reference_data(reference, container) -> Optional[bytes]:
    """The faces of a reference as the native module reads them, in a container's coordinates, or None."""
    link = reference_link(reference)
    return exchange.data_of(shape_in(container, *link)) if link else None
