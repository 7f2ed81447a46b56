# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sliders with a number beside them, for quantities that span magnitudes."""

from __future__ import annotations

import math

from PySide import QtCore

SMALLEST, LARGEST = 1e-1, 1e7  # what a weight's slider reaches; 0 is its left end, larger numbers can be typed
FARTHEST = 5.0  # reach at the right end of its slider, its inverse at the left end; the spin box takes more


class NumberSlider(QtCore.QObject):
    """Keeps a QSlider and a QDoubleSpinBox in step. Emits changed(value) when the user changes either; subclasses say
    how positions and values belong together."""

    changed = QtCore.Signal(float)

    def __init__(self, slider, spin, value: float):
        super().__init__(slider)
        self._slider, self._spin = slider, spin
        self.show(value)
        slider.valueChanged.connect(self._slid)
        spin.valueChanged.connect(self._typed)

    def value(self) -> float:
        return self._spin.value()

    def set_enabled(self, enabled: bool) -> None:
        self._slider.setEnabled(enabled)
        self._spin.setEnabled(enabled)

    def show(self, value: float) -> None:
        """Another value, without a signal."""
        for widget, shown in ((self._spin, value), (self._slider, self._position(value))):
            widget.blockSignals(True)
            widget.setValue(shown)
            widget.blockSignals(False)

    def _value(self, position: int) -> float:
        raise NotImplementedError

    def _position(self, value: float) -> int:
        raise NotImplementedError

    def _slid(self, position: int) -> None:
        self._typed(self._value(position))

    def _typed(self, value: float) -> None:
        self.show(value)
        self.changed.emit(value)


class WeightSlider(NumberSlider):
    """A weight: logarithmic, 0 at the left."""

    def _value(self, position: int) -> float:
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


class ReachSlider(NumberSlider):
    """A reach: logarithmic, 1 in the middle. The slider runs from -n to n."""

    def _value(self, position: int) -> float:
        return round(FARTHEST ** (position / self._slider.maximum()), 2)

    def _position(self, value: float) -> int:
        share = math.log(value) / math.log(FARTHEST) if value > 0.0 else -1.0
        return round(min(max(share, -1.0), 1.0) * self._slider.maximum())


class ShareSlider(NumberSlider):
    """A share that is even on either side of 0: the slider runs from -n to n, the value from -0.5 to 0.5."""

    def _value(self, position: int) -> float:
        return round(0.5 * position / self._slider.maximum(), 3)

    def _position(self, value: float) -> int:
        return round(2.0 * value * self._slider.maximum())
