# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where objects live, and what the shape of one looks like from where another one lives.

A container here is the Part or Body an object belongs to, None for the document itself: its placement moves all that
it holds.
"""

from __future__ import annotations

import FreeCAD as App
import Part

from .. import subelements


def container_of(obj: App.DocumentObject):
    return obj.getParentGeoFeatureGroup()


def container_for_results(base: App.DocumentObject):
    """The container that something made from the base belongs to: the base's own one, but a Body takes no strangers."""
    container = container_of(base)
    while container and not container.isDerivedFrom("App::Part"):
        container = container_of(container)
    return container


def placement_of(container) -> App.Placement:
    """From a container's coordinates to the document's."""
    return container.getGlobalPlacement() if container else App.Placement()


def shape_in(container, obj: App.DocumentObject, faces=()) -> Part.Shape:
    """An object's shape, its placement included, in the coordinates of a container; links are followed.

    With names among `faces`, only these faces of it.
    """
    shape = Part.getShape(obj)
    between = placement_of(container).inverse().multiply(placement_of(container_of(obj)))
    if not between.isIdentity():
        shape.Placement = between.multiply(shape.Placement)
    names = [name for name in faces if subelements.is_face(name)]
    return Part.Compound([shape.getElement(name) for name in names]) if names else shape
