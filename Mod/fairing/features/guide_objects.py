# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normal handles and feature curves as document objects below the surface they guide."""

from __future__ import annotations

from typing import Iterable, Optional

import FreeCAD as App

from .. import migrate
from .guides import FeatureCurve, Guide, NormalHandle, frozen_links, moved, normal_of
from .placement import container_of
from .property_modes import HIDDEN, READ_ONLY


class GuideFeature:
    """Proxy of a guide. A kind of guide names its type, its properties, and the plain data it stands for."""

    TYPE = ""  # stored with the object, see migrate.py
    ASKED = MEASURED = ()  # name, type, group, tooltip

    def __init__(self, obj: App.DocumentObject):
        migrate.mark(obj, self.TYPE)
        self._add_properties(obj)
        obj.Proxy = self

    @staticmethod
    def write(obj: App.DocumentObject, guide: Guide) -> None:
        raise NotImplementedError

    @staticmethod
    def read(obj: App.DocumentObject) -> Guide:
        raise NotImplementedError

    def onDocumentRestored(self, obj: App.DocumentObject) -> None:
        migrate.update(obj)
        self._add_properties(obj)

    def _add_properties(self, obj: App.DocumentObject) -> None:
        for items, attributes in ((self.ASKED, 0), (self.MEASURED, READ_ONLY | HIDDEN)):
            for name, kind, group, tip in items:
                if name not in obj.PropertiesList:
                    obj.addProperty(kind, name, group, tip, attributes)

    # Nothing of the proxy itself is saved. FreeCAD 0.20 calls the second pair of names, later versions the first.
    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads


class NormalHandleFeature(GuideFeature):
    """A normal near a point of the surface."""

    TYPE = "NormalHandle"
    ASKED = (
        ("Position", "App::PropertyVectorDistance", "Guide", "Where the surface is to have the normal: near this point"),
        ("Normal", "App::PropertyVector", "Guide", "Direction of the normal; its length does not matter"),
        ("Direction", "App::PropertyLinkSubGlobal", "Guide",
         "A face, an edge or a datum that the normal is taken from; empty: Normal stands as it is"),
        ("Weight", "App::PropertyFloat", "Guide", "How much it counts among the other guides"),
        ("Radius", "App::PropertyLength", "Guide", "Distance over which it fades to nothing"),
    )

    def execute(self, obj: App.DocumentObject) -> None:
        """Looks its normal up."""
        if obj.Direction:
            normal = normal_of(frozen_links(obj.Direction)[0], tuple(obj.Position), container_of(obj))
            if tuple(obj.Normal) != normal:
                obj.Normal = App.Vector(*normal)

    @staticmethod
    def write(obj: App.DocumentObject, guide: NormalHandle) -> None:
        obj.Position, obj.Normal = App.Vector(*guide.point), App.Vector(*guide.normal)
        obj.Direction = _pair(guide.direction[0]) if guide.direction else None
        obj.Weight, obj.Radius = guide.weight, guide.radius

    @staticmethod
    def read(obj: App.DocumentObject) -> NormalHandle:
        return NormalHandle(tuple(obj.Position), tuple(obj.Normal), obj.Radius.Value, obj.Weight,
                            frozen_links(obj.Direction), obj.Name)


class FeatureCurveFeature(GuideFeature):
    """A curve with a normal along it."""

    TYPE = "FeatureCurve"
    ASKED = (
        ("Edges", "App::PropertyLinkSubListGlobal", "Guide", "Edges, or sketches, that make the curve"),
        ("Faces", "App::PropertyLinkSubListGlobal", "Guide",
         "Faces whose normals the surface takes along the curve; empty: those beside its edges"),
        ("Normal", "App::PropertyVector", "Guide",
         "Direction of the normals along the curve, turned square to it; zero: that of the faces"),
        ("Weight", "App::PropertyFloat", "Guide", "How much it counts among the other guides"),
        ("Radius", "App::PropertyLength", "Guide", "Distance from the curve over which it fades to nothing"),
    )
    MEASURED = (
        ("Points", "App::PropertyVectorList", "Guide", "Points along the curve"),
        ("Normals", "App::PropertyVectorList", "Guide", "The normals there"),
    )

    def execute(self, obj: App.DocumentObject) -> None:
        """Looks its normals up, to be drawn."""
        points, normals = self.read(obj).samples(container_of(obj))
        obj.Points = [App.Vector(*point) for point in points]
        obj.Normals = [App.Vector(*normal) for normal in normals]

    @staticmethod
    def write(obj: App.DocumentObject, guide: FeatureCurve) -> None:
        obj.Edges, obj.Faces = [_pair(link) for link in guide.curve], [_pair(link) for link in guide.faces]
        obj.Normal = App.Vector(*(guide.normal or ()))
        obj.Weight, obj.Radius = guide.weight, guide.radius

    @staticmethod
    def read(obj: App.DocumentObject) -> FeatureCurve:
        return FeatureCurve(frozen_links(obj.Edges), obj.Radius.Value, obj.Weight, frozen_links(obj.Faces),
                            tuple(obj.Normal) if obj.Normal.Length > 0.0 else None, obj.Name)


KINDS = {NormalHandle: NormalHandleFeature, FeatureCurve: FeatureCurveFeature}
_BY_TYPE = {feature.TYPE: feature for feature in KINDS.values()}


def read(obj: App.DocumentObject) -> tuple[Guide, ...]:
    """The guides of a surface, in its coordinates."""
    linked = obj.Guides if "Guides" in obj.PropertiesList else ()
    return tuple(moved(_BY_TYPE[migrate.kind_of(item)].read(item), container_of(item), container_of(obj))
                 for item in linked if migrate.kind_of(item) in _BY_TYPE)


def write(obj: App.DocumentObject, guides: Iterable[Guide]) -> None:
    """Makes, changes and takes away document objects until they are the guides of a surface: one that has the name of
    a guide is changed."""
    known = {item.Name: item for item in obj.Guides}
    if tuple(guides) == read(obj):
        return
    items = [_written(obj, guide, known.get(guide.name)) for guide in guides]
    obj.Guides = items
    remove((item for item in known.values() if item not in items), obj)


def remove(items: Iterable[App.DocumentObject], surface: App.DocumentObject) -> None:
    """Takes away the guides that nothing but a surface makes use of."""
    for item in items:
        if all(user in (surface, container_of(item)) for user in item.InList):
            item.Document.removeObject(item.Name)


def _written(surface: App.DocumentObject, guide: Guide, item: Optional[App.DocumentObject]) -> App.DocumentObject:
    feature = KINDS[type(guide)]
    if item is None or migrate.kind_of(item) != feature.TYPE:
        item = surface.Document.addObject("App::FeaturePython", guide.name or feature.TYPE)
        if container_of(surface):
            container_of(surface).addObject(item)
        feature(item)
        if App.GuiUp:
            from ..views.guide_view import VIEWS

            VIEWS[feature.TYPE].attach_to(item.ViewObject)
    feature.write(item, moved(guide, container_of(surface), container_of(item)))
    return item


def _pair(link):
    obj, names = link
    return obj, list(names) or [""]  # "": the whole object
