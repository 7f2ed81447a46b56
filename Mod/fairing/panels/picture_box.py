# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panels that says which picture of the curvature is shown, over which range, and what it is under the
mouse."""

from __future__ import annotations

from typing import Optional

import numpy as np
from PySide import QtCore, QtGui

from ..pictures import NONE, PICTURES, QUANTITIES, SYMBOLS, UNITS, ZEBRA, is_signed
from ..translation import translate
from . import picture_colors as colors
from .fill_choices import TYPING_PAUSE
from .pause import pause
from .quantities import point_text

FIGURES = 4  # of a curvature
NOTHING = 1e-11  # below that a number is rounding


class PictureBox(QtCore.QObject):
    """Emits changed() where another picture, range or number of stripes is wanted."""

    changed = QtCore.Signal()

    def __init__(self, ui):
        super().__init__(ui)
        self._ui = ui
        self._pause = pause(self, TYPING_PAUSE, self._typed)
        for field in (ui.pictureLow, ui.pictureHigh):
            field.setValidator(_NumberValidator(field))
            field.textEdited.connect(lambda *_: self._edited())
        names = ui.pictureCombo.view()
        names.setMinimumWidth(names.sizeHintForColumn(0) + 2 * names.frameWidth())  # whatever room the list itself has
        ui.pictureCombo.currentIndexChanged.connect(self._chosen)
        ui.pictureAutoCheck.toggled.connect(self.changed)
        ui.stripesSpin.valueChanged.connect(self.changed)
        self._chosen()

    @property
    def picture(self) -> str:
        """One of PICTURES."""
        return PICTURES[self._ui.pictureCombo.currentIndex()]

    @picture.setter
    def picture(self, word: str) -> None:
        self._ui.pictureCombo.setCurrentIndex(PICTURES.index(word))

    @property
    def stripes(self) -> int:
        return self._ui.stripesSpin.value()

    @property
    def range(self) -> Optional[tuple[float, float]]:
        """What the user asks for; None: the picture's own."""
        if self._ui.pictureAutoCheck.isChecked():
            return None
        low, high = (_number(field.text()) for field in (self._ui.pictureLow, self._ui.pictureHigh))
        return (low, high) if None not in (low, high) and low < high else None

    def show_range(self, low: float, high: float) -> None:
        """What the colours stand for."""
        if self._ui.pictureAutoCheck.isChecked():
            self._ui.pictureLow.setText(_text(low))
            self._ui.pictureHigh.setText(_text(high))
        self._ui.pictureUnit.setText(UNITS[QUANTITIES.index(self.picture)])

    def show_place(self, place: Optional[dict]) -> None:
        """What the native module tells of a place; None: there is none, and the last one stays to be copied."""
        if place is not None:
            self._ui.placeLabel.setText(place_text(place))

    def forget_place(self) -> None:
        self._ui.placeLabel.setText(translate("Fairing", "Point at the picture to read its values."))

    def _chosen(self, *_) -> None:
        ui, picture = self._ui, self.picture
        is_map = picture in QUANTITIES
        for widget in (ui.scaleLabel, ui.pictureLow, ui.pictureUnit, ui.pictureHigh, ui.pictureAutoCheck):
            widget.setVisible(is_map)
        for widget in (ui.stripesLabel, ui.stripesSpin):
            widget.setVisible(picture == ZEBRA)
        ui.placeLabel.setVisible(picture != NONE)
        self.forget_place()
        if is_map:
            ui.scaleLabel.setPixmap(_bar(is_signed(picture)))
            ui.pictureAutoCheck.blockSignals(True)
            ui.pictureAutoCheck.setChecked(True)  # another quantity, another range
            ui.pictureAutoCheck.blockSignals(False)
        self.changed.emit()

    def _edited(self) -> None:
        """A number typed in is no automatic one."""
        self._ui.pictureAutoCheck.blockSignals(True)
        self._ui.pictureAutoCheck.setChecked(False)
        self._ui.pictureAutoCheck.blockSignals(False)
        self._pause.start()

    def _typed(self) -> None:
        if self.range is not None:
            self.changed.emit()


class _NumberValidator(QtGui.QDoubleValidator):
    """Numbers as programs write them, whatever the language: the texts shown are."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setLocale(QtCore.QLocale.c())
        self.setNotation(QtGui.QDoubleValidator.ScientificNotation)


def place_text(place: dict) -> str:
    """Two lines: where, and what."""
    values = [f"{symbol}\u00a0{_text(place['values'][quantity])}" for quantity, symbol in zip(QUANTITIES, SYMBOLS)]
    lengths = ", ".join(values[k] for k in (0, 2, 3))
    squares = ", ".join(values[k] for k in (1, 4))
    return f"{point_text(place['point'])}\n{lengths} {UNITS[0]}\n{squares} {UNITS[1]}"


def _text(number: float) -> str:
    if not np.isfinite(number):
        return "\u2013"
    return f"{number:.{FIGURES}g}" if abs(number) >= NOTHING else "0"


def _number(text: str) -> Optional[float]:
    try:
        return float(text)
    except ValueError:
        return None


def _bar(signed: bool) -> QtGui.QPixmap:
    """The scale from left to right, to be stretched."""
    line = np.ascontiguousarray(colors.scale(signed)[None])
    image = QtGui.QImage(line.tobytes(), colors.STEPS, 1, 3 * colors.STEPS, QtGui.QImage.Format_RGB888)
    return QtGui.QPixmap.fromImage(image.copy())
