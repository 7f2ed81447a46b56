# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is asked where a blend has three sides or more: whether open ones come to a vertex, where closed ones are cut."""

from __future__ import annotations

import FreeCAD as App
from PySide import QtCore

from .. import selection, subelements
from ..features.links import links_of
from ..translation import translate


class RingRow(QtCore.QObject):
    """Shows these choices of a BlendSession and writes the user's into it. Emits changed()."""

    changed = QtCore.Signal()

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session = ui, session
        ui.ringCheck.setChecked(session.request.ring)
        ui.ringCheck.toggled.connect(self._read)
        ui.cutsButton.toggled.connect(self.show)
        ui.cutsRemoveButton.clicked.connect(lambda *_: self._set([]))
        self.show()

    @property
    def is_picking(self) -> bool:
        return self._ui.cutsButton.isVisible() and self._ui.cutsButton.isChecked()

    def picked(self, obj: App.DocumentObject, name: str) -> None:
        """An edge joins the cuts; picking goes on, since there may be several."""
        if not subelements.is_edge(name):
            selection.tell(translate("Fairing", "Pick an edge that leads from rim to rim."))
            return
        self._set(self._session.cuts + [(obj, [name])])

    def show(self, *_) -> None:
        ui, session = self._ui, self._session
        ui.ringCheck.setVisible(session.is_ring)
        ui.cutsButton.setVisible(session.is_junction)
        ui.cutsRemoveButton.setVisible(session.is_junction)
        ui.ringRow.setVisible(session.is_ring or session.is_junction)
        ui.cutsRemoveButton.setEnabled(bool(session.cuts))
        ui.cutsButton.setText(self._text())

    def _text(self) -> str:
        if self._ui.cutsButton.isChecked():
            return translate("Fairing", "Pick edges, then click here")
        count = sum(len(names) for _, names in self._session.cuts)
        return translate("Fairing", "Cuts shown: {}").format(count) if count else translate("Fairing", "Cuts: automatic")

    def _set(self, cuts) -> None:
        self._session.cuts = links_of(cuts)
        self.changed.emit()

    def _read(self, on: bool) -> None:
        self._session.change(ring=on)
        self.changed.emit()
