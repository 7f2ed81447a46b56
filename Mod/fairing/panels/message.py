# SPDX-License-Identifier: LGPL-2.1-or-later
"""Telling the user why a panel cannot open."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

from ..translation import translate


def show_problem(sentence: str) -> None:
    App.Console.PrintError(sentence + "\n")
    QtGui.QMessageBox.critical(Gui.getMainWindow(), translate("Fairing", "Fairing cannot work"), sentence)
