# SPDX-License-Identifier: LGPL-2.1-or-later
"""Waiting until something rests: typing, dragging, the mouse."""

from __future__ import annotations

from typing import Callable

from PySide import QtCore


def pause(parent: QtCore.QObject, milliseconds: int, then: Callable[[], object]) -> QtCore.QTimer:
    """A timer that calls then() so long after it was started last."""
    timer = QtCore.QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(milliseconds)
    timer.timeout.connect(then)
    return timer
