# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists that are as high as their few rows."""

from __future__ import annotations

from typing import Iterable, Optional

from PySide import QtCore, QtGui

LARGEST_HEIGHT = 4  # rows shown without scrolling
ROW_HEIGHT = 20  # pixels
FRAME = 4


def show_rows(widget, rows: Iterable[tuple[str, Optional[QtGui.QIcon]]], largest: int = LARGEST_HEIGHT) -> None:
    """Other rows, each a text and an icon or None; without any the list hides."""
    widget.clear()
    for text, icon in rows:
        item = QtGui.QListWidgetItem(text)
        item.setSizeHint(QtCore.QSize(0, ROW_HEIGHT))
        if icon:
            item.setIcon(icon)
        widget.addItem(item)
    widget.setVisible(widget.count() > 0)
    widget.setFixedHeight(FRAME + ROW_HEIGHT * min(widget.count(), largest))


def without_chosen(widget, rows) -> list:
    """What is left of the rows when the selected ones are taken away, or all where none is selected."""
    chosen = {index.row() for index in widget.selectedIndexes()}
    return [row for number, row in enumerate(rows) if chosen and number not in chosen]
