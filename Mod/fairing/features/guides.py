# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guides as plain data, as scripts give them and as the native module takes them: handles, which are normals at points,
and feature curves, which carry a normal along them."""

from __future__ import annotations

import dataclasses
import json
from typing import Any, Iterable, Mapping, Optional, Union

import FreeCAD as App
import Part

from .. import exchange, native, subelements
from ..choices import Triple, triple
from . import links
from .placement import container_of, placement_of, shape_in

WHAT_GUIDES = 'a guide needs "point" and "normal", or "curve"'
Links = tuple[tuple[App.DocumentObject, tuple[str, ...]], ...]


@dataclasses.dataclass(frozen=True)
class NormalHandle:
    """A normal near a point of the surface, in the coordinates of the surface's container."""

    point: Triple
    normal: Triple
    radius: float  # mm, over which it fades
    weight: float = 1.0
    direction: Links = ()  # a face, an edge or a datum that the normal is taken from
    name: str = ""  # of the document object, where there is one

    def native(self, container) -> dict:
        normal = normal_of(self.direction[0], self.point, container) if self.direction else self.normal
        return {"point": list(self.point), "normal": list(normal), "weight": self.weight, "radius": self.radius}


@dataclasses.dataclass(frozen=True)
class FeatureCurve:
    """Edges with a normal along them: that of faces beside them, or a fixed one turned square to the curve."""

    curve: Links
    radius: float  # mm, over which it fades
    weight: float = 1.0
    faces: Links = ()
    normal: Optional[Triple] = None
    name: str = ""

    def native(self, container) -> dict:
        points, normals = self.samples(container)
        return {"points": [list(map(float, point)) for point in points],
                "normals": [list(map(float, normal)) for normal in normals],
                "weight": self.weight, "radius": self.radius}

    def samples(self, container):
        """Points along the curve and the normals there, n x 3 each. Raises FairingError."""
        edges = _picked(self.curve, container, "Edges", "edge")
        if self.faces:
            faces = _picked(self.faces, container, "Faces", "face")
        else:
            faces = None if self.normal else faces_beside(self.curve, container)
        return native.module().guide_curve(exchange.data_of(edges), exchange.data_of(faces) if faces else None,
                                           self.normal)


Guide = Union[NormalHandle, FeatureCurve]


def guides_of(given: Iterable[Any]) -> tuple[Guide, ...]:
    """Guides out of dicts as scripts give them; guides stay what they are. Raises ValueError with one sentence."""
    return tuple(item if isinstance(item, (NormalHandle, FeatureCurve)) else _guide_of(item) for item in given or ())


def script_of(guide: Guide) -> dict:
    """The inverse: what differs from the defaults, links as pairs."""
    values = {field.name: getattr(guide, field.name) for field in dataclasses.fields(guide)
              if getattr(guide, field.name) != field.default}
    if "direction" in values:
        values["direction"] = values["direction"][0]
        del values["normal"]
    return values


def native_text(guides: Iterable[Guide], container) -> str:
    """What the native module takes for `guide`, as JSON, in a container's coordinates. Raises ValueError or
    FairingError with one sentence."""
    return merged_text([(isinstance(guide, FeatureCurve), guide.native(container)) for guide in guides])


def merged_text(natives: Iterable[tuple[bool, dict]]) -> str:
    """The same out of what native() made of each, and whether it is a curve."""
    natives = list(natives)
    handles = [made for is_curve, made in natives if not is_curve]
    curves = [made for is_curve, made in natives if is_curve]
    return json.dumps({"normals": handles, "curves": curves} if curves else handles)


