# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels that show a surface while it is being chosen have in common: solving, the verdict, OK, closing."""

from __future__ import annotations

import contextlib
import time
from typing import Callable, Optional

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import native, paths, settings
from ..choices import LONG_ENERGIES, SOLVED
from ..selection import Wanted
from ..translation import translate
from . import opening, task_boxes
from .background import BackgroundSolver
from .fill_choices import FillChoices
from .message import show_problem
from .pause import pause
from .picking import ClosingDocument, EscapeKey, Picking
from .status import Status

SHOWS_PROGRESS_AFTER = 0.15  # s: a bar that only flashes up is noise
PAUSE = 250  # ms something dragged stays before what OK takes is solved
MARGINS = 60  # pixels left and right of the table, a scroll bar included


class SolvingPanel:
    """A session (what is chosen), its form, the background solver and a picture in the 3D view.

    Subclasses name their FORM, BOX and ICON, make what is their own in _set_up(), and say in _refresh() what to solve,
    in _show_result() and _show_nothing() what to draw.
    """

    FORM = BOX = ICON = ""
    MAKE_CHOICES = FillChoices  # which of the choices below it are offered

    @classmethod
    def launch(cls, make_session: Callable[[], object]) -> bool:
        """False, with a message, where the panel cannot be."""
        problem = opening.obstacle()
        try:
            session = None if problem else make_session()
        except ValueError as error:  # a property holds what cannot be shown
            problem = str(error)
        if problem:
            show_problem(problem)
            return False
        opening.put_up(cls(session))
        return True

    def __init__(self, session):
        self._session = session
        self._result = None  # what the native module made of the session's request, once it is there
        self._then: Optional[Callable[[], object]] = None  # what waits for it: OK or Apply
        self._started = 0.0
        self._is_closed = False
        self._ui = Gui.PySideUic.loadUi(paths.form(self.FORM))
        self.form = [getattr(self._ui, self.BOX), *self._make_boxes()]
        for box in self.form:
            box.setWindowIcon(QtGui.QIcon(paths.icon(self.ICON)))
        self._view = Gui.getDocument(session.document.Name).ActiveView
        self._solver = BackgroundSolver(native.module().Progress, self._solved, self._progressed, self._ui)
        self._settled = pause(self._ui, PAUSE, self._solve_settled)
        self._set_up()
        self._connect_show()
        self._hide_object()
        self._picking = Picking(session.document, self._picked, session.obj, lambda: self._wanted)
        self._escape = EscapeKey(self._view, self._escaped)
        self._closing = ClosingDocument(session.document, self._document_closed)
        self._refresh()

    # --- subclasses ---

    _wanted = Wanted.EDGES  # what may be picked now

    def _make_boxes(self) -> list:
        """The task boxes below its own."""
        self._choices_ui = Gui.PySideUic.loadUi(paths.form("choices.ui"))
        self._choices = self.MAKE_CHOICES(self._choices_ui, self._session)
        self._choices.changed.connect(self._refresh)
        return [self._choices_ui.shapeBox, self._choices_ui.resultBox]

    def _set_up(self) -> None:
        """Makes the widgets and the picture of its own."""
        raise NotImplementedError

    def _refresh(self, *_) -> None:
        """Something changed: show what is asked, and have it solved."""
        raise NotImplementedError

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        raise NotImplementedError

    def _show_result(self, value) -> tuple[Status, str]:
        """Draws what the session's job returned, sets _result, and says how good it is."""
        raise NotImplementedError

    def _show_nothing(self) -> None:
        """Draws the edges alone."""
        raise NotImplementedError

    # --- called by FreeCAD ---

    def getStandardButtons(self):
        buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Apply | QtGui.QDialogButtonBox.Cancel
        try:
            return int(buttons)  # PySide2; FreeCAD 0.20 insists on it
        except TypeError:
            return buttons  # PySide6

    def clicked(self, button) -> None:
        if int(getattr(button, "value", button)) == int(getattr(QtGui.QDialogButtonBox.Apply, "value",
                                                                QtGui.QDialogButtonBox.Apply)):
            self._apply()

    def accept(self) -> bool:
        """OK: at once when the surface is there, else as soon as it is."""
        if not self._is_ready(self.accept) or not self._commit():
            return False
        self._close()
        return True

    def reject(self) -> bool:
        self._close()
        return True

    # --- computing ---

    def _stop(self) -> None:
        """The first time the best so far is taken, where steps to a minimum lead to one; else nothing is."""
        if self._session.request.energy in LONG_ENERGIES and self._solver.take_best():
            self._say(Status.UNKNOWN, translate("Fairing", "Taking the best so far ..."))
            return
        self._idle()
        self._show_unsolved(translate("Fairing", "Stopped. Change something, or press OK, to compute again."))

    def _escaped(self) -> None:
        if not self._is_closed:
            self.reject()

    def _apply(self) -> None:
        if self._is_ready(self._apply) and self._commit():
            self._hide_object()

    def _start_anew(self) -> None:
        """What was solved is of another request."""
        self._result = None
        self._settled.stop()

    def _solve_settled(self) -> None:
        """What was dragged stays: what OK takes is solved."""
        if not self._is_closed and self._result is None:
            self._solve_or_wait(self._session.problem, True)

    def _solve_or_wait(self, problem: str, is_asked: bool) -> None:
        """Solves what is asked now, unless there is a problem or nobody wants to see it yet."""
        if problem:
            self._idle()
            self._show_unsolved(problem if is_asked else "", Status.BAD)
        elif self._ui.previewCheck.isChecked() or self._then:
            self._solve()
        else:
            self._idle()
            self._show_unsolved(translate("Fairing", "The preview is off."))

    def _solve(self) -> None:
        self._started = time.monotonic()
        self._solver.request(self._session.job())

    def _progressed(self, fraction: float) -> None:
        if time.monotonic() - self._started > SHOWS_PROGRESS_AFTER:
            if not self._ui.stopButton.isVisible():
                self._say(Status.UNKNOWN, translate("Fairing", "Computing ..."))
            self._show_busy(True)
            self._ui.progressBar.setValue(round(fraction * self._ui.progressBar.maximum()))

    def _solved(self, value, error) -> None:
        self._show_busy(False)
        then, self._then = self._then, None
        if error is not None:
            self._show_unsolved(str(error), Status.BAD)
            return
        self._say(*self._show_result(value))
        if then:
            then()

    def _idle(self) -> None:
        self._solver.cancel()
        self._then = None
        self._show_busy(False)

    def _is_ready(self, then: Callable[[], object]) -> bool:
        """Whether the surface is there; if not, `then` is called when it is."""
        if self._result is None and not self._session.problem:
            self._then = then
            if not self._solver.is_busy:
                self._solve()
        return self._result is not None

    def _commit(self) -> bool:
        try:
            with SOLVED.taking(*self._session.asked(), self._result):
                self._session.commit()
        except Exception as error:  # whatever it was: the document is as before, and the panel says why
            self._show_unsolved(str(error), Status.BAD)
            return False
        return True

    # --- showing ---

    def _connect_show(self) -> None:
        ui = self._ui
        ui.stopButton.clicked.connect(self._stop)
        ui.previewCheck.setChecked(settings.shows_preview())
        ui.previewCheck.toggled.connect(self._refresh)
        self._connect_labels()
        for widget in (ui.progressBar, ui.stopButton):
            keep = widget.sizePolicy()
            keep.setRetainSizeWhenHidden(True)  # nothing jumps while computing
            widget.setSizePolicy(keep)

    def _connect_labels(self) -> None:
        check = self._ui.labelsCheck
        check.setChecked(settings.shows_labels())
        check.toggled.connect(self._display.show_labels)
        self._display.show_labels(check.isChecked())

    def _say(self, sign: Status, text: str) -> None:
        self._ui.verdictIcon.setPixmap(sign.pixmap(16) if text else QtGui.QPixmap())
        label = self._ui.verdictLabel
        label.setText(text)
        label.setStyleSheet(f"color: {sign.text_color(label.palette())}" if sign is Status.BAD else "")

    def _show_unsolved(self, text: str, sign: Status = Status.UNKNOWN) -> None:
        self._result = None
        self._show_nothing()
        self._say(sign, text)

    def _show_busy(self, busy: bool) -> None:
        label = self._ui.verdictLabel
        label.setMinimumHeight(label.height() if busy else 0)  # what is below stays under the mouse
        self._ui.progressBar.setVisible(busy)
        self._ui.stopButton.setVisible(busy)

    def _hide_object(self) -> None:
        """The preview stands for the object while the panel is open."""
        self._show_object(False)

    def _show_object(self, shown: bool) -> None:
        if self._session.obj:
            self._session.obj.ViewObject.Visibility = shown

    def make_room(self) -> None:
        """A dock too narrow for the buttons is widened: nothing of the panel is cut off."""
        if not self._is_closed:
            task_boxes.make_room(self.form[0], max(task_boxes.NARROWEST, self._needed_width() + MARGINS))

    def _needed_width(self) -> int:
        """Pixels for its table to show in full."""
        self._table.fit_height()
        return self._table.needed_width()

    # --- closing ---

    def gone(self) -> None:
        """Takes away everything the panel has put up beside itself."""
        if self._is_closed:
            return
        self._detach()
        self._display.remove()
        self._show_object(True)

    def _close(self) -> None:
        document = self._session.document
        self.gone()
        Gui.Control.closeDialog()
        with contextlib.suppress(NameError):  # FreeCAD's word for a document without a window
            Gui.getDocument(document.Name).resetEdit()

    def _document_closed(self) -> None:
        self._detach()
        QtCore.QTimer.singleShot(0, Gui.Control.closeDialog)

    def _detach(self) -> None:
        if self._is_closed:
            return
        self._is_closed = True
        self._solver.finish()
        self._picking.stop()
        self._closing.stop()
        self._escape.stop()
