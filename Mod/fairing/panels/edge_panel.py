# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels with a table of edges have in common: how each edge is met, in the table and by its label."""

from __future__ import annotations

from typing import Optional

from PySide import QtCore

from ..choices import CONTINUITIES
from . import status
from .fill_display import FillDisplay
from .solving_panel import SolvingPanel


class EdgePanel(SolvingPanel):
    """One surface that meets edges: subclasses make their table of edges, and may have a picture of their own."""

    DISPLAY = FillDisplay

    def _make_table(self):
        """A BoundaryTable, or what can be used like one."""
        raise NotImplementedError

    def _set_up(self) -> None:
        ui = self._ui
        self._table = self._make_table()
        self._display = self.DISPLAY(self._view, self._session, self._label_clicked, self._table.select)
        self._table.chosen.connect(lambda edge, word: self._set_continuity(word, edge))
        self._table.pointed.connect(self._display.point_at)
        for word in CONTINUITIES:
            button = getattr(ui, f"all{word}Button")
            button.clicked.connect(lambda *_, word=word: self._set_continuity(word))
        ui.clearButton.clicked.connect(self._clear)

    def _label_clicked(self, edge: int, with_shift: bool) -> None:
        """The next continuity, for all edges with shift. Later, since the label under the mouse is made anew."""
        current = next(side["continuity"] for side in self._session.loop if side["edge"] == edge)
        word = CONTINUITIES[(CONTINUITIES.index(current) + 1) % len(CONTINUITIES)]
        QtCore.QTimer.singleShot(0, lambda: self._set_continuity(word, None if with_shift else edge))

    def _set_continuity(self, word: str, edge: Optional[int] = None) -> None:
        self._session.set_continuity(word, edge)
        self._refresh()

    def _clear(self) -> None:
        self._session.clear()
        self._refresh()

    def _show_picks(self, has_picks: bool) -> None:
        """What depends on whether an edge is picked."""
        ui = self._ui
        for widget in (ui.allG2Button, ui.allG1Button, ui.allG0Button, ui.clearButton):
            widget.setEnabled(has_picks)

    def _show_result(self, value):
        self._result = value[0]
        return self._show_surface(*value)

    def _show_surface(self, fill, mesh):
        """Draws a native Fill and its numbers, and says how good it is."""
        report = fill.report
        self._display.show_fill(report, mesh)
        self._show_report(report)
        sign, verdict = self._judge(fill, report)
        self._ui.verdictLabel.setToolTip(fill.composition + verdict[len(fill.verdict):])
        return sign, verdict

    def _judge(self, fill, report: dict) -> tuple[status.Status, str]:
        """How good a native Fill is: its verdict, and its notes."""
        return status.of_fill(fill), fill.verdict + "".join(f"\n{note['text']}" for note in report["notes"])

    def _show_report(self, report: dict) -> None:
        self._table.show_report(report)
        self._choices.show_limits(report["limits"])

    def _show_nothing(self) -> None:
        self._display.show_unsolved()
        self._table.show_report(None)
        self._ui.verdictLabel.setToolTip("")
