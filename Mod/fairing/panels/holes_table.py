# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of the holes of an object: which are filled, and how well."""

from __future__ import annotations

from typing import Optional

from PySide import QtCore, QtGui

from ..features.fill_all_properties import largest_angle
from ..translation import translate
from . import status
from .quantities import angle_text, length_text

HOLE, SIDES, LAYOUT, GAP, ANGLE, VERDICT = range(6)
NUMBER_WIDTH = 64  # pixels
LARGEST_HEIGHT = 9  # rows shown without scrolling
ROW_HEIGHT = 22  # pixels


class HolesTable(QtCore.QObject):
    """Wraps the form's QTableWidget. Emits chosen() when the user ticks or unticks a hole, and pointed(position) when a
    row is selected, -1 for none."""

    chosen = QtCore.Signal()
    pointed = QtCore.Signal(int)

    def __init__(self, widget: QtGui.QTableWidget):
        super().__init__(widget)
        self._widget = widget
        header = widget.horizontalHeader()
        for column in range(widget.columnCount()):
            header.setSectionResizeMode(column, QtGui.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(VERDICT, QtGui.QHeaderView.Stretch)
        widget.verticalHeader().setDefaultSectionSize(ROW_HEIGHT)
        widget.setIconSize(QtCore.QSize(14, 14))
        widget.itemChanged.connect(self._changed)
        widget.itemSelectionChanged.connect(self._selected)

    def show_holes(self, holes: list[list[int]], filled: list[bool]) -> None:
        """One row a hole, not measured yet. Rows that stay keep their numbers until new ones come."""
        self._widget.blockSignals(True)
        if len(holes) != self._widget.rowCount():
            self._widget.setRowCount(0)
            self._widget.setRowCount(len(holes))
        for row, (hole, tick) in enumerate(zip(holes, filled)):
            item = self._item(row, HOLE, str(row + 1))
            item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Checked if tick else QtCore.Qt.Unchecked)
            edges = ", ".join(f"Edge{number}" for number in hole)
            for column in range(self._widget.columnCount()):
                self._item(row, column).setToolTip(edges)
            self._item(row, SIDES, str(len(hole)))
        self._widget.blockSignals(False)
        self._widget.setVisible(bool(holes))
        self.fit_height()

    def show_fills(self, fills: list) -> None:
        """Fills in what was measured: a native HoleFill a row, or None."""
        self._widget.blockSignals(True)
        for row, hole in enumerate(fills):
            report = hole.fill.report if hole and hole.fill else None
            sign = status.of_hole(hole)
            self._item(row, HOLE).setIcon(QtGui.QIcon(sign.pixmap(14)))
            self._item(row, LAYOUT, report["layout"] if report else "")
            self._item(row, GAP, length_text(report["largest_gap"]) if report else "")
            self._item(row, ANGLE, angle_text(largest_angle(report)) if report else "")
            self._item(row, VERDICT, _word(hole)).setToolTip(sentence_of(hole))
        self._widget.blockSignals(False)

    def ticks(self) -> list[bool]:
        return [self._item(row, HOLE).checkState() == QtCore.Qt.Checked for row in range(self._widget.rowCount())]

    def select(self, row: int) -> None:
        if 0 <= row < self._widget.rowCount():
            self._widget.selectRow(row)

    def needed_width(self) -> int:
        """Pixels for every column to show in full, numbers that are still to come included."""
        header = self._widget.horizontalHeader()
        widths = [max(header.sectionSizeHint(column), self._widget.sizeHintForColumn(column))
                  for column in range(self._widget.columnCount())]
        for column in (GAP, ANGLE, LAYOUT):
            widths[column] = max(widths[column], NUMBER_WIDTH)
        return sum(widths) + 2 * self._widget.frameWidth()

    def fit_height(self) -> None:
        """Shows every row of a usual object; once more when the window's style has been applied."""
        rows = min(self._widget.rowCount(), LARGEST_HEIGHT)
        height = self._widget.horizontalHeader().sizeHint().height() + 2 * self._widget.frameWidth()
        self._widget.setFixedHeight(height + rows * ROW_HEIGHT)

    def _changed(self, item: QtGui.QTableWidgetItem) -> None:
        if item.column() == HOLE:
            self.chosen.emit()

    def _selected(self) -> None:
        rows = [index.row() for index in self._widget.selectedIndexes()]
        self.pointed.emit(rows[0] if rows else -1)

    def _item(self, row: int, column: int, text: Optional[str] = None) -> QtGui.QTableWidgetItem:
        item = self._widget.item(row, column)
        if item is None:
            item = QtGui.QTableWidgetItem()
            item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable)
            if column in (SIDES, GAP, ANGLE):
                item.setTextAlignment(int(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter))
            self._widget.setItem(row, column, item)
        if text is not None:
            item.setText(text)
        return item


def sentence_of(hole) -> str:
    """The verdict on a native HoleFill, or why there is no surface."""
    if hole is None:
        return ""
    return hole.fill.verdict if hole.fill else hole.error


def _word(hole) -> str:
    if hole is None:
        return ""
    if not hole.fill:
        return translate("Fairing", "not filled")
    return translate("Fairing", "good") if hole.fill.within_tolerance else translate("Fairing", "out of tolerance")
