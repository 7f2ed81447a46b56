# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of edges and faces that the ends of a blend follow."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore, QtGui

from ..features.links import links_of
from ..translation import translate
from . import status
from .quantities import length_text
from .row_list import show_rows, without_chosen


class EndsList(QtCore.QObject):
    """Shows what a BlendSession's ends follow and writes the user's picks into it. Emits changed()."""

    changed = QtCore.Signal()

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session = ui, session
        ui.endsList.setIconSize(QtCore.QSize(14, 14))
        ui.endsButton.toggled.connect(self._prompt)
        ui.endsRemoveButton.clicked.connect(self._remove)
        self._prompt()

    @property
    def is_picking(self) -> bool:
        return self._ui.endsButton.isChecked()

    def picked(self, obj: App.DocumentObject, name: str) -> None:
        """An edge or a face joins the list; picking goes on, since an end may have several edges."""
        self._change(self._session.ends + [(obj, [name])])

    def show(self, report: Optional[dict] = None) -> None:
        """The list, with what was measured where a report is given."""
        ui, rows = self._ui, self._rows()
        shown = []
        for obj, name in rows:
            side = self._session.measured_end(obj, name, report) if report else None
            text = f"{obj.Label}: {name}"
            shown.append((f"{text}   {length_text(side['gap']['max'])}" if side else text,
                          QtGui.QIcon(status.of_side(side, report).pixmap(14))))
        show_rows(ui.endsList, shown)
        ui.endsRemoveButton.setEnabled(bool(rows))

    def _rows(self) -> list[tuple[App.DocumentObject, str]]:
        return [(obj, name) for obj, names in self._session.ends for name in names]

    def _remove(self) -> None:
        """The chosen ones, or all where none is chosen."""
        self._change([(obj, [name]) for obj, name in without_chosen(self._ui.endsList, self._rows())])

    def _change(self, ends) -> None:
        self._session.ends = links_of(ends)
        self.changed.emit()

    def _prompt(self, *_) -> None:
        self._ui.endsButton.setText(
            translate("Fairing", "Pick edges or faces, then click here") if self.is_picking
            else translate("Fairing", "Let the ends follow edges or faces"))
