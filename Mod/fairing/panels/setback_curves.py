# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drawn curves that the sides of a blend are set back to: edges, or sketches as a whole."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore

from .. import selection, subelements
from ..translation import translate

SIDES = ("from", "to")


class SetbackCurves(QtCore.QObject):
    """Shows the curves of a BlendSession and writes the user's into it. Emits changed()."""

    changed = QtCore.Signal()

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session = ui, session
        for position, side in enumerate(SIDES):
            self._button(position).toggled.connect(lambda on, position=position: self._toggled(position, on))
            getattr(ui, f"{side}CurveRemoveButton").clicked.connect(
                lambda *_, position=position: self._set(position, []))
        self.show()

    @property
    def is_picking(self) -> bool:
        return self._picked_side is not None

    def picked(self, obj: App.DocumentObject, name: str) -> None:
        """An edge, or a whole object such as a sketch, joins the curve."""
        position = self._picked_side
        if not (subelements.is_edge(name) if name else selection.has_shape(obj)):
            selection.tell(translate("Fairing", "Pick an edge of the curve, or a sketch."))
            return
        self._button(position).setChecked(False)
        self._set(position, self._session.curves[position] + [(obj, [name] if name else [])])

    def show(self) -> None:
        for position, side in enumerate(SIDES):
            button, links = self._button(position), self._session.curves[position]
            button.setText(translate("Fairing", "Pick an edge") if button.isChecked() else _text(links))
            getattr(self._ui, f"{side}CurveRemoveButton").setEnabled(bool(links))

    @property
    def _picked_side(self) -> Optional[int]:
        return next((position for position in range(len(SIDES)) if self._button(position).isChecked()), None)

    def _button(self, position: int):
        return getattr(self._ui, f"{SIDES[position]}CurveButton")

    def _toggled(self, position: int, on: bool) -> None:
        if on:
            self._button(1 - position).setChecked(False)
        self.show()

    def _set(self, position: int, links) -> None:
        self._session.set_curve(position, links)
        self.changed.emit()


def _text(links) -> str:
    """The curve in few words: the button is small."""
    count = sum(len(names) for _, names in links)
    if not links:
        return translate("Fairing", "To a curve")
    if len(links) == 1 and count <= 1:
        obj, names = links[0]
        return f"{obj.Label}: {names[0]}" if names else obj.Label
    if all(names for _, names in links):
        return translate("Fairing", "{} edges").format(count)
    return ", ".join(obj.Label for obj, _ in links)
