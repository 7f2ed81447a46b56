# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Edit Surface: pick a face, set normals and references, look at what follows, press OK."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App

from .. import selection, subelements
from ..choices import EDIT_ENERGIES, KEEPS, RESULTS
from ..edit_request import EditRequest
from ..translation import translate
from .edit_display import EditDisplay
from .edit_session import EditSession
from .fill_choices import TYPING_PAUSE
from .guided_panel import GuidedPanel
from .pause import pause
from .solving_panel import SolvingPanel
from .status import Status


class FacePanel(SolvingPanel):
    """Connects an EditSession with its form, apart from what guides."""

    FORM, BOX, ICON = "edit_surface.ui", "editBox", "Fairing_EditSurface.svg"

    def _make_boxes(self) -> list:
        return []

    def _set_up(self) -> None:
        ui, session = self._ui, self._session
        self._display = EditDisplay(self._view, session)
        self._pause = pause(ui, TYPING_PAUSE, self._read)
        request = session.request
        ui.keepCombo.setCurrentIndex(KEEPS.index(request.keep or KEEPS[0]))
        ui.energyCombo.setCurrentIndex(EDIT_ENERGIES.index(request.energy))
        ui.resultCombo.setCurrentIndex(RESULTS.index(request.result))
        ui.degreeSpin.setValue(request.degree or ui.degreeSpin.minimum())
        ui.spansSpin.setValue(request.spans)
        for combo in (ui.keepCombo, ui.energyCombo, ui.resultCombo):
            combo.currentIndexChanged.connect(self._read)
        for spin in (ui.degreeSpin, ui.spansSpin):
            spin.valueChanged.connect(lambda *_: self._pause.start())

    def _read(self, *_) -> None:
        """What the form shows, into the session."""
        if self._is_closed:
            return
        ui = self._ui
        degree, keep = ui.degreeSpin.value(), KEEPS[ui.keepCombo.currentIndex()]
        self._session.change(
            keep=None if keep == KEEPS[0] else keep, energy=EDIT_ENERGIES[ui.energyCombo.currentIndex()],
            result=RESULTS[ui.resultCombo.currentIndex()], spans=ui.spansSpin.value(),
            degree=0 if degree == ui.degreeSpin.minimum() else degree)
        self._refresh()

    def _refresh(self, *_) -> None:
        """Something changed: show the face, and have it shaped."""
        session, ui = self._session, self._ui
        self._start_anew()
        ui.promptLabel.setVisible(session.base is None)
        ui.faceLabel.setVisible(session.base is not None)
        ui.faceLabel.setText(session.name)
        self._display.see_through(session.base)
        self._display.show_border()
        self._solve_or_wait(session.problem, session.base is not None)

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if not subelements.is_face(name) or not selection.has_shape(obj):
            selection.tell(translate("Fairing", "Pick the face to be shaped anew."))
            return
        self._session.pick(obj, name)
        self._show_unsolved("")
        self._ui.resultCombo.blockSignals(True)
        self._ui.resultCombo.setCurrentIndex(RESULTS.index(self._session.request.result))
        self._ui.resultCombo.blockSignals(False)
        self._refresh()

    def _show_result(self, value):
        self._result, mesh = value
        self._display.show_mesh(mesh)
        return self._judge(self._result, self._result.report)

    def _judge(self, edit, report: dict) -> tuple[Status, str]:
        """What an edit has moved, and its notes."""
        return Status.GOOD, edit.verdict + "".join(f"\n{note['text']}" for note in report["notes"])

    def _show_nothing(self) -> None:
        self._display.show_unsolved()

    def _connect_labels(self) -> None:
        """There are none."""

    def _needed_width(self) -> int:
        return 0


class EditPanel(GuidedPanel, FacePanel):
    """With what guides."""

    _has_folded = True  # nothing here is rarely needed

    @classmethod
    def show(cls, picks: Optional[selection.Picks] = None, obj: Optional[App.DocumentObject] = None) -> bool:
        """Opens the panel for a new edit, or to change one. False, with a message, where that cannot be."""
        def make_session() -> EditSession:
            if obj:
                return EditSession.of_object(obj)
            session = EditSession(App.ActiveDocument, EditRequest())
            if picks:
                session.pick(picks.base, picks.names[0])
            return session

        return cls.launch(make_session)

    @property
    def _wanted(self) -> selection.Wanted:
        return selection.Wanted.GUIDES if self._guidance.is_picking else selection.Wanted.EDGES

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if self._guidance.is_picking:
            self._guidance.picked(obj, name)
        else:
            super()._picked(obj, name)

    def _followed(self, report: dict) -> tuple:
        return report["after"], report["energy"]
