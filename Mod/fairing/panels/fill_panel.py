# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Fill Hole: pick, look at the surface and its numbers, press OK."""

from __future__ import annotations

import contextlib
from typing import Optional

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import native, paths, selection, settings, subelements
from ..translation import translate
from . import status
from .background import BackgroundSolver
from .boundary_table import BoundaryTable
from .fill_choices import FillChoices
from .fill_session import FillSession
from .picking import ClosingDocument, EscapeKey, Picking
from .preview import Preview
from .status import Status

LONGEST_STOP = 2.0  # s, what closing waits for a solve that was told to stop


class FillPanel:
    """Connects a FillSession with the form, the background solver and the 3D view."""

    @classmethod
    def show(cls, picks: Optional[selection.Picks] = None, obj: Optional[App.DocumentObject] = None) -> bool:
        """Shows the panel for a new fill, or to edit one. False, with a message, where that cannot be."""
        problem = native.problem()
        if problem:
            from ..commands.fill_hole import show_problem

            show_problem(problem)
            return False
        session = FillSession.of_object(obj) if obj else FillSession(App.ActiveDocument, settings.new_request())
        Gui.Control.showDialog(cls(session, picks))
        return True

    def __init__(self, session: FillSession, picks: Optional[selection.Picks] = None):
        self._session = session
        self._fill = None  # the native result of the session's request, once it is there
        self._accept_when_done = False
        self._is_closed = False
        self._ui = Gui.PySideUic.loadUi(paths.form("fill_hole.ui"))
        self.form = [self._ui.boundaryBox, self._ui.shapeBox, self._ui.resultBox]  # a task box each
        for box in self.form:
            box.setWindowIcon(QtGui.QIcon(paths.icon("Fairing_FillHole.svg")))
        self._view = Gui.getDocument(session.document.Name).ActiveView
        self._preview = Preview(self._view, settings.patch_color())
        self._solver = BackgroundSolver(native.module().Progress, self._solved, self._progressed, self._ui)
        self._table = BoundaryTable(self._ui.boundaryTable)
        self._choices = FillChoices(self._ui, session)
        self._connect()
        self._hide_object()
        self._picking = Picking(session.document, self._picked, session.obj)
        self._escape = EscapeKey(self._view, self._cancel)
        self._closing = ClosingDocument(session.document, self._document_closed)
        if picks:
            session.pick(picks.base, picks.names)
        self._refresh()

    # --- called by FreeCAD ---

    def getStandardButtons(self):
        buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Apply | QtGui.QDialogButtonBox.Cancel
        try:
            return int(buttons)  # PySide2; FreeCAD 0.20 insists on it
        except TypeError:
            return buttons  # PySide6

    def clicked(self, button) -> None:
        if button == QtGui.QDialogButtonBox.Apply or getattr(button, "value", button) == 0x02000000:
            self._apply()

    def accept(self) -> bool:
        """OK: at once when the preview is there, else as soon as it is."""
        if not self._is_ready():
            return False
        if not self._commit():
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
        ui.allG1Button.clicked.connect(lambda: self._set_continuity("G1"))
        ui.allG0Button.clicked.connect(lambda: self._set_continuity("G0"))
        ui.clearButton.clicked.connect(self._clear)
        ui.stopButton.clicked.connect(self._stop)
        ui.previewCheck.setChecked(settings.shows_preview())
        ui.previewCheck.toggled.connect(self._refresh)
        ui.labelsCheck.setChecked(settings.shows_labels())
        for widget in (ui.progressBar, ui.stopButton):
            keep = widget.sizePolicy()
            keep.setRetainSizeWhenHidden(True)  # nothing jumps while computing
            widget.setSizePolicy(keep)
        self._choices.changed.connect(self._refresh)

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if self._choices.is_picking_guide:
            self._choices.guide_picked(obj, name)
            return
        if not selection.has_shape(obj):
            return
        edge = self._session.edge_in_loop(name) if obj is self._session.base else 0
        if edge:
            self._table.select(edge)
            return
        self._session.pick(obj, [name])
        self._refresh()

    def _set_continuity(self, word: str, edge: Optional[int] = None) -> None:
        self._session.set_continuity(word, edge)
        self._refresh()

    def _clear(self) -> None:
        self._session.clear()
        self._refresh()

    def _stop(self) -> None:
        self._solver.cancel()
        self._accept_when_done = False
        self._set_busy(False)
        self._say(Status.UNKNOWN, translate("Fairing", "Stopped. Change something to compute again."))

    def _cancel(self) -> None:
        if not self._is_closed:
            self.reject()

    def _apply(self) -> None:
        if self._is_ready() and self._commit():
            self._hide_object()

    # --- computing ---

    def _refresh(self, *_) -> None:
        """Something changed: find the hole, show it, and have its surface computed."""
        self._fill = None
        self._session.find_loop()
        self._preview.place(self._session.placement)
        self._table.show_loop(self._session.loop, self._session.request)
        has_picks = bool(self._session.request.edges or self._session.request.faces)
        self._ui.promptLabel.setVisible(not has_picks)
        for widget in (self._ui.allG1Button, self._ui.allG0Button, self._ui.clearButton):
            widget.setEnabled(has_picks)
        if self._session.problem:
            self._solver.cancel()
            self._set_busy(False)
            self._fail(self._session.problem if has_picks else "")
        elif self._ui.previewCheck.isChecked() or self._accept_when_done:
            self._solve()
        else:
            self._solver.cancel()
            self._set_busy(False)
            self._show_unsolved(translate("Fairing", "The preview is off."))

    def _solve(self) -> None:
        self._set_busy(True)
        self._draw_edges(None)
        self._solver.request(self._session.job())

    def _solved(self, value, error) -> None:
        self._set_busy(False)
        if error is not None:
            self._accept_when_done = False
            self._fail(str(error))
            return
        self._fill, mesh = value
        self._preview.show_surface(mesh)
        self._table.show_report(self._fill.report)
        self._draw_edges(self._fill.report)
        self._say(status.of_fill(self._fill), self._fill.verdict)
        if self._accept_when_done:
            self._accept_when_done = False
            self.accept()

    def _progressed(self, fraction: float) -> None:
        self._ui.progressBar.setValue(round(fraction * self._ui.progressBar.maximum()))

    def _is_ready(self) -> bool:
        """Whether the result is there; asks for it otherwise, and for OK to be pressed then."""
        if self._fill is not None:
            return True
        if not self._session.problem:
            self._accept_when_done = True
            self._solve()
        return False

    def _commit(self) -> bool:
        try:
            self._session.commit()
        except Exception as error:  # shown in the panel: whatever it was, the document is unchanged
            self._fail(str(error))
            return False
        return True

    # --- showing ---

    def _say(self, sign: Status, text: str) -> None:
        self._ui.verdictIcon.setPixmap(sign.pixmap(16) if text else QtGui.QPixmap())
        self._ui.verdictLabel.setText(text)
        label = self._ui.verdictLabel
        label.setStyleSheet(f"color: {sign.text_color(label.palette())}" if sign is Status.BAD else "")

    def _fail(self, sentence: str) -> None:
        self._fill = None
        self._show_unsolved(sentence, Status.BAD)

    def _show_unsolved(self, text: str, sign: Status = Status.UNKNOWN) -> None:
        self._preview.hide_surface()
        self._table.show_report(None)
        self._draw_edges(None)
        self._say(sign, text)

    def _draw_edges(self, report) -> None:
        measured = {side["edge"]: side for side in report["sides"]} if report else {}
        signs = [status.of_side(measured.get(side["edge"]), report) for side in self._session.loop]
        self._preview.show_edges([side["points"] for side in self._session.loop], [sign.rgb for sign in signs])

    def _set_busy(self, busy: bool) -> None:
        self._ui.progressBar.setValue(0)
        self._ui.progressBar.setVisible(busy)
        self._ui.stopButton.setVisible(busy)

    def _hide_object(self) -> None:
        """The preview stands for the object while the panel is open."""
        if self._session.obj:
            self._session.obj.ViewObject.Visibility = False

    # --- closing ---

    def _close(self) -> None:
        """Takes away everything the panel has put up."""
        document = self._session.document
        self._detach()
        self._preview.remove()
        if self._session.obj:
            self._session.obj.ViewObject.Visibility = True
        Gui.Control.closeDialog()
        with contextlib.suppress(NameError):
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
