# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's hands and eyes for the tests in FreeCAD's window: mouse, keys, buttons, patience, pictures."""

import os
import subprocess
import threading
import time

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

PATIENCE = 20.0  # s, before a wait fails
OUTPUT = os.environ["FAIRING_OUTPUT"]


def pump(seconds=0.1):
    """Lets FreeCAD's event loop run."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        time.sleep(0.005)


def wait_for(condition, what):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, f"waited {PATIENCE} s for {what}"
        pump(0.02)


def start():
    """The window as a user has it: tree and tasks shown, Fairing chosen."""
    window = Gui.getMainWindow()
    window.resize(1280, 900)
    window.move(0, 0)
    for dock in window.findChildren(QtGui.QDockWidget):
        dock.setVisible(dock.objectName() in ("Combo View", "Model", "Tasks"))
    Gui.activateWorkbench("FairingWorkbench")
    pump(0.3)


def look_at_all():
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    pump(0.5)
    return view


def part(document, name, shape):
    """An object that has a shape."""
    obj = document.addObject("Part::Feature", name)
    obj.Shape = shape
    return obj


def edge_at(shape, middle):
    """The name of the edge with its centre of mass at a place."""
    return next(f"Edge{number}" for number, edge in enumerate(shape.Edges, 1)
                if edge.CenterOfMass.distanceToPoint(App.Vector(*middle)) < 1e-6)


def select(document, *picks):
    """Edges as a user selects them: pairs of an object, or its name, and an edge's name."""
    Gui.Selection.clearSelection()
    for obj, edge in picks:
        Gui.Selection.addSelection(document.Name, obj if isinstance(obj, str) else obj.Name, edge)


def keep_panels():
    """A list that every panel opened from now on joins: tests look at what it draws."""
    from fairing.panels.solving_panel import SolvingPanel

    panels, launched = [], SolvingPanel.__init__

    def keep(panel, session):
        launched(panel, session)
        panels.append(panel)

    SolvingPanel.__init__ = keep
    return panels


def widget(name):
    """A widget of the panel by its name in the form."""
    found = [child for child in Gui.getMainWindow().findChildren(QtGui.QWidget, name)]
    assert found, f"there is no {name}"
    return found[-1]


def scroll_to(name):
    """Brings a widget of the panel into sight, with the mouse wheel as it were."""
    found = widget(name)
    next(area for area in Gui.getMainWindow().findChildren(QtGui.QScrollArea)
         if area.isAncestorOf(found)).ensureWidgetVisible(found)
    pump(0.1)


def type_into(name, text):
    """A number with its unit into one of FreeCAD's quantity fields."""
    widget(name).findChild(QtGui.QLineEdit).setText(text)
    pump(0.05)


def press(kind):
    """OK, Cancel or Apply of the open panel."""
    for box in Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        button = box.button(getattr(QtGui.QDialogButtonBox, kind))
        if button is not None and button.isVisible():
            button.click()
            pump(0.1)
            return
    raise AssertionError(f"no button {kind} to press")


def answer_message(action):
    """What an action returns that shows a message, and the message, closed as soon as it is there."""
    texts = []

    def close():
        box = QtGui.QApplication.activeModalWidget()
        if box is None:
            QtCore.QTimer.singleShot(100, close)
        else:
            texts.append(box.text())
            box.accept()

    QtCore.QTimer.singleShot(100, close)
    value = action()
    return value, texts[0] if texts else ""


def ok():
    """OK, and the panel has closed."""
    press("Ok")
    wait_for(lambda: not panel_is_open(), "OK")


def action_is_enabled(name):
    pump(0.5)  # FreeCAD looks at its commands every 300 ms
    actions = [action for action in Gui.getMainWindow().findChildren(QtGui.QAction) if action.objectName() == name]
    assert actions, f"no action {name}"
    return actions[0].isEnabled()


def panel_is_open():
    return bool(Gui.Control.activeDialog())


def verdict():
    return widget("verdictLabel").text()


def settle():
    """Waits until what was typed has been taken and nothing is being computed."""
    pump(0.4)
    wait_for(lambda: not any(thread.name == "fairing" for thread in threading.enumerate()), "the solver to end")
    pump(0.1)


def wait_for_verdict(start="Meets"):
    settle()
    wait_for(lambda: verdict().startswith(start), f"a verdict '{start}...', there is '{verdict()}'")


def key(name):
    subprocess.check_call(["xdotool", "key", name])
    pump(0.2)


def hover(view, point):
    """The real mouse comes to rest on a point of the model."""
    x, y = _window_position(view, point)
    window = str(int(Gui.getMainWindow().winId()))
    subprocess.check_call(["xdotool", "mousemove", "--window", window, str(x - 3), str(y - 3)])
    pump(0.2)
    subprocess.check_call(["xdotool", "mousemove", "--window", window, str(x), str(y)])
    pump(0.3)


def color_at(view, point):
    """Red, green and blue of the window, 0 to 255, where a point of the model is drawn."""
    return _screen().toImage().pixelColor(*_window_position(view, point)).getRgb()[:3]


def click(view, point, modifier=None):
    """A click of the real mouse onto a point of the model."""
    hover(view, point)
    hold = ["keydown", modifier] if modifier else []
    subprocess.check_call(["xdotool", *hold, "click", "1", *(["keyup", modifier] if modifier else [])])
    pump(0.4)


def drag(view, start, end, steps=12, at_half=lambda: None):
    """The real mouse presses on one point of the model and lets go on another; at_half() is called on the way."""
    _drag(_window_position(view, start), _window_position(view, end), steps, at_half)


def drag_slider(name, share, steps=12):
    """The real mouse takes a slider's handle from its middle so much of its width to the right."""
    slider = widget(name)
    middle = slider.mapTo(Gui.getMainWindow(), QtCore.QPoint(slider.width() // 2, slider.height() // 2 - 4))
    start = middle.x(), middle.y()
    _drag(start, (start[0] + round(share * slider.width()), start[1]), steps, lambda: None)


def _drag(start, end, steps, at_half):
    window = str(int(Gui.getMainWindow().winId()))

    def move(share):
        place = [str(round(a + share * (b - a))) for a, b in zip(start, end)]
        subprocess.check_call(["xdotool", "mousemove", "--window", window, *place])
        pump(0.05)

    for share in (-0.01, 0.0):
        move(share)
    pump(0.2)
    subprocess.check_call(["xdotool", "mousedown", "1"])
    pump(0.1)
    for step in range(steps):
        move((step + 1) / steps)
        if step == steps // 2:
            at_half()
    subprocess.check_call(["xdotool", "mouseup", "1"])
    pump(0.2)


def picture(name):
    """The window, left among the pictures of the build for people to look at."""
    Gui.updateGui()
    pump(0.2)
    assert _screen().save(os.path.join(OUTPUT, name + ".png"))


def _screen():
    window = Gui.getMainWindow()
    return QtGui.QApplication.primaryScreen().grabWindow(0, window.x(), window.y(), window.width(), window.height())


def _window_position(view, point):
    on_view = getattr(view, "getPointOnViewport", view.getPointOnScreen)  # renamed after 0.20
    x, y = on_view(point)
    drawn = [child for child in Gui.getMainWindow().findChildren(QtGui.QWidget)
             if child.metaObject().className() in ("SIM::Coin3D::Quarter::QuarterWidget", "QOpenGLWidget",
                                                   "CustomGLWidget") and child.isVisible()][-1]
    place = drawn.mapTo(Gui.getMainWindow(), QtCore.QPoint(int(x), int(drawn.height() - y)))
    return place.x(), place.y()
