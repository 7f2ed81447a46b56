# SPDX-License-Identifier: LGPL-2.1-or-later
"""What callers may give for links to other objects, and the shapes these links mean."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
import numpy as np
import Part

from .. import exchange, native
from .placement import placement_of, shape_in

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


def several(given) -> list[Link]:
    """A link an object out of a link, a list of links, or None."""
    return links_of([given] if _is_link(given) else given)


def reference_data(reference, container) -> Optional[bytes]:
    """The faces and meshes of a reference as the native module reads them, in a container's coordinates, or None. Raises
    ValueError where an object has neither, FairingError where a mesh has triangles that are flipped."""
    parts = [mesh_in(container, obj) if is_mesh(obj) else _faces(obj, names, container)
             for obj, names in several(reference)]
    if not parts:
        return None
    return exchange.data_of(parts[0] if len(parts) == 1 else Part.Compound(parts))


def is_mesh(obj: App.DocumentObject) -> bool:
    return obj.isDerivedFrom("Mesh::Feature")


def mesh_in(container, obj: App.DocumentObject) -> Part.Shape:
    """A mesh as a face that holds its triangles only, in a container's coordinates."""
    mesh = obj.Mesh.copy()
    mesh.Placement = placement_of(container).inverse().multiply(obj.getGlobalPlacement())
    points, triangles = mesh.Topology
    return exchange.part_shape(native.module().mesh_faces(np.array([tuple(point) for point in points], float),
                                                          np.array(triangles, int)))


def _faces(obj: App.DocumentObject, names, container) -> Part.Shape:
    shape = shape_in(container, obj, names)
    if not shape.Faces:
        raise ValueError(f"{obj.Label} has no face to guide by.")
    return shape


def _is_link(given) -> bool:
    if not isinstance(given, (tuple, list)):
        return given is not None
    names = given[1] if len(given) == 2 else None
    return isinstance(names, str) or (isinstance(names, (tuple, list)) and all(isinstance(name, str) for name in names))


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
