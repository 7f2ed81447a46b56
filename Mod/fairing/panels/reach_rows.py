# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach of either side of a blend as sliders under its tables."""

from __future__ import annotations

from PySide import QtCore

from .sliders import ReachSlider


class ReachRows(QtCore.QObject):
    """Emits changed(side, reach) when the user moves a slider or types a number."""

    changed = QtCore.Signal(int, float)

    def __init__(self, ui, reaches):
        super().__init__(ui)
        self._rows = (ui.fromReachRow, ui.toReachRow, ui.reachHint)
        self._sliders = [ReachSlider(ui.fromReachSlider, ui.fromReachSpin, reaches[0]),
                         ReachSlider(ui.toReachSlider, ui.toReachSpin, reaches[1])]
        for side, slider in enumerate(self._sliders):
            slider.changed.connect(lambda value, side=side: self.changed.emit(side, value))

    def show(self, reaches) -> None:
        for slider, reach in zip(self._sliders, reaches):
            slider.show(reach)

    def set_visible(self, visible: bool) -> None:
        for row in self._rows:
            row.setVisible(visible)
