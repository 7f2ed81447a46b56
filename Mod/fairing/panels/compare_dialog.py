# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same surface with every energy, side by side: values in a table, shapes in the 3D view."""

from __future__ import annotations

from typing import Callable

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import native, paths
from ..choices import ENERGIES
from ..comparison import Solved, asks_for_curvature, largest_angle, solve_each
from . import status
from .background import BackgroundSolver
from .quantities import angle_text, length_text, percent_text

CURVATURE = 3  # the column that is there for G2 only
FIRST_VALUE = 4  # columns from here on: the less, the fairer
VALUES = ("thin_plate", "total_curvature", "mean_curvature_gradient", "minimum_variation")
MARGIN = 40  # pixels from the window's lower right corner
SAME = 1.0 + 1e-6  # a value so close to the least is the least, too


class CompareDialog:
    """on_show(native Fill) when a row is selected, on_use(energy) and on_close() when the user is done."""

    def __init__(self, request, brep: bytes, names: list[str], on_show: Callable, on_use: Callable, on_close: Callable):
        self._names, self._rows, self._fairness = names, [], {}
        self._on_show, self._on_use, self._on_close = on_show, on_use, on_close
        self._ui = Gui.PySideUic.loadUi(paths.form("compare.ui"))
        self._ui.setParent(Gui.getMainWindow(), QtCore.Qt.Tool)
        self._table, self._is_open = self._ui.compareTable, True
        self._table.setRowCount(len(ENERGIES))
        self._stood = self._ui.pos()
        self._show_names()
        self._table.itemSelectionChanged.connect(self._select)
        self._ui.useButton.setEnabled(False)
        self._ui.useButton.clicked.connect(self._use)
        self._ui.compareStopButton.clicked.connect(self._stop)
        self._ui.compareCloseButton.clicked.connect(self._ui.close)
        self._ui.finished.connect(lambda *_: self.close())
        self._solver = BackgroundSolver(native.module().Progress, self._done, self._progressed, self._ui)
        found = self._found = []  # of Solved; grows on the other thread

        def solve_all(progress):
            for solved in solve_each(request, brep, ENERGIES, progress):
                found.append(solved)

        self._solver.request(solve_all)
        self._ui.show()
        self._stand_aside()

    def close(self) -> None:
        """Without using any."""
        if self._end():
            self._on_close()

    def drop(self) -> None:
        """What is compared is no longer asked."""
        self._end()

    # --- its own ---

    def _end(self) -> bool:
        if not self._is_open:
            return False
        self._is_open = False
        self._solver.finish()
        self._ui.hide()
        self._ui.deleteLater()
        return True

    def _stand_aside(self) -> None:
        """Below what is looked at."""
        window, own = Gui.getMainWindow(), self._ui.frameGeometry()
        corner = window.mapToGlobal(QtCore.QPoint(window.width(), window.height() - window.statusBar().height()))
        self._ui.move(corner.x() - own.width() - MARGIN, corner.y() - own.height() - MARGIN)
        self._stood = self._ui.pos()

    def _show_names(self) -> None:
        for row, name in enumerate(self._names):
            self._put(row, 0, name)
        self._table.setColumnHidden(CURVATURE, True)
        self._fit()

    def _fit(self) -> None:
        table, header = self._table, self._table.horizontalHeader()
        table.resizeColumnsToContents()
        table.resizeRowsToContents()
        width = header.length() + 2 * table.frameWidth() + table.fontMetrics().height()
        height = table.verticalHeader().length() + header.height() + 2 * table.frameWidth()
        table.setFixedHeight(height)
        table.setMinimumWidth(width)
        self._ui.adjustSize()
        if self._ui.pos() == self._stood:  # who has moved it knows why
            self._stand_aside()

    def _put(self, row: int, column: int, text: str) -> QtGui.QTableWidgetItem:
        item = QtGui.QTableWidgetItem(text)
        if column:
            item.setTextAlignment(int(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter))
        self._table.setItem(row, column, item)
        return item

    def _progressed(self, fraction: float) -> None:
        self._take()
        done = (len(self._rows) + fraction) / len(ENERGIES)
        bar = self._ui.compareProgress
        bar.setValue(round(min(1.0, done) * bar.maximum()))

    def _done(self, value, error) -> None:
        self._take()
        self._show_idle()
        if error is not None:
            self._put(len(self._rows), 1, str(error))

    def _stop(self) -> None:
        self._solver.cancel()
        self._show_idle()

    def _show_idle(self) -> None:
        self._ui.compareProgress.hide()
        self._ui.compareStopButton.hide()

    def _take(self) -> None:
        """Shows what has come since."""
        for solved in self._found[len(self._rows):]:
            self._show_row(len(self._rows), solved)
            self._rows.append(solved)
            self._mark_least()
            self._fit()
            self._select()

    def _show_row(self, row: int, solved: Solved) -> None:
        if solved.fill is None:
            self._put(row, 1, str(solved.error))
            self._table.setSpan(row, 1, 1, self._table.columnCount() - 1)
            return
        report = solved.fill.report
        self._fairness[row] = report["fairness"]
        if asks_for_curvature(report):
            self._table.setColumnHidden(CURVATURE, False)
        self._table.item(row, 0).setIcon(QtGui.QIcon(status.of_fill(solved.fill).pixmap()))
        values = [f"{report['fairness'][name]:.4g}" for name in VALUES]
        texts = [length_text(report["largest_gap"]), angle_text(largest_angle(report)),
                 percent_text(report["largest_curvature"]), *values, f"{report['solve']['total_time']:.2f}"]
        for column, text in enumerate(texts, 1):
            self._put(row, column, text)

    def _mark_least(self) -> None:
        """What each energy is about is told by bold figures."""
        for column, name in enumerate(VALUES, FIRST_VALUE):
            least = min((values[name] for values in self._fairness.values()), default=0.0)
            for row, values in self._fairness.items():
                font = self._table.font()
                font.setBold(values[name] <= least * SAME)
                self._table.item(row, column).setFont(font)

    def _selected(self):
        """The native Fill of the selected row, and its energy; None where there is none yet."""
        rows = self._table.selectionModel().selectedRows()
        row = rows[0].row() if rows else -1
        if 0 <= row < len(self._rows) and self._rows[row].fill is not None:
            return self._rows[row].fill, self._rows[row].energy
        return None

    def _select(self) -> None:
        chosen = self._selected()
        self._ui.useButton.setEnabled(chosen is not None)
        if chosen is not None:
            self._on_show(chosen[0])

    def _use(self) -> None:
        _, energy = self._selected()
        if self._end():
            self._on_use(energy)
