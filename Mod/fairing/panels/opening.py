# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels put up and gone, whichever way."""

from __future__ import annotations

import FreeCADGui as Gui
from PySide import QtCore

from .. import native
from ..translation import translate


def obstacle() -> str:
    """Why there can be no task panel now, empty where there can."""
    if Gui.Control.activeDialog():
        return translate("Fairing", "Another task panel is open: close it first.")
    return native.problem()


def put_up(panel) -> None:
    """Shows a panel; its gone() is called when it is no longer there, also where it was not closed by its buttons, and
    make_room() once it has its size."""
    Gui.Control.showDialog(panel)
    panel.form[0].destroyed.connect(lambda *_: panel.gone())
    QtCore.QTimer.singleShot(0, panel.make_room)
