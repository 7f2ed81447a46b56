# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected, and what may be selected."""

from __future__ import annotations

import dataclasses
import enum
from typing import Callable, Optional

import FreeCAD as App
import FreeCADGui as Gui

from . import subelements
from .translation import translate


@dataclasses.dataclass(frozen=True)
class Picks:
    """Edges of one object, or one of its faces."""

    base: App.DocumentObject
    names: tuple[str, ...]


def can_start(understood: Callable[[], object]) -> bool:
    """Whether a command that opens a panel may start: with a selection it understands, or none while there is something
    to pick."""
    if not App.ActiveDocument or Gui.Control.activeDialog():
        return False
    return bool(understood()) if Gui.Selection.hasSelection() else has_shapes(App.ActiveDocument)


def current_picks() -> Optional[Picks]:
    """The picks a fill can start from, or None where the selection makes no sense for it."""
    selected = Gui.Selection.getSelectionEx()
    if len(selected) != 1 or not has_shape(selected[0].Object):
        return None
    names = tuple(subelements.local_name(name) for name in selected[0].SubElementNames)
    all_edges = names and all(map(subelements.is_edge, names))
    one_face = len(names) == 1 and subelements.is_face(names[0])
    return Picks(selected[0].Object, names) if all_edges or one_face else None


def current_face() -> Optional[Picks]:
    """The one face that is selected, or None."""
    picks = current_picks()
    return picks if picks and subelements.is_face(picks.names[0]) else None


def current_shapes() -> list[tuple[App.DocumentObject, list[str]]]:
    """What may be looked at: selected faces, object by object, and objects as a whole (no names); with nothing selected
    all that is visible and has a shape. Empty where something else is selected."""
    selected = Gui.Selection.getSelectionEx()
    if not selected:
        return [(obj, []) for obj in shown_shapes()]
    picks = [(item.Object, [subelements.local_name(name) for name in item.SubElementNames]) for item in selected]
    understood = all(has_shape(obj) and all(map(subelements.is_face, names)) for obj, names in picks)
    return picks if understood else []


def current_edges() -> list[tuple[App.DocumentObject, list[str]]]:
    """The edges a blend can start from, object by object in the order of selection; empty where something else, or
    fewer than two, are selected."""
    picks = [(item.Object, [subelements.local_name(name) for name in item.SubElementNames])
             for item in Gui.Selection.getSelectionEx()]
    if not all(names and has_shape(obj) and all(map(subelements.is_edge, names)) for obj, names in picks):
        return []
    return picks if sum(len(names) for _, names in picks) >= 2 else []


def current_base() -> Optional[App.DocumentObject]:
    """The one object that is selected, as a whole or in part; with nothing selected, the only visible one with a
    shape. None otherwise."""
    selected = Gui.Selection.getSelectionEx()
    if selected:
        return selected[0].Object if len(selected) == 1 and has_shape(selected[0].Object) else None
    shown = shown_shapes()
    return shown[0] if len(shown) == 1 else None


def shown_shapes() -> list[App.DocumentObject]:
    """Objects that are visible and have a shape. What is in a PartDesign body is seen as that body."""
    return [obj for obj in App.ActiveDocument.Objects
            if has_shape(obj) and obj.ViewObject.Visibility and not _is_in_body(obj)]


def has_shape(obj: App.DocumentObject) -> bool:
    return obj.isDerivedFrom("Part::Feature") or obj.isDerivedFrom("App::Link")


def has_shapes(document: App.Document) -> bool:
    return any(has_shape(obj) for obj in document.Objects)


def _is_in_body(obj: App.DocumentObject) -> bool:
    group = obj.getParentGeoFeatureGroup()
    return group is not None and group.isDerivedFrom("PartDesign::Body")


class Wanted(enum.Enum):
    """What a panel takes."""

    EDGES = enum.auto()  # and faces
    POINTS = enum.auto()  # vertices, edges and whole objects
    GUIDES = enum.auto()  # edges, faces, meshes and whole objects


class PanelGate:
    """Selection gate: what wanted() says; the status bar tells what is missing otherwise."""

    def __init__(self, excluded: Optional[App.DocumentObject] = None, wanted=lambda: Wanted.EDGES):
        self._excluded, self._wanted = excluded, wanted

    def allow(self, document: App.Document, obj: App.DocumentObject, sub: str) -> bool:
        reason = self._reason(obj, subelements.local_name(sub or ""))
        if reason:
            tell(reason)
        return not reason

    def _reason(self, obj: App.DocumentObject, name: str) -> str:
        if self._excluded is not None and obj is self._excluded:
            return translate("Fairing", "This is the surface being made: pick an edge of the hole beside it.")
        wanted = self._wanted()
        if wanted is Wanted.GUIDES:
            if subelements.is_vertex(name):
                return translate("Fairing", "Pick an edge, a face, a mesh or a datum.")
        elif wanted is Wanted.POINTS:
            if name and not subelements.is_edge(name) and not subelements.is_vertex(name):
                return translate("Fairing", "Pick a point, an edge, a sketch or a datum point.")
        elif not subelements.is_edge(name) and not subelements.is_face(name):
            return translate("Fairing", "Pick an edge of the hole, or the face to be replaced.")
        return ""


def tell(text: str) -> None:
    """Shows a hint in the status bar, after FreeCAD has written its own general message there."""
    from PySide import QtCore

    QtCore.QTimer.singleShot(0, lambda: Gui.getMainWindow().statusBar().showMessage(text, 5000))
