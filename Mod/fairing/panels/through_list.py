# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of what the surface is to pass through: vertices, edges, sketches, datum points."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore, QtGui

from .. import subelements
from ..translation import translate
from . import status
from .fill_session import FillSession
from .quantities import length_text
from .row_list import show_rows, without_chosen

LARGEST_HEIGHT = 3  # rows shown without scrolling


class ThroughList(QtCore.QObject):
    """Shows the session's inner constraints and writes the user's into it. Emits changed()."""

    changed = QtCore.Signal()

    def __init__(self, ui, session: FillSession):
        super().__init__(ui)
        self._ui, self._session = ui, session
        ui.throughList.setIconSize(QtCore.QSize(14, 14))
        ui.throughButton.toggled.connect(self._prompt)
        ui.throughRemoveButton.clicked.connect(self._remove)
        self._prompt()

    @property
    def is_picking(self) -> bool:
        return self._ui.throughButton.isChecked()

    def picked(self, obj: App.DocumentObject, name: str) -> None:
        """A vertex or an edge, or a whole object such as a sketch, joins the list."""
        if name and not subelements.is_edge(name) and not subelements.is_vertex(name):
            return
        if self._change(self._session.through + [(obj, [name] if name else [])]):
            self._ui.throughButton.setChecked(False)

    def show(self, report: Optional[dict], enabled: bool) -> None:
        """The list, with what was measured where a report is given."""
        ui = self._ui
        ui.throughButton.setEnabled(enabled)
        shown = self._rows()
        inner = report["inner"] if report and len(report["inner"]) == len(shown) else None
        rows = []
        for position, (obj, name) in enumerate(shown):
            text, sign = f"{obj.Label}: {name}" if name else obj.Label, status.Status.UNKNOWN
            if inner:
                gap = inner[position]["gap"]["max"]
                text += f"   {length_text(gap)}"
                sign = status.Status.GOOD if gap <= report["limits"]["gap"] else status.Status.BAD
            rows.append((text, QtGui.QIcon(sign.pixmap(14))))
        show_rows(ui.throughList, rows, LARGEST_HEIGHT)
        ui.throughRemoveButton.setEnabled(bool(shown))

    def _rows(self) -> list[tuple[App.DocumentObject, str]]:
        """One row a part, in the order of the native constraints."""
        return [(obj, name) for obj, names in self._session.through for name in (names or [""])]

    def _remove(self) -> None:
        kept = without_chosen(self._ui.throughList, self._rows())
        self._change([(obj, [name] if name else []) for obj, name in kept])

    def _change(self, through) -> bool:
        try:
            self._session.set_through(through)
        except ValueError as error:
            self._ui.throughButton.setToolTip(str(error))
            return False
        self.changed.emit()
        return True

    def _prompt(self, *_) -> None:
        self._ui.throughButton.setText(
            translate("Fairing", "Pick a point, an edge or a sketch") if self.is_picking
            else translate("Fairing", "Pass through points or edges"))
