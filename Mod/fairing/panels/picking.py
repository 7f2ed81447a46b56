# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picking in the 3D view while a panel is open, and closing the panel when its document goes or Esc is pressed."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
from pivy import coin
from PySide import QtCore

from .. import selection, subelements


class Picking:
    """Calls on_pick(object, name) for everything wanted that is picked in a document, and keeps the selection itself empty."""

    def __init__(self, document: App.Document, on_pick, excluded=None, wanted=lambda: selection.Wanted.EDGES):
        self._document, self._on_pick = document, on_pick
        Gui.Selection.clearSelection()
        Gui.Selection.addSelectionGate(selection.PanelGate(excluded, wanted))
        Gui.Selection.addObserver(self)

    def addSelection(self, document: str, obj: str, sub: str, point) -> None:  # called by FreeCAD
        if document != self._document.Name:
            return
        picked = self._document.getObject(obj)
        resolved = picked.getSubObject(sub, retType=1) if picked and sub else picked
        name = subelements.local_name(sub)
        # FreeCAD is still busy with its own selection here
        QtCore.QTimer.singleShot(0, lambda: self._picked(resolved or picked, name))

    def stop(self) -> None:
        Gui.Selection.removeObserver(self)
        Gui.Selection.removeSelectionGate()
        self._on_pick = None

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if self._on_pick is None:
            return
        Gui.Selection.clearSelection()
        self._on_pick(obj, name)


class EscapeKey:
    """Calls on_escape when Esc is pressed in the 3D view, which FreeCAD hands to panels in edit mode only."""

    def __init__(self, view, on_escape):
        self._view, self._on_escape = view, on_escape
        self._callback = self._pressed  # removal goes by identity
        view.addEventCallbackPivy(coin.SoKeyboardEvent.getClassTypeId(), self._callback)

    def stop(self) -> None:
        try:
            self._view.removeEventCallbackPivy(coin.SoKeyboardEvent.getClassTypeId(), self._callback)
        except RuntimeError:  # the view has been closed
            pass

    def _pressed(self, node) -> None:
        event = node.getEvent()
        if event.getKey() == coin.SoKeyboardEvent.ESCAPE and event.getState() == coin.SoButtonEvent.DOWN:
            node.setHandled()
            QtCore.QTimer.singleShot(0, self._on_escape)


class ClosingDocument:
    """Calls on_close when a document is about to go. The view must not be touched any more by then."""

    def __init__(self, document: App.Document, on_close):
        self._name, self._on_close = document.Name, on_close
        App.addDocumentObserver(self)

    def slotDeletedDocument(self, document: App.Document) -> None:  # called by FreeCAD
        if document.Name == self._name:
            self._on_close()

    def stop(self) -> None:
        App.removeDocumentObserver(self)