def normal_of(link, point: Triple, container) -> Triple:
    """The direction that a face has at its point nearest to a point, an edge along it there, and a datum or any other
    object as a whole along its own z axis, in a container's coordinates. Raises ValueError."""
    obj, names = link
    if not names:
        between = placement_of(container).inverse().multiply(obj.getGlobalPlacement())
        return tuple(between.Rotation.multVec(App.Vector(0, 0, 1)))
    if not subelements.is_face(names[0]) and not subelements.is_edge(names[0]):
        raise ValueError(f"{obj.Label}: {names[0]} has no direction: choose a face, an edge or a datum.")
    part = _element(obj, names[0], shape_in(container, obj))
    near = part.distToShape(Part.Vertex(App.Vector(*point)))[1][0][0]
    if subelements.is_face(names[0]):
        return tuple(part.normalAt(*part.Surface.parameter(near)))
    return tuple(part.tangentAt(part.Curve.parameter(near)))


def moved(guide: Guide, guide_container, container) -> Guide:
    """A guide that lives in one container, in the coordinates of another."""
    between = placement_of(container).inverse().multiply(placement_of(guide_container))
    if between.isIdentity():
        return guide
    changes = {}
    if isinstance(guide, NormalHandle):
        changes["point"] = tuple(between.multVec(App.Vector(*guide.point)))
    if guide.normal is not None:
        changes["normal"] = tuple(between.Rotation.multVec(App.Vector(*guide.normal)))
    return dataclasses.replace(guide, **changes)


def _guide_of(given: Mapping[str, Any]) -> Guide:
    given = dict(given)
    kind = FeatureCurve if "curve" in given else NormalHandle
    unknown = set(given) - {field.name for field in dataclasses.fields(kind)}
    if unknown:
        raise ValueError(f"A guide has no {', '.join(sorted(map(repr, unknown)))}: {WHAT_GUIDES}.")
    if "radius" not in given:
        raise ValueError('A guide needs its "radius", the length in mm over which it fades.')
    for name in ("curve", "faces", "direction"):
        if name in given:
            given[name] = frozen_links(given[name])
    if given.get("normal") is not None:
        given["normal"] = triple(given["normal"])
    if kind is NormalHandle:
        if "point" not in given or not ("normal" in given or given.get("direction")):
            raise ValueError(f"This guides nothing: {WHAT_GUIDES}.")
        given["point"] = triple(given["point"])
        given.setdefault("normal", (0.0, 0.0, 1.0))  # replaced by the direction's
    return kind(**given)


def frozen_links(given) -> Links:
    """Links that can be compared and kept."""
    return tuple((obj, tuple(names)) for obj, names in links.several(given))


def faces_beside(curve: Links, container) -> Optional[Part.Shape]:
    """The faces that have edges of a curve, None where none has."""
    faces = []
    for obj, names in curve:
        shape = shape_in(container, obj)
        edges = [_element(obj, name, shape) for name in names] if names else shape.Edges
        faces += [face for face in shape.Faces if any(edge.isSame(own) for edge in edges for own in face.Edges)]
    return Part.Compound(faces) if faces else None


def middle_of(curve: Links, container) -> Triple:
    """The middle of a curve's first edge."""
    edge = _picked(curve, container, "Edges", "edge").Edges[0]
    return tuple(edge.valueAt(0.5 * sum(edge.ParameterRange)))


def _picked(picked: Links, container, kind: str, word: str) -> Part.Shape:
    """The elements that links name, or all of a kind of objects as a whole, in one compound."""
    parts = []
    for obj, names in picked:
        shape = shape_in(container, obj)
        found = [_element(obj, name, shape) for name in names] if names else getattr(shape, kind)
        if not found:
            raise ValueError(f"{obj.Label} has no {word}.")
        parts += found
    return Part.Compound(parts)


def _element(obj: App.DocumentObject, name: str, shape: Part.Shape) -> Part.Shape:
    kind = "Faces" if subelements.is_face(name) else "Edges"
    parts, number = getattr(shape, kind), int(name[4:])
    if not 1 <= number <= len(parts):
        raise ValueError(f"There is no {name}: {obj.Label} has {len(parts)} {kind.lower()}.")
    return parts[number - 1]
