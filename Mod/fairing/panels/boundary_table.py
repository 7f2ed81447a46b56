# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of the edges round the hole: continuity to choose, deviation to read."""

from __future__ import annotations

from PySide import QtCore, QtGui

from . import status
from ..choices import CONTINUITIES, Choices
from ..translation import translate
from .quantities import angle_text, length_text, percent_text

EDGE, FACE, CONTINUITY, GAP, ANGLE, CURVATURE = range(6)
NUMBER_WIDTH = 64  # pixels
LARGEST_HEIGHT = 6  # rows shown without scrolling


class BoundaryTable(QtCore.QObject):
    """Wraps the form's QTableWidget. Emits chosen(edge, continuity) when the user changes a row, and pointed(edge) when
    one is selected, 0 for none."""

    chosen = QtCore.Signal(int, str)
    pointed = QtCore.Signal(int)

    def __init__(self, widget: QtGui.QTableWidget):
        super().__init__(widget)
        self._widget = widget
        self._shown: list[tuple] = []  # what tells the rows apart
        self._rows: dict[int, int] = {}  # edge -> row
        self._combos: dict[int, QtGui.QComboBox] = {}
        self._found: set[int] = set()  # edges that nobody picked
        header = widget.horizontalHeader()
        for column in range(widget.columnCount()):
            header.setSectionResizeMode(column, QtGui.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(CURVATURE, QtGui.QHeaderView.Stretch)
        widget.verticalHeader().setDefaultSectionSize(22)
        widget.itemSelectionChanged.connect(self._selected)
        widget.setIconSize(QtCore.QSize(14, 14))

    def show_loop(self, loop: list[dict], request: Choices) -> None:
        """One row a side, not measured yet. Rows that stay keep their numbers until new ones come."""
        shown = [(side["edge"], side.get("name"), side["face"]) for side in loop]
        if shown != self._shown:
            self._shown = shown
            self._rebuild(loop)
        self._mark_found(loop)
        for side in loop:
            combo = self._combos[side["edge"]]
            combo.blockSignals(True)
            combo.setCurrentText(side["continuity"])
            combo.setEnabled(side["has_normal"])
            combo.blockSignals(False)
        self._widget.setVisible(bool(loop))
        self.fit_height()

    def show_report(self, report) -> None:
        """Fills in what was measured; None: nothing is."""
        sides = {side["edge"]: side for side in report["sides"]} if report else {}
        for edge, row in self._rows.items():
            side = sides.get(edge)
            sign = status.of_side(side, report)
            self._widget.item(row, EDGE).setIcon(QtGui.QIcon(sign.pixmap(14)))
            self._set(row, GAP, length_text(side["gap"]["max"]) if side else "")
            self._set(row, ANGLE, _angle_of(side) if side else "")
            self._set(row, CURVATURE, percent_text(side["curvature"]["max"]) if side and side["has_normal"] else "")
            self._explain(edge, _explanation(side, report) if side else [])

    def needed_width(self) -> int:
        """Pixels for every column to show in full, numbers that are still to come included."""
        header = self._widget.horizontalHeader()
        widths = [max(header.sectionSizeHint(column), self._widget.sizeHintForColumn(column))
                  for column in range(self._widget.columnCount())]
        for column in (GAP, ANGLE):
            widths[column] = max(widths[column], NUMBER_WIDTH)
        return sum(widths) + 2 * self._widget.frameWidth()

    def select(self, edge: int) -> None:
        if edge in self._rows:
            self._widget.selectRow(self._rows[edge])

    def _selected(self) -> None:
        rows = {index.row() for index in self._widget.selectedIndexes()}
        self.pointed.emit(next((edge for edge, row in self._rows.items() if row in rows), 0))

    def _rebuild(self, loop: list[dict]) -> None:
        self._widget.setRowCount(len(loop))
        self._rows = {side["edge"]: row for row, side in enumerate(loop)}
        self._combos = {}
        for row, side in enumerate(loop):
            self._set(row, EDGE, side.get("name") or str(side["edge"]))
            self._set(row, FACE, str(side["face"]) if side["face"] else "\u2013")
            self._set(row, GAP, "")
            self._set(row, ANGLE, "")
            self._set(row, CURVATURE, "")
            self._widget.item(row, EDGE).setIcon(QtGui.QIcon(status.Status.UNKNOWN.pixmap(14)))
            self._widget.setCellWidget(row, CONTINUITY, self._make_combo(side["edge"]))

    def _mark_found(self, loop: list[dict]) -> None:
        """An edge that belongs to the picked ones without having been picked is written slanted."""
        self._found = {side["edge"] for side in loop if side.get("found")}
        for edge, row in self._rows.items():
            font = self._widget.font()
            font.setItalic(edge in self._found)
            self._widget.item(row, EDGE).setFont(font)
            self._explain(edge, [])

    def _explain(self, edge: int, lines: list[str]) -> None:
        found = [translate("Fairing", "Found by itself: it continues a picked edge smoothly")]
        for column in (EDGE, FACE, GAP, ANGLE, CURVATURE):
            self._widget.item(self._rows[edge], column).setToolTip(
                "\n".join((found if edge in self._found else []) + lines))

    def _make_combo(self, edge: int) -> QtGui.QComboBox:
        combo = QtGui.QComboBox()
        combo.setFrame(False)
        combo.addItems(CONTINUITIES)
        combo.setToolTip(translate("Fairing", "G2: with the curvature of the face. G1: tangential to it. G0: only touches the edge."))
        combo.currentTextChanged.connect(lambda word: self.chosen.emit(edge, word))
        self._combos[edge] = combo
        return combo

    def _set(self, row: int, column: int, text: str) -> None:
        item = self._widget.item(row, column)
        if item is None:
            item = QtGui.QTableWidgetItem()
            if column in (FACE, GAP, ANGLE, CURVATURE):
                item.setTextAlignment(int(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter))
            self._widget.setItem(row, column, item)
        item.setText(text)

    def fit_height(self) -> None:
        """Shows every row of a usual hole; once more when the window's style has been applied."""
        rows = min(self._widget.rowCount(), LARGEST_HEIGHT)
        height = self._widget.horizontalHeader().sizeHint().height() + 2 * self._widget.frameWidth()
        self._widget.setFixedHeight(height + rows * self._widget.verticalHeader().defaultSectionSize())


def _angle_of(side: dict) -> str:
    if not side["has_normal"]:
        return "\u2013"
    return angle_text(max(side["angle"]["max"], side["corner_angle"]["max"]))


def _curvature_line(side: dict, report: dict) -> str:
    found = percent_text(side["curvature"]["max"])
    if side["asked"] != "G2":
        return translate("Fairing", "Curvature differs by {0}").format(found)
    return translate("Fairing", "Curvature differs by {0}, allowed {1}").format(
        found, percent_text(report["limits"]["curvature"]))


def _explanation(side: dict, report: dict) -> list[str]:
    """Everything measured along one side, with the limits, in lines."""
    lines = [translate("Fairing", "Gap {0}, allowed {1}").format(length_text(side["gap"]["max"]),
                                                                length_text(report["limits"]["gap"]))]
    if side["has_normal"]:
        lines += [
            translate("Fairing", "Angle {0}, allowed {1}").format(angle_text(side["angle"]["max"]),
                                                                  angle_text(report["limits"]["angle"])),
            translate("Fairing", "Angle next to the corners {0}, allowed {1}").format(
                angle_text(side["corner_angle"]["max"]), angle_text(side["corner_angle_limit"])),
            _curvature_line(side, report),
        ]
    if side["backwards"]:
        lines.append(translate("Fairing", "The surface folds back at this edge."))
    return lines
