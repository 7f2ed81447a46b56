# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Fill Hole: pick, look at the surface and its numbers, press OK."""

from __future__ import annotations

import contextlib
import time
from typing import Callable, Optional

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import native, paths, selection, settings
from ..fill_request import CONTINUITIES
from ..translation import translate
from . import status
from .background import BackgroundSolver
from .boundary_table import BoundaryTable
from .fill_choices import FillChoices
from .fill_display import FillDisplay
from .fill_session import FillSession
from .message import show_problem
from .picking import ClosingDocument, EscapeKey, Picking
from .status import Status

LONGEST_STOP = 0.1  # s closing waits for a solve that was told to stop; then it ends by itself, unheard
SHOWS_PROGRESS_AFTER = 0.15  # s: a bar that only flashes up is noise
NARROWEST = 320  # pixels of a dock that FreeCAD's three buttons fit into
MARGINS = 60  # pixels left and right of the table, a scroll bar included


class FillPanel:
    """Connects a FillSession with the form, the background solver and the 3D view."""

    @classmethod
    def show(cls, picks: Optional[selection.Picks] = None, obj: Optional[App.DocumentObject] = None) -> bool:
        """Opens the panel for a new fill, or to edit one. False, with a message, where that cannot be."""
        problem = native.problem()
        if problem:
            show_problem(problem)
            return False
        try:
            session = FillSession.of_object(obj) if obj else FillSession(App.ActiveDocument, settings.new_request())
        except ValueError as error:  # a property holds what cannot be shown
            show_problem(str(error))
            return False
        if picks:
            session.pick(picks.base, picks.names)
        panel = cls(session)
        Gui.Control.showDialog(panel)
        QtCore.QTimer.singleShot(0, panel._make_room)
        return True

    def __init__(self, session: FillSession):
        self._session = session
        self._fill = None  # the native result of the session's request, once it is there
        self._then: Optional[Callable[[], object]] = None  # what waits for it: OK or Apply
        self._shown_loop: Optional[list[int]] = None
        self._started = 0.0
        self._is_closed = False
        self._ui = Gui.PySideUic.loadUi(paths.form("fill_hole.ui"))
        self.form = [self._ui.boundaryBox, self._ui.shapeBox, self._ui.resultBox]  # a task box each
        for box in self.form:
            box.setWindowIcon(QtGui.QIcon(paths.icon("Fairing_FillHole.svg")))
        view = Gui.getDocument(session.document.Name).ActiveView
        self._solver = BackgroundSolver(native.module().Progress, self._solved, self._progressed, self._ui)
        self._table = BoundaryTable(self._ui.boundaryTable)
        self._choices = FillChoices(self._ui, session)
        self._display = FillDisplay(view, session, self._label_clicked, self._table.select)
        self._connect()
        self._hide_object()
        self._picking = Picking(session.document, self._picked, session.obj)
        self._escape = EscapeKey(view, self._escaped)
        self._closing = ClosingDocument(session.document, self._document_closed)
        self._refresh()

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

    # --- the user does something ---

    def _connect(self) -> None:
        ui = self._ui
        self._table.chosen.connect(lambda edge, word: self._set_continuity(word, edge))
        self._table.pointed.connect(self._display.point_at)
        ui.allG1Button.clicked.connect(lambda: self._set_continuity("G1"))
        ui.allG0Button.clicked.connect(lambda: self._set_continuity("G0"))
        ui.clearButton.clicked.connect(self._clear)
        ui.stopButton.clicked.connect(self._stop)
        ui.previewCheck.setChecked(settings.shows_preview())
        ui.previewCheck.toggled.connect(self._refresh)
        ui.labelsCheck.setChecked(settings.shows_labels())
        ui.labelsCheck.toggled.connect(self._display.show_labels)
        self._display.show_labels(ui.labelsCheck.isChecked())
        for widget in (ui.progressBar, ui.stopButton):
            keep = widget.sizePolicy()
            keep.setRetainSizeWhenHidden(True)  # nothing jumps while computing
            widget.setSizePolicy(keep)
        self._choices.changed.connect(self._refresh)

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if self._choices.is_picking_guide:
            self._choices.guide_picked(obj, name)
            return
        edge = self._session.edge_in_loop(name) if obj is self._session.base else 0
        if edge:
            self._table.select(edge)
        elif selection.has_shape(obj):
            self._session.pick(obj, [name])
            self._refresh()

    def _label_clicked(self, edge: int, with_shift: bool) -> None:
        """The next continuity, for all edges with shift. Later, since the label under the mouse is made anew."""
        current = self._session.request.continuity_of(edge)
        word = CONTINUITIES[(CONTINUITIES.index(current) + 1) % len(CONTINUITIES)]
        QtCore.QTimer.singleShot(0, lambda: self._set_continuity(word, None if with_shift else edge))

    def _set_continuity(self, word: str, edge: Optional[int] = None) -> None:
        self._session.set_continuity(word, edge)
        self._refresh()

    def _clear(self) -> None:
        self._session.clear()
        self._refresh()

    def _stop(self) -> None:
        self._idle()
        self._show_unsolved(translate("Fairing", "Stopped. Change something, or press OK, to compute again."))

    def _escaped(self) -> None:
        if not self._is_closed:
            self.reject()

    def _apply(self) -> None:
        if self._is_ready(self._apply) and self._commit():
            self._hide_object()

    # --- computing ---

    def _refresh(self, *_) -> None:
        """Something changed: find the hole, show it, and have its surface computed."""
        session, ui = self._session, self._ui
        self._fill = None
        session.find_loop()
        self._table.show_loop(session.loop, session.request)
        has_picks = bool(session.request.edges or session.request.faces)
        ui.promptLabel.setVisible(not has_picks)
        for widget in (ui.allG1Button, ui.allG0Button, ui.clearButton):
            widget.setEnabled(has_picks)
        edges = [side["edge"] for side in session.loop]
        if edges != self._shown_loop:
            self._shown_loop = edges
            self._show_unsolved("")
        if session.problem:
            self._idle()
            self._show_unsolved(session.problem if has_picks else "", Status.BAD)
        elif ui.previewCheck.isChecked() or self._then:
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
        self._fill, mesh = value
        report = self._fill.report
        self._display.show_fill(report, mesh)
        self._table.show_report(report)
        self._choices.show_limits(report["limits"])
        self._say(status.of_fill(self._fill), self._fill.verdict)
        if then:
            then()

    def _idle(self) -> None:
        self._solver.cancel()
        self._then = None
        self._show_busy(False)

    def _is_ready(self, then: Callable[[], object]) -> bool:
        """Whether the surface is there; if not, `then` is called when it is."""
        if self._fill is None and not self._session.problem:
            self._then = then
            if not self._solver.is_busy:
                self._solve()
        return self._fill is not None

    def _commit(self) -> bool:
        try:
            self._session.commit()
        except Exception as error:  # whatever it was: the document is as before, and the panel says why
            self._show_unsolved(str(error), Status.BAD)
            return False
        return True

    # --- showing ---

    def _say(self, sign: Status, text: str) -> None:
        self._ui.verdictIcon.setPixmap(sign.pixmap(16) if text else QtGui.QPixmap())
        label = self._ui.verdictLabel
        label.setText(text)
        label.setStyleSheet(f"color: {sign.text_color(label.palette())}" if sign is Status.BAD else "")

    def _show_unsolved(self, text: str, sign: Status = Status.UNKNOWN) -> None:
        self._fill = None
        self._display.show_unsolved()
        self._table.show_report(None)
        self._say(sign, text)

    def _show_busy(self, busy: bool) -> None:
        self._ui.progressBar.setVisible(busy)
        self._ui.stopButton.setVisible(busy)

    def _hide_object(self) -> None:
        """The preview stands for the object while the panel is open."""
        if self._session.obj:
            self._session.obj.ViewObject.Visibility = False

    def _make_room(self) -> None:
        """A dock too narrow for the buttons is widened: nothing of the panel is cut off."""
        if self._is_closed:
            return
        self._table.fit_height()
        window, needed = Gui.getMainWindow(), max(NARROWEST, self._table.needed_width() + MARGINS)
        for dock in window.findChildren(QtGui.QDockWidget):
            if dock.isAncestorOf(self._ui.boundaryTable) and dock.width() < needed:
                window.resizeDocks([dock], [needed], QtCore.Qt.Horizontal)

    # --- closing ---

    def _close(self) -> None:
        """Takes away everything the panel has put up."""
        document = self._session.document
        self._detach()
        self._display.remove()
        if self._session.obj:
            self._session.obj.ViewObject.Visibility = True
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
        self._solver.finish(LONGEST_STOP)
        self._picking.stop()
        self._closing.stop()
        self._escape.stop()
