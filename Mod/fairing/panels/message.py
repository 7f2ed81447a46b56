# SPDX-License-Identifier: LGPL-2.1-or-later
"""Telling the user why there is no panel, or no result."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

from ..translation import translate


def show_problem(sentence: str, title: str = "") -> None:
    """The sentence in a dialog, under a title already in the user's language."""
    App.Console.PrintError(sentence + "\n")
    title = title or translate("Fairing", "Fairing cannot work")
    QtGui.QMessageBox.critical(Gui.getMainWindow(), title, sentence)
