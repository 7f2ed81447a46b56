# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well an edge is met, as a sign: green tick, amber or red exclamation mark, grey dash."""

from __future__ import annotations

import enum
from typing import Optional

from PySide import QtCore, QtGui

NEARLY = 5.0  # times the limit: up to there amber, beyond red


class Status(enum.Enum):
    """Colour on light and dark backgrounds alike, and the sign within the dot."""

    GOOD = ("#2e9e44", "\u2713")
    NEARLY = ("#d98e04", "!")
    BAD = ("#d92d20", "!")
    UNKNOWN = ("#8a8f98", "\u2013")

    @property
    def rgb(self) -> tuple[float, float, float]:
        color = QtGui.QColor(self.value[0])
        return color.redF(), color.greenF(), color.blueF()

    def text_color(self, palette: QtGui.QPalette) -> str:
        """The same for text, legible on the palette's background."""
        color = QtGui.QColor(self.value[0])
        is_dark = palette.color(QtGui.QPalette.Window).lightness() < 128
        return (color.lighter(140) if is_dark else color.darker(110)).name()

    def pixmap(self, size: int = 16) -> QtGui.QPixmap:
        """A dot with its sign, drawn at twice the size for sharp screens."""
        pixmap = QtGui.QPixmap(2 * size, 2 * size)
        pixmap.fill(QtCore.Qt.transparent)
        painter = QtGui.QPainter(pixmap)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(QtGui.QColor(self.value[0]))
        painter.drawEllipse(QtCore.QRectF(1, 1, 2 * size - 2, 2 * size - 2))
        font = painter.font()
        font.setBold(True)
        font.setPixelSize(int(1.4 * size))
        painter.setFont(font)
        painter.setPen(QtGui.QColor("white"))
        painter.drawText(pixmap.rect(), QtCore.Qt.AlignCenter, self.value[1])
        painter.end()
        pixmap.setDevicePixelRatio(2)
        return pixmap


def of_side(side: Optional[dict], report: Optional[dict]) -> Status:
    """Of one side of a report; unknown without one."""
    if side is None:
        return Status.UNKNOWN
    if side["within_tolerance"]:
        return Status.GOOD
    limits = report["limits"]
    excess = [side["gap"]["max"] / limits["gap"]]
    if side["asked"] != "G0":
        excess += [side[what]["max"] / limits[what] for what in ("angle", "corner_angle")]
    if side["asked"] == "G2":
        excess.append(side["curvature"]["max"] / limits["curvature"])
    return Status.NEARLY if max(excess) <= NEARLY and not side["backwards"] else Status.BAD


def of_fill(fill) -> Status:
    if fill.within_tolerance:
        return Status.GOOD
    signs = [of_side(side, fill.report) for side in fill.report["sides"]]
    return Status.BAD if Status.BAD in signs else Status.NEARLY


def of_hole(hole) -> Status:
    """Of one of several holes; None: it is not filled yet."""
    if hole is None:
        return Status.UNKNOWN
    return of_fill(hole.fill) if hole.fill else Status.BAD
