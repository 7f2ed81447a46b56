# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boxes that FreeCAD puts around the parts of a task panel."""

from __future__ import annotations

from PySide import QtCore, QtGui

TASK_BOX = "Gui::TaskView::TaskBox"


def fold(part: QtGui.QWidget) -> None:
    """Folds the box round a part of a panel, as a click on its title does; one that is folded stays so."""
    box = part.parentWidget()
    while box is not None and box.metaObject().className() != TASK_BOX:
        box = box.parentWidget()
    if box is not None and part.isVisible():
        QtCore.QMetaObject.invokeMethod(box, "showHide")
