# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is rarely chosen about a blend, folded away: how either side is left, and what belongs together."""

from __future__ import annotations

import FreeCAD as App
from PySide import QtCore

from ..choices import DEPARTURES, MATCHES
from .fill_choices import TYPING_PAUSE
from .pause import pause
from .quantities import show_quantity
from .sliders import ShareSlider

SIDES = ("from", "to")


class MoreChoices(QtCore.QObject):
    """Shows these choices of a BlendSession and writes the user's into it. Emits changed()."""

    changed = QtCore.Signal()

    def __init__(self, ui, session):
        super().__init__(ui)
        self._ui, self._session = ui, session
        self._alignment = ShareSlider(ui.alignmentSlider, ui.alignmentSpin, session.request.alignment)
        self._pause = pause(self, TYPING_PAUSE, self._read)
        self._show()
        self._connect()
        ui.moreButton.setChecked(self._differ())
        self._fold()

    def show_sides(self) -> None:
        """What makes sense for the sides as they are now."""
        ui, session = self._ui, self._session
        ui.moreButton.setVisible(session.is_strip)
        ui.moreBox.setVisible(session.is_strip and ui.moreButton.isChecked())
        for side in SIDES:
            getattr(ui, f"{side}ReachEndCheck").setEnabled(not session.is_closed)
            self._enable_end(side)
        self._alignment.set_enabled(session.is_closed)

    def show_ends(self) -> None:
        """Reaches at the ends that changed elsewhere."""
        for side in SIDES:
            spin, end = getattr(self._ui, f"{side}ReachEndSpin"), getattr(self._session.request, f"{side}_reach_end")
            if end is not None:
                spin.blockSignals(True)
                spin.setValue(end)
                spin.blockSignals(False)

    def _show(self) -> None:
        ui, request = self._ui, self._session.request
        for side in SIDES:
            end = getattr(request, f"{side}_reach_end")
            getattr(ui, f"{side}ReachEndCheck").setChecked(end is not None)
            getattr(ui, f"{side}ReachEndSpin").setValue(end or getattr(request, f"{side}_reach"))
            getattr(ui, f"{side}DepartureCombo").setCurrentIndex(
                DEPARTURES.index(getattr(request, f"{side}_departure")))
            getattr(ui, f"{side}FlipCheck").setChecked(getattr(request, f"{side}_flip"))
            show_quantity(getattr(ui, f"{side}SetbackSpin"), getattr(request, f"{side}_setback"), App.Units.Length)
        ui.matchCombo.setCurrentIndex(MATCHES.index(request.match))

    def _connect(self) -> None:
        ui = self._ui
        ui.moreButton.toggled.connect(self._fold)
        for side in SIDES:
            getattr(ui, f"{side}DepartureCombo").currentIndexChanged.connect(self._read)
            getattr(ui, f"{side}FlipCheck").toggled.connect(self._read)
            getattr(ui, f"{side}ReachEndCheck").toggled.connect(lambda *_, side=side: self._end_toggled(side))
            for name in ("ReachEndSpin", "SetbackSpin"):
                getattr(ui, side + name).valueChanged.connect(lambda *_: self._pause.start())
        ui.matchCombo.currentIndexChanged.connect(self._read)
        self._alignment.changed.connect(lambda _: self._pause.start())

    def _end_toggled(self, side: str) -> None:
        """An end starts out with the reach of the whole side."""
        spin = getattr(self._ui, f"{side}ReachEndSpin")
        spin.blockSignals(True)
        spin.setValue(getattr(self._session.request, f"{side}_reach"))
        spin.blockSignals(False)
        self._enable_end(side)
        self._read()

    def _enable_end(self, side: str) -> None:
        check = getattr(self._ui, f"{side}ReachEndCheck")
        getattr(self._ui, f"{side}ReachEndSpin").setEnabled(check.isEnabled() and check.isChecked())

    def _read(self, *_) -> None:
        self._session.change(**self._chosen())
        self.changed.emit()

    def _chosen(self) -> dict:
        ui, chosen = self._ui, {}
        for side in SIDES:
            ends = getattr(ui, f"{side}ReachEndCheck").isChecked()
            chosen[f"{side}_reach_end"] = getattr(ui, f"{side}ReachEndSpin").value() if ends else None
            chosen[f"{side}_departure"] = DEPARTURES[getattr(ui, f"{side}DepartureCombo").currentIndex()]
            chosen[f"{side}_flip"] = getattr(ui, f"{side}FlipCheck").isChecked()
            chosen[f"{side}_setback"] = getattr(ui, f"{side}SetbackSpin").property("rawValue")
        return dict(chosen, match=MATCHES[ui.matchCombo.currentIndex()], alignment=self._alignment.value())

    def _differ(self) -> bool:
        """Whether anything here was chosen, so that it should be seen."""
        plain = type(self._session.request)()
        return bool(self._session.pairs or self._session.ends) or any(self._session.curves) or any(
            getattr(plain, name) != getattr(self._session.request, name) for name in self._chosen())

    def _fold(self, *_) -> None:
        shown = self._ui.moreButton.isChecked()
        self._ui.moreButton.setArrowType(QtCore.Qt.DownArrow if shown else QtCore.Qt.RightArrow)
        self._ui.moreBox.setVisible(shown)
