# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values of the selected guide: direction, weight and radius."""

from __future__ import annotations

import FreeCAD as App
from PySide import QtCore

from ..features.guides import FeatureCurve, frozen_links
from ..translation import translate
from .quantities import show_quantity


class GuideFields(QtCore.QObject):
    """Shows one guide of a session and writes the user's values into it. Emits changed(position) then, and
    failed(sentence) where a value cannot be."""

    changed = QtCore.Signal(int)
    failed = QtCore.Signal(str)

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session, self._position = ui, session, -1
        self._spins = (ui.xSpin, ui.ySpin, ui.zSpin)
        for spin in self._spins:
            spin.setKeyboardTracking(False)  # half a direction is none
            spin.valueChanged.connect(self._turned)
        ui.weightSpin.valueChanged.connect(lambda weight: self._change(weight=weight))
        ui.radiusSpin.valueChanged.connect(lambda *_: self._change(radius=ui.radiusSpin.property("rawValue")))
        ui.directionButton.toggled.connect(lambda *_: self._prompt())
        self.show(-1)

    @property
    def is_picking(self) -> bool:
        return self._ui.directionButton.isChecked()

    def show(self, position: int) -> None:
        """One of the session's guides, -1 for none."""
        if position != self._position:
            self._ui.directionButton.setChecked(False)
        self._position = position
        self._ui.guideRow.setVisible(position >= 0)
        if position < 0:
            return
        guide = self._session.guides[position]
        widgets = (*self._spins, self._ui.weightSpin, self._ui.radiusSpin)
        for widget in widgets:
            widget.blockSignals(True)
        for spin, number in zip(self._spins, self._normal(guide)):
            spin.setValue(number)
        self._ui.weightSpin.setValue(guide.weight)
        show_quantity(self._ui.radiusSpin, guide.radius, App.Units.Length, figures=4)
        for widget in widgets:
            widget.blockSignals(False)
        self._prompt()

    def picked(self, obj: App.DocumentObject, name: str) -> None:
        """What tells the direction: of a handle a face, an edge or an object, of a curve faces."""
        link = frozen_links((obj, [name] if name else []))
        is_curve = isinstance(self._session.guides[self._position], FeatureCurve)
        if self._change(**({"faces": link, "normal": None} if is_curve else {"direction": link})):
            self._ui.directionButton.setChecked(False)
            self.show(self._position)

    def _normal(self, guide):
        if isinstance(guide, FeatureCurve):
            return guide.normal or (0.0, 0.0, 0.0)
        return self._session.normal_of(self._position)

    def _turned(self, *_) -> None:
        """A typed direction stands for itself; none at all lets a curve take that of its faces."""
        typed = tuple(spin.value() for spin in self._spins)
        if isinstance(self._session.guides[self._position], FeatureCurve):
            self._change(normal=typed if any(typed) else None)
        else:
            self._change(normal=typed, direction=())

    def _change(self, **changes) -> bool:
        try:
            self._session.change_guide(self._position, **changes)
        except ValueError as error:
            self.failed.emit(str(error))
            return False
        self.changed.emit(self._position)
        return True

    def _prompt(self) -> None:
        self._ui.directionButton.setText(translate("Fairing", "Pick it") if self.is_picking
                                         else translate("Fairing", "From \u2026"))
