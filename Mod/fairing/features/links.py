# SPDX-License-Identifier: LGPL-2.1-or-later
"""What callers may give for links to other objects, and the shapes these links mean."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
import Part

from .. import exchange
from .placement import shape_in

Link = tuple[App.DocumentObject, list[str]]


def link_of(given) -> Optional[Link]:
    """(object, [names]) out of an object, (object, name), (object, [names]) or None."""
    if not given:
        return None
    obj, names = given if isinstance(given, (tuple, list)) else (given, ())
    names = [names] if isinstance(names, str) else names
    return obj, [name for name in names if name]


def links_of(given) -> list[Link]:
    """A link an object out of a list of what link_of() takes."""
    merged: dict[str, Link] = {}
    for obj, names in (link_of(item) for item in given or ()):
        known = merged.setdefault(f"{obj.Document.Name}.{obj.Name}", (obj, []))[1]
        known += [name for name in names if name not in known]
    return list(merged.values())


def reference_data(reference, container) -> Optional[bytes]:
    """The faces of a reference as the native module reads them, in a container's coordinates, or None."""
    link = link_of(reference)
    return exchange.data_of(shape_in(container, *link)) if link else None


def through_data(given, container) -> tuple[bytes, ...]:
    """What a surface is to pass through, part by part, in a container's coordinates. Without names, the whole object:
    its edges, or its vertices where it has no edge."""
    parts = []
    for obj, names in links_of(given):
        shape = shape_in(container, obj)
        parts += [shape.getElement(name) for name in names] if names else [_wire_frame(obj, shape)]
    return tuple(exchange.data_of(part) for part in parts)


def _wire_frame(obj: App.DocumentObject, shape: Part.Shape) -> Part.Shape:
    if not shape.Edges and not shape.Vertexes:
        raise ValueError(f"{obj.Label} has neither edges nor points to pass through")
    return Part.Compound(shape.Edges or shape.Vertexes)
