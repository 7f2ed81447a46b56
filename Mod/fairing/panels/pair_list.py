# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of vertices of both sides of a blend that belong together."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore

from .. import selection, subelements
from ..features.joined_shapes import Place
from ..translation import translate
from .row_list import show_rows, without_chosen


class PairList(QtCore.QObject):
    """Shows a BlendSession's pairs and writes the user's into it. Emits changed()."""

    changed = QtCore.Signal()

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session = ui, session
        self._first: Optional[tuple[int, Place]] = None  # side and vertex picked while its partner is still to come
        ui.pairButton.toggled.connect(self._start)
        ui.pairRemoveButton.clicked.connect(self._remove)
        self._start()

    @property
    def is_picking(self) -> bool:
        return self._ui.pairButton.isChecked()

    def picked(self, obj: App.DocumentObject, name: str) -> None:
        """A vertex of either side; the second one makes a pair."""
        side = self._session.side_of_vertex(obj, name) if subelements.is_vertex(name) else None
        if side is None or (self._first and self._first[0] == side):
            selection.tell(translate("Fairing", "Pick a vertex where edges of the other side meet.") if self._first
                           else translate("Fairing", "Pick a vertex where edges of a side of the blend meet."))
            return
        vertex = side, (obj, subelements.vertex_number(name))
        if self._first is None:
            self._first = vertex
            self._prompt()
            return
        pair = tuple(place for _, place in sorted((self._first, vertex), key=lambda item: item[0]))
        self._ui.pairButton.setChecked(False)
        if pair not in self._session.pairs:
            self._session.pairs += (pair,)
            self.changed.emit()

    def show(self) -> None:
        ui, pairs = self._ui, self._session.pairs
        show_rows(ui.pairList, [(" \u2013 ".join(f"{obj.Label}.Vertex{number}" for obj, number in pair), None)
                                for pair in pairs])
        ui.pairRemoveButton.setEnabled(bool(pairs))

    def _remove(self) -> None:
        """The chosen ones, or all where none is chosen."""
        self._session.pairs = tuple(without_chosen(self._ui.pairList, self._session.pairs))
        self.changed.emit()

    def _start(self, *_) -> None:
        self._first = None
        self._prompt()

    def _prompt(self) -> None:
        self._ui.pairButton.setText(
            translate("Fairing", "Pair two vertices") if not self.is_picking
            else translate("Fairing", "Pick the vertex it belongs to") if self._first
            else translate("Fairing", "Pick a vertex of a side"))
