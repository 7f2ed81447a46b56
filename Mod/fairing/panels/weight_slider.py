# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slider and a number for a weight that spans many magnitudes."""

from __future__ import annotations

import math

from PySide import QtCore

SMALLEST, LARGEST = 1e-1, 1e7  # what the slider reaches; 0 is its left end, larger numbers can be typed


class WeightSlider(QtCore.QObject):
    """Keeps a QSlider (logarithmic, 0 at the left) and a QDoubleSpinBox in step. Emits changed(value)."""

    changed = QtCore.Signal(float)

    def __init__(self, slider, spin, value: float = 0.0):
        super().__init__(slider)
        self._slider, self._spin = slider, spin
        self._show(value)
        slider.valueChanged.connect(self._slid)
        spin.valueChanged.connect(self._typed)

    def value(self) -> float:
        return self._spin.value()

    def set_enabled(self, enabled: bool) -> None:
        self._slider.setEnabled(enabled)
        self._spin.setEnabled(enabled)

    def _show(self, value: float) -> None:
        for widget, shown in ((self._spin, value), (self._slider, self._position(value))):
            widget.blockSignals(True)
            widget.setValue(shown)
            widget.blockSignals(False)

    def _slid(self, position: int) -> None:
        value = self._weight(position)
        self._show(value)
        self.changed.emit(value)

    def _typed(self, value: float) -> None:
        self._show(value)
        self.changed.emit(value)

    def _weight(self, position: int) -> float:
        if position == 0:
            return 0.0
        share = (position - 1) / (self._slider.maximum() - 1)
        exact = SMALLEST * (LARGEST / SMALLEST) ** share
        return float(f"{exact:.2g}")

    def _position(self, value: float) -> int:
        if value <= 0.0:
            return 0
        share = math.log(value / SMALLEST) / math.log(LARGEST / SMALLEST)
        return 1 + round(min(max(share, 0.0), 1.0) * (self._slider.maximum() - 1))
