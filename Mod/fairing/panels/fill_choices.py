# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lower half of the panels: layout where there is any, energy, result and limits."""

from __future__ import annotations

import FreeCAD as App
from PySide import QtCore

from ..choices import ENERGIES, INNER, LAYOUTS, RESULTS
from ..translation import translate
from .pause import pause
from .quantities import show_quantity

ANGLE_STEP = 0.01  # degrees, of the arrows beside the number
TYPING_PAUSE = 250  # ms without a key before a typed number counts


def energy_sentences() -> tuple[str, ...]:
    """On each of ENERGIES."""
    return (
        translate("Fairing", "Bends as little as possible."),
        translate("Fairing", "Stretches as little as possible."),
        translate("Fairing", "Changes its curvature as little as possible: fair and quick."),
        translate("Fairing", "The same, taken to its minimum: slower."),
        translate("Fairing", "Brings back spheres, cylinders, cones and tori. Slower."),
        translate("Fairing", "Bends as little as possible, whatever the parameters. Slower."),
        translate("Fairing", "Bends as evenly as possible; quick."),
    )


class LimitChoices(QtCore.QObject):
    """Shows the choices of a session that any surface has, energy, result, limits and how patches meet, and
    writes the user's into it; the rest of the form is hidden. Emits changed()."""

    changed = QtCore.Signal()
    HIDDEN = ("layoutLabel", "layoutCombo")

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session = ui, session
        for position, sentence in enumerate(energy_sentences()):
            ui.energyCombo.setItemData(position, sentence, QtCore.Qt.ToolTipRole)
        self._pause = pause(self, TYPING_PAUSE, self._read)
        for name in self.HIDDEN:
            getattr(ui, name).setVisible(False)
        self._show()
        self._connect()

    def show_limits(self, limits: dict) -> None:
        """What an automatic limit came to."""
        if self._ui.gapAutoCheck.isChecked():
            self._ui.gapSpin.blockSignals(True)
            show_quantity(self._ui.gapSpin, limits["gap"], App.Units.Length, figures=3)
            self._ui.gapSpin.blockSignals(False)

    def _show(self) -> None:
        ui, request = self._ui, self._session.request
        ui.energyCombo.setCurrentIndex(ENERGIES.index(request.energy))
        ui.resultCombo.setCurrentIndex(RESULTS.index(request.result))
        ui.angleSpin.setProperty("singleStep", ANGLE_STEP)
        show_quantity(ui.angleSpin, request.angle_tolerance, App.Units.Angle)
        ui.gapAutoCheck.setChecked(request.gap_tolerance is None)
        show_quantity(ui.gapSpin, request.gap_tolerance or 0.0, App.Units.Length)
        ui.degreeSpin.setValue(request.degree or ui.degreeSpin.minimum())
        ui.polesSpin.setValue(request.max_poles)
        ui.innerCombo.setCurrentIndex(INNER.index(request.inner_continuity))
        self._show_hints()

    def _connect(self) -> None:
        ui = self._ui
        for combo in (ui.energyCombo, ui.resultCombo, ui.innerCombo):
            combo.currentIndexChanged.connect(self._read)
        ui.gapAutoCheck.toggled.connect(self._read)
        for widget in (ui.degreeSpin, ui.polesSpin, ui.gapSpin, ui.angleSpin):
            widget.valueChanged.connect(lambda *_: self._pause.start())

    def _read(self, *_) -> None:
        self._session.change(**self._chosen())
        self._show_hints()
        self.changed.emit()

    def _chosen(self) -> dict:
        """What the form shows, by the names of the session's request."""
        ui = self._ui
        degree = ui.degreeSpin.value()
        return dict(
            energy=ENERGIES[ui.energyCombo.currentIndex()], result=RESULTS[ui.resultCombo.currentIndex()],
            gap_tolerance=None if ui.gapAutoCheck.isChecked() else ui.gapSpin.property("rawValue"),
            angle_tolerance=ui.angleSpin.property("rawValue"),
            degree=0 if degree == ui.degreeSpin.minimum() else degree, max_poles=ui.polesSpin.value(),
            inner_continuity=INNER[ui.innerCombo.currentIndex()])

    def _show_hints(self, *_) -> None:
        """What depends on other choices: sentences, labels, what is enabled."""
        ui = self._ui
        ui.energyHint.setText(ui.energyCombo.currentData(QtCore.Qt.ToolTipRole))
        ui.gapSpin.setEnabled(not ui.gapAutoCheck.isChecked())


class FillChoices(LimitChoices):
    """Those of a fill (of one hole or of all): also the layout."""

    HIDDEN = ()

    def show_layout(self, used: str) -> None:
        """What the automatic choice came to, beside its name; empty while that is not known."""
        auto = translate("Fairing", "Automatic")
        self._ui.layoutCombo.setItemText(0, f"{auto}: {used}" if used else auto)

    def _show(self) -> None:
        self._ui.layoutCombo.setCurrentIndex(LAYOUTS.index(self._session.request.layout))
        super()._show()

    def _connect(self) -> None:
        super()._connect()
        self._ui.layoutCombo.currentIndexChanged.connect(self._read)

    def _chosen(self) -> dict:
        return dict(super()._chosen(), layout=LAYOUTS[self._ui.layoutCombo.currentIndex()])
