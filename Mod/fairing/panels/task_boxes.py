# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boxes that FreeCAD puts around the parts of a task panel."""

from __future__ import annotations

import FreeCADGui as Gui
from PySide import QtCore, QtGui

TASK_BOX = "Gui::TaskView::TaskBox"
NARROWEST = 320  # pixels of a dock that FreeCAD's three buttons fit into


def make_room(part: QtGui.QWidget, needed: int = NARROWEST) -> None:
    """Widens the dock that a part of a panel is in to so many pixels, where it is narrower: nothing is cut off."""
    window = Gui.getMainWindow()
    for dock in window.findChildren(QtGui.QDockWidget):
        if dock.isAncestorOf(part) and dock.width() < needed:
            window.resizeDocks([dock], [needed], QtCore.Qt.Horizontal)


def fold(part: QtGui.QWidget) -> None:
    """Folds the box round a part of a panel, as a click on its title does; one that is folded stays so."""
    box = part.parentWidget()
    while box is not None and box.metaObject().className() != TASK_BOX:
        box = box.parentWidget()
    if box is not None and part.isVisible():
        QtCore.QMetaObject.invokeMethod(box, "showHide")
