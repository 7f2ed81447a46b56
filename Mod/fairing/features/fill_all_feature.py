# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric object that fills every hole of another object and keeps the numbers, hole by hole."""

from __future__ import annotations

import dataclasses

import FreeCAD as App

from .. import exchange, subelements
from ..choices import with_pairs
from ..fill_all_request import FillAllRequest
from . import fill_all_properties as properties, links
from .placement import container_for_results, container_of, shape_in
from .solved_feature import SolvedFeature

NO_BASE = "No object is chosen: select the object whose holes are to be filled."


class FillAllFeature(SolvedFeature):
    """Proxy of an object that fills all holes."""

    TYPE = "FillAll"
    properties = properties

    def solve(self, obj: App.DocumentObject):
        return solve(properties.read_request(obj), obj.Base, container_of(obj))


def make_fill_all(base: App.DocumentObject, *, name: str = "FillAll", skipped=(), reference=None,
                  **options) -> App.DocumentObject:
    """Makes an object that fills every hole of the base beside it in the document, computed.

    skipped    names of edges whose holes are left out
    reference  an object, (object, ["Face1", ...]), or a list of these: faces and meshes that guide by the weights
               lambda_ and gamma
    options    outer_borders (the rims of open sheets, too) and the choices of make_fill()
    Raises FairingError (or NativeModuleError) with one sentence, and then the document is as it was.
    """
    container = container_for_results(base)
    request = FillAllRequest.of(skipped, reference=links.reference_data(reference, container), **options)
    solve(request, base, container)
    obj = base.Document.addObject("Part::FeaturePython", name)
    if container:
        container.addObject(obj)
    FillAllFeature(obj)
    properties.write_request(obj, request, base, links.several(reference))
    if App.GuiUp:
        from ..views.fill_all_view import FillAllView

        FillAllView(obj.ViewObject)
    obj.Document.recompute([obj])
    return obj


def change_fill_all(obj: App.DocumentObject, *, base=None, **changes) -> App.DocumentObject:
    """Changes some choices (those of make_fill_all) and computes the object again; the others stay as they are.

    Raises FairingError with one sentence, and then the object is as it was.
    """
    container, base = container_of(obj), base or obj.Base
    reference = links.several(changes.pop("reference", obj.Reference))
    if "skipped" in changes:
        changes["skipped"] = tuple(sorted(subelements.edge_numbers(changes["skipped"])))
    request = dataclasses.replace(properties.read_request(obj), reference=links.reference_data(reference, container),
                                  **with_pairs(changes))
    solve(request, base, container)
    properties.write_request(obj, request, base, reference)
    obj.Document.recompute([obj])
    return obj


def solve(request: FillAllRequest, base: App.DocumentObject, container):
    """The native FillAll of a request in a container's coordinates. Raises ValueError, FairingError or
    NativeModuleError."""
    if base is None:
        raise ValueError(NO_BASE)
    return request.solve(exchange.data_of(shape_in(container, base)))
