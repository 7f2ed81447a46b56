# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings objects back to life that were saved by a FreeCAD without Fairing: such a file keeps the shape and the
properties, but loses the proxies that compute and draw."""

from __future__ import annotations

import FreeCAD as App

from .. import migrate
from .blend_feature import BlendFeature
from .edit_feature import EditFeature
from .fill_all_feature import FillAllFeature
from .fill_feature import FillFeature
from .guide_objects import FeatureCurveFeature, NormalHandleFeature

FEATURES = {feature.TYPE: feature for feature in (FillFeature, FillAllFeature, BlendFeature, EditFeature,
                                                  NormalHandleFeature, FeatureCurveFeature)}


def dead_objects(document: App.Document) -> list[App.DocumentObject]:
    """Objects of Fairing's that have lost a proxy."""
    return [obj for obj in document.Objects if migrate.kind_of(obj) in FEATURES and _is_dead(obj)]


def reconnect(document: App.Document) -> list[App.DocumentObject]:
    """Gives them their proxies again and returns them; their shapes are computed at the next recompute."""
    objects = dead_objects(document)
    for obj in objects:
        feature = FEATURES[migrate.kind_of(obj)]
        proxy = feature.__new__(feature)
        obj.Proxy = proxy
        proxy.onDocumentRestored(obj)
        _reconnect_view(obj)
        obj.touch()
    return objects


def _is_dead(obj: App.DocumentObject) -> bool:
    return not _lives(obj.Proxy) or (App.GuiUp and not _lives(obj.ViewObject.Proxy))


def _lives(proxy) -> bool:
    return type(proxy).__module__.startswith("fairing.")


def _reconnect_view(obj: App.DocumentObject) -> None:
    if App.GuiUp and not _lives(obj.ViewObject.Proxy):
        from ..views.blend_view import BlendView
        from ..views.edit_view import EditView
        from ..views.fill_all_view import FillAllView
        from ..views.fill_view import FillView
        from ..views.guide_view import VIEWS

        view = {FillFeature.TYPE: FillView, FillAllFeature.TYPE: FillAllView, BlendFeature.TYPE: BlendView,
                EditFeature.TYPE: EditView, **VIEWS}[migrate.kind_of(obj)]
        view.attach_to(obj.ViewObject)


class ReconnectObserver:
    """Document observer: reconnects what a document that was just opened holds.

    Python observers are not told that a document has been restored, but its activation follows at once.
    """

    def slotActivateDocument(self, document: App.Document) -> None:
        if not getattr(document, "Restoring", False):
            report(document, reconnect(document))


def report(document: App.Document, objects) -> None:
    if objects:
        names = ", ".join(obj.Label for obj in objects)
        App.Console.PrintMessage(f"Fairing reconnected {names} in {document.Label}.\n")


_observer = ReconnectObserver()


def start() -> None:
    """Watches documents from now on, and looks through those that are open."""
    App.addDocumentObserver(_observer)
    for document in App.listDocuments().values():
        report(document, reconnect(document))
