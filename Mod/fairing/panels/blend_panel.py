# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Blend Faces: pick the edges of either side, look at the surface and its numbers, press OK."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore

from .. import selection, settings, subelements
from ..blend_request import BlendRequest
from ..choices import CONTINUITIES
from ..features.blend_sides import Side
from ..translation import translate
from . import status
from .blend_session import CHOICES, FROM, TO, BlendSession
from .fill_choices import LimitChoices
from .fill_display import FillDisplay
from .side_tables import SideTables
from .solving_panel import SolvingPanel


class BlendPanel(SolvingPanel):
    """Connects a BlendSession with its form."""

    FORM, BOX, ICON, MAKE_CHOICES = "blend_faces.ui", "sidesBox", "Fairing_BlendFaces.svg", LimitChoices

    @classmethod
    def show(cls, sides=(), obj: Optional[App.DocumentObject] = None) -> bool:
        """Opens the panel for a new blend between links, or to edit one. False, with a message, where that cannot
        be."""
        def make_session() -> BlendSession:
            if obj:
                return BlendSession.of_object(obj)
            chosen = {name: value for name, value in settings.new_choices().items() if name in CHOICES}
            return BlendSession(App.ActiveDocument, BlendRequest(**chosen),
                                [Side.of(side) for side in sides] or (None, None))

        return cls.launch(make_session)

    def _set_up(self) -> None:
        ui = self._ui
        self._table = SideTables(ui)
        self._display = FillDisplay(self._view, self._session, self._label_clicked, self._table.select)
        self._table.chosen.connect(lambda edge, word: self._set_continuity(word, edge))
        self._table.pointed.connect(self._display.point_at)
        for word in CONTINUITIES:
            button = getattr(ui, f"all{word}Button")
            button.clicked.connect(lambda *_, word=word: self._set_continuity(word))
        ui.clearButton.clicked.connect(self._clear)

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if not subelements.is_edge(name):
            selection.tell(translate("Fairing", "Pick an edge: a blend starts from edges and ends at edges."))
            return
        known = self._session.number_of(obj, name)
        if known:
            self._table.select(known)
            return
        self._session.pick(TO if self._ui.toButton.isChecked() else FROM, obj, name)
        if self._session.sides[TO] is None:
            self._ui.toButton.setChecked(True)
        self._refresh()

    def _label_clicked(self, edge: int, with_shift: bool) -> None:
        """The next continuity, for all edges with shift. Later, since the label under the mouse is made anew."""
        current = next(row["continuity"] for row in self._session.loop if row["edge"] == edge)
        word = CONTINUITIES[(CONTINUITIES.index(current) + 1) % len(CONTINUITIES)]
        QtCore.QTimer.singleShot(0, lambda: self._set_continuity(word, None if with_shift else edge))

    def _set_continuity(self, word: str, edge: Optional[int] = None) -> None:
        self._session.set_continuity(word, edge)
        self._refresh()

    def _clear(self) -> None:
        self._session.clear()
        self._ui.fromButton.setChecked(True)
        self._refresh()

    def _refresh(self, *_) -> None:
        """Something changed: show the sides, and have the surface computed."""
        session, ui = self._session, self._ui
        self._result = None
        session.update()
        self._table.show(session.loops, session.request)
        ui.promptLabel.setVisible(None in session.sides)
        for widget in (ui.allG2Button, ui.allG1Button, ui.allG0Button, ui.clearButton):
            widget.setEnabled(any(session.sides))
        self._show_unsolved("")
        self._solve_or_wait(session.problem, None not in session.sides)

    def _show_result(self, value):
        self._result, mesh = value
        report = self._result.report
        self._display.show_fill(report, mesh)
        self._table.show_report(report)
        self._choices.show_limits(report["limits"])
        notes = "".join(f"\n{note['text']}" for note in report["notes"])
        self._ui.verdictLabel.setToolTip(self._result.composition + notes)
        return status.of_fill(self._result), self._result.verdict + notes

    def _show_nothing(self) -> None:
        self._display.show_unsolved()
        self._table.show_report(None)
        self._ui.verdictLabel.setToolTip("")
