# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of what guides a surface: handles, curves, and the parts of the reference."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore, QtGui

from .. import paths
from ..features.guides import FeatureCurve, Guide, NormalHandle
from ..translation import translate
from .row_list import show_rows

ICONS = {NormalHandle: "Fairing_NormalHandle.svg", FeatureCurve: "Fairing_FeatureCurve.svg"}
REFERENCE_ICON = "Fairing.svg"


class GuideList(QtCore.QObject):
    """Shows a session's guides. Emits selected(position) of a guide, -1 for none, and removed(is_reference) when the
    user has taken one away."""

    selected = QtCore.Signal(int)
    removed = QtCore.Signal(bool)

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session = ui, session
        ui.guideList.setIconSize(QtCore.QSize(16, 16))
        ui.guideList.itemSelectionChanged.connect(self._selected)
        ui.guideRemoveButton.clicked.connect(self._remove)

    @property
    def position(self) -> int:
        """Of the selected handle or curve, -1 for none."""
        row = self._row()
        return row if 0 <= row < len(self._session.guides) else -1

    def show(self, select: Optional[int] = None) -> None:
        """What guides now; one row may be selected, else the same one stays so."""
        rows, guides = self._ui.guideList, self._session.guides
        row = self._row() if select is None else select
        texts = [(ICONS[type(guide)], text_of(guide, at)) for at, guide in enumerate(guides)]
        texts += [(REFERENCE_ICON, _part_text(*part)) for part in self._parts()]
        rows.blockSignals(True)
        show_rows(rows, [(text, QtGui.QIcon(paths.icon(image))) for image, text in texts])
        rows.setCurrentRow(row if row < len(texts) else -1)
        rows.blockSignals(False)
        self._selected()

    def rename(self, position: int) -> None:
        """Writes one row anew."""
        self._ui.guideList.item(position).setText(text_of(self._session.guides[position], position))

    def select(self, position: int) -> None:
        self._ui.guideList.setCurrentRow(position)

    def _row(self) -> int:
        rows = self._ui.guideList
        return rows.currentRow() if rows.selectedIndexes() else -1

    def _selected(self) -> None:
        self._ui.guideRemoveButton.setEnabled(self._row() >= 0)
        self.selected.emit(self.position)

    def _parts(self) -> list[tuple[App.DocumentObject, str]]:
        """The reference, one row a face or object."""
        return [(obj, name) for obj, names in self._session.reference for name in (names or [""])]

    def _remove(self) -> None:
        row, guides = self._row(), list(self._session.guides)
        is_reference = row >= len(guides)
        if is_reference:
            parts = self._parts()
            del parts[row - len(guides)]
            self._session.set_reference([(obj, [name] if name else []) for obj, name in parts])
        else:
            del guides[row]
            self._session.set_guides(guides)
        self.show(max(0, row - 1))
        self.removed.emit(is_reference)


def text_of(guide: Guide, position: int) -> str:
    """A guide in few words, numbered as the native module's sentences number it."""
    if isinstance(guide, FeatureCurve):
        return translate("Fairing", "{0}  Along {1}").format(position + 1, _links_text(guide.curve))
    if guide.direction:
        return translate("Fairing", "{0}  Normal from {1}").format(position + 1, _links_text(guide.direction))
    length = sum(number * number for number in guide.normal) ** 0.5 or 1.0
    numbers = ", ".join(f"{number / length:.2f}" for number in guide.normal)
    return translate("Fairing", "{0}  Normal ({1})").format(position + 1, numbers)


def _links_text(given) -> str:
    return "; ".join(_part_text(obj, ", ".join(names)) for obj, names in given)


def _part_text(obj: App.DocumentObject, name: str) -> str:
    return f"{obj.Label}: {name}" if name else obj.Label
