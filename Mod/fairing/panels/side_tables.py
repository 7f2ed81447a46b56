# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two tables of a blend's edges, one a side, used as one."""

from __future__ import annotations

from PySide import QtCore

from .boundary_table import BoundaryTable


class SideTables(QtCore.QObject):
    """Emits chosen(edge, continuity) and pointed(edge) as BoundaryTable does."""

    chosen = QtCore.Signal(int, str)
    pointed = QtCore.Signal(int)

    def __init__(self, ui):
        super().__init__(ui)
        self._tables = [BoundaryTable(ui.fromTable), BoundaryTable(ui.toTable)]
        for table in self._tables:
            table.chosen.connect(self.chosen)
            table.pointed.connect(self.pointed)

    def show(self, loops, request) -> None:
        """The picked edges of either side, not measured yet."""
        for table, loop in zip(self._tables, loops):
            table.show_loop(loop, request)

    def show_report(self, report) -> None:
        """Fills in what was measured; None: nothing is."""
        for table in self._tables:
            table.show_report(report)

    def select(self, edge: int) -> None:
        for table in self._tables:
            table.select(edge)

    def fit_height(self) -> None:
        for table in self._tables:
            table.fit_height()

    def needed_width(self) -> int:
        """Pixels for every column of both to show in full."""
        return max(table.needed_width() for table in self._tables)
