# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels have in common whose surface may be made with several energies, to be compared."""

from __future__ import annotations

from ..choices import ENERGIES
from .compare_dialog import CompareDialog
from .guided_panel import GuidedPanel
from .guided_session import MESH_POINTS


class ComparedPanel(GuidedPanel):
    """With Compare beside the list of energies."""

    _comparison = None  # the dialog, while it is open

    def _set_up(self) -> None:
        super()._set_up()
        self._choices_ui.compareButton.clicked.connect(self._compare)

    def _start_anew(self) -> None:
        super()._start_anew()
        self._drop_comparison()

    def _guide(self) -> None:
        self._drop_comparison()
        super()._guide()

    def _compare(self) -> None:
        """Has the surface made with every energy."""
        if self._comparison is not None or self._session.problem:
            return
        combo = self._choices_ui.energyCombo
        names = [combo.itemText(position) for position in range(combo.count())]
        self._comparison = CompareDialog(*self._session.asked(), names, self._show_compared, self._use,
                                         self._end_comparison)

    def _drop_comparison(self) -> None:
        """What it compares is asked no longer."""
        if self._comparison is not None:
            self._comparison.drop()
            self._comparison = None

    def _show_compared(self, native) -> None:
        """Another energy's surface, to be looked at."""
        self._say(*self._judge(native, native.report))
        self._display.show_fill(native.report, native.mesh(MESH_POINTS))
        self._draw_picture(native)

    def _use(self, energy: str) -> None:
        self._comparison = None
        combo, position = self._choices_ui.energyCombo, ENERGIES.index(energy)
        if combo.currentIndex() != position:
            combo.setCurrentIndex(position)  # the panel takes it from there
        else:
            self._refresh()

    def _end_comparison(self) -> None:
        """Back to what is chosen."""
        self._comparison = None
        self._refresh()

    def _detach(self) -> None:
        self._drop_comparison()
        super()._detach()
