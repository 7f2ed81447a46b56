# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric blend: a Part::FeaturePython that joins edges of one object or several and keeps the numbers."""

from __future__ import annotations

from typing import Any, Mapping, Optional

import FreeCAD as App

from .. import exchange
from ..blend_request import BlendRequest
from . import blend_properties as properties, guide_objects
from .blend_sides import BlendSides, Side, pairs_of
from .guides import guides_of, native_text
from .links import reference_data, several
from .placement import container_for_results, container_of
from .solved_feature import SolvedFeature


class BlendFeature(SolvedFeature):
    """Proxy of a blend."""

    TYPE = "Blend"
    properties = properties

    def solve(self, obj: App.DocumentObject):
        sides = properties.read_sides(obj)
        return solve(properties.read_request(obj, sides), sides)


def make_blend(from_edges, to_edges, *, name: str = "Blend", from_continuity: Optional[Mapping[Any, str]] = None,
               to_continuity: Optional[Mapping[Any, str]] = None, pairs=(), from_curve=None, to_curve=None, ends=(),
               cuts=(), reference=None, guides=(), **options) -> App.DocumentObject:
    """Makes a surface that joins chains of free edges, beside the first one's object in the document, computed.

    from_edges       (object, ["Edge3"]): one edge of a smooth chain is enough
    to_edges         the same for the other side, of the same object or of another one; or a list of them: with
                     several closed chains the blend is a junction
    from_continuity  edges of the first side that differ from `continuity`, {"Edge3": "G0"}
    to_continuity    edges of the other side that differ, {"Pipe.Edge3": "G0"} where it has several objects
    pairs            vertices of both sides that belong together, [("Vertex3", "Vertex7")]
    from_curve       (sketch, ["Edge1"]), a list of such links, or an object for all its edges: a curve on the faces of
                     the first side, or a little off them, that it is set back to
    to_curve         the same for the other side
    ends             what the ends of a blend between open sides follow, a list of (object, ["Edge3", "Face2"])
    cuts             edges from rim to rim that show where a junction is cut, a list of (object, ["Edge1"])
    reference        faces and meshes that guide by the weights lambda_ and gamma, see make_fill()
    guides           handles and feature curves, see make_fill()
    options          those of fairing.blend()
    Raises FairingError (or NativeModuleError) with one sentence, and then the document is as it was.
    """
    first, second = Side.of(from_edges, from_continuity), Side.of(to_edges, to_continuity)
    beside = first.objects[0]
    container = container_for_results(beside)
    sides = BlendSides(first, second, container, pairs_of(pairs, first, second),
                       (several(from_curve), several(to_curve)), several(ends), several(cuts))
    guides = guides_of(guides)
    request = sides.request(reference=reference_data(reference, container), guide=native_text(guides, container),
                            **options)
    solve(request, sides)
    obj = beside.Document.addObject("Part::FeaturePython", name)
    if container:
        container.addObject(obj)
    BlendFeature(obj)
    properties.write_request(obj, request, sides, several(reference))
    guide_objects.write(obj, guides)
    if App.GuiUp:
        from ..views.blend_view import BlendView

        BlendView(obj.ViewObject)
    obj.Document.recompute([obj])
    return obj


def change_blend(obj: App.DocumentObject, *, from_edges=None, to_edges=None,
                 from_continuity: Optional[Mapping[Any, str]] = None,
                 to_continuity: Optional[Mapping[Any, str]] = None, pairs=None, from_curve=None, to_curve=None,
                 ends=None, cuts=None, **changes) -> App.DocumentObject:
    """Changes some choices of a blend (those of make_blend) and computes it again; the others stay as they are. With []
    a side has no curve any more.

    A side that moves to other edges forgets which of its edges differed in continuity, and the pairs. Raises FairingError with one
    sentence, and then the object is as it was.
    """
    first = _changed(lambda: properties.from_side(obj), from_edges, from_continuity)
    second = _changed(lambda: properties.to_side(obj), to_edges, to_continuity)
    if pairs is not None:
        pairs = pairs_of(pairs, first, second)
    elif from_edges is None and to_edges is None:
        pairs = properties.read_pairs(obj)
    curves = tuple(was if given is None else several(given)
                   for was, given in zip(properties.read_curves(obj), (from_curve, to_curve)))
    sides = BlendSides(first, second, container_of(obj), pairs or (), curves,
                       obj.Ends if ends is None else several(ends), obj.Cuts if cuts is None else several(cuts))
    reference = several(changes.pop("reference", obj.Reference))
    guides = guides_of(changes.pop("guides", guide_objects.read(obj)))
    guidance = {"reference": reference_data(reference, container_of(obj)),
                "guide": native_text(guides, container_of(obj))}
    request = sides.request(**{**properties.read_choices(obj), **changes, **guidance})
    solve(request, sides)
    properties.write_request(obj, request, sides, reference)
    guide_objects.write(obj, guides)
    obj.Document.recompute([obj])
    return obj


def solve(request: BlendRequest, sides: BlendSides):
    """The native Fill of a request on its sides. Raises ValueError, FairingError or NativeModuleError."""
    return request.solve(exchange.data_of(sides.joined.shape))


def _changed(read, edges, wishes) -> Side:
    """A side with other edges, or with other wishes for those it has."""
    if edges is not None:
        return Side.of(edges, wishes)
    side = read()
    return side if wishes is None else Side.of(side.links(), wishes)
