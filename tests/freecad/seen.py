# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view and the panel show of a surface while it is being made."""

import re

import FreeCADGui as Gui
from PySide import QtCore, QtGui

import gui


def drawn_points(panels):
    """Of the surface of the panel opened last."""
    return panels[-1]._display._preview._surface._points.point.getValues()


def handle_arrow(panels, number=0):
    """Foot and tip of a handle's arrow."""
    display = panels[-1]._display
    arrow = display.guide_handles._arrows[number]
    return arrow.point, arrow.tip(display._mouse)


def guides():
    """The rows of what guides."""
    shown = gui.widget("guideList")
    return [shown.item(row).text() for row in range(shown.count())]


def angles_to_guide():
    """Rms and largest, as the panel tells them."""
    found = re.match(r"Follows within ([\d.]+)\S rms, ([\d.]+)\S at most", gui.widget("followLabel").text())
    assert found, gui.widget("followLabel").text()
    return float(found[1]), float(found[2])


def report(panels):
    """Of the surface of the panel opened last."""
    return panels[-1]._result.report


def largest_jump(panels):
    """Of curvature across any seam, as a share of the largest there."""
    return max(seam["jump"]["max"] for seam in report(panels)["seams"])


def lines_run(action):
    """What the macro recorder would write down while a user does something."""
    lines, do_command = [], Gui.doCommand
    Gui.doCommand = lambda line: (lines.append(line), do_command(line))
    try:
        action()
    finally:
        Gui.doCommand = do_command
    return lines


def texts():
    """What is to be read in the open panel, scrolled away or not."""
    return [_text(part) for part in _parts()]


def cut_off():
    """Texts of the open panel that have less room than they need."""
    found = [_text(part) for part in _parts() if _needed(part) > part.width()]
    for header in _panel().findChildren(QtGui.QHeaderView):
        if header.isVisible() and header.orientation() == QtCore.Qt.Horizontal:
            found += [header.model().headerData(k, QtCore.Qt.Horizontal) for k in range(header.count())
                      if not header.isSectionHidden(k) and header.sectionSize(k) < header.fontMetrics().horizontalAdvance(
                          str(header.model().headerData(k, QtCore.Qt.Horizontal)))]
    return found


def cut_off_entries(name):
    """Of a list in the open panel, those that it would not show in full."""
    combo = gui.widget(name)
    return [combo.itemText(row) for row in range(combo.count()) if _needed(combo, combo.itemText(row)) > combo.width()]


def _parts():
    kinds = QtGui.QLabel, QtGui.QAbstractButton, QtGui.QComboBox
    return [part for kind in kinds for part in _panel().findChildren(kind) if part.isVisible()]


def _text(part):
    return part.currentText() if isinstance(part, QtGui.QComboBox) else part.text()


def _panel():
    return next(part for part in Gui.getMainWindow().findChildren(QtGui.QWidget)
                if part.metaObject().className() == "Gui::TaskView::TaskView")


def _needed(part, text=None):
    """Pixels for a text in one line; for one that wraps, those of its longest word."""
    if isinstance(part, QtGui.QLabel) and part.wordWrap():
        return max((part.fontMetrics().horizontalAdvance(word) for word in part.text().split()), default=0)
    if isinstance(part, QtGui.QComboBox):  # the list is as wide as its longest entry, the box may be as its current one
        others = max(part.fontMetrics().horizontalAdvance(part.itemText(row)) for row in range(part.count()))
        return part.sizeHint().width() - others + part.fontMetrics().horizontalAdvance(text or part.currentText())
    if isinstance(part, QtGui.QPushButton):  # its style would like more round the text
        return part.fontMetrics().horizontalAdvance(part.text()) + part.iconSize().width() * (not part.icon().isNull())
    return part.minimumSizeHint().width()
