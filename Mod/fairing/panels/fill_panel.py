# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Fill Hole: pick, look at the surface and its numbers, press OK."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore

from .. import selection, settings
from ..choices import CONTINUITIES
from ..fill_request import FillRequest
from . import status
from .boundary_table import BoundaryTable
from .fill_display import FillDisplay
from .fill_session import FillSession
from .solving_panel import SolvingPanel
from .through_list import ThroughList


class FillPanel(SolvingPanel):
    """Connects a FillSession with its form."""

    FORM, BOX, ICON = "fill_hole.ui", "boundaryBox", "Fairing_FillHole.svg"

    @classmethod
    def show(cls, picks: Optional[selection.Picks] = None, obj: Optional[App.DocumentObject] = None) -> bool:
        """Opens the panel for a new fill, or to edit one. False, with a message, where that cannot be."""
        def make_session() -> FillSession:
            if obj:
                return FillSession.of_object(obj)
            session = FillSession(App.ActiveDocument, FillRequest(**settings.new_choices()))
            if picks:
                session.pick(picks.base, picks.names)
            return session

        return cls.launch(make_session)

    def _set_up(self) -> None:
        ui = self._ui
        self._shown_loop: Optional[list[int]] = None
        self._table = BoundaryTable(ui.boundaryTable)
        self._through = ThroughList(ui, self._session)
        self._display = FillDisplay(self._view, self._session, self._label_clicked, self._table.select)
        self._table.chosen.connect(lambda edge, word: self._set_continuity(word, edge))
        self._table.pointed.connect(self._display.point_at)
        for word in CONTINUITIES:
            button = getattr(ui, f"all{word}Button")
            button.clicked.connect(lambda *_, word=word: self._set_continuity(word))
        ui.clearButton.clicked.connect(self._clear)
        self._through.changed.connect(self._refresh)

    @property
    def _takes_points(self) -> bool:
        return self._through.is_picking

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if self._through.is_picking:
            self._through.picked(obj, name)
            return
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

    def _refresh(self, *_) -> None:
        """Something changed: find the hole, show it, and have its surface computed."""
        session, ui = self._session, self._ui
        self._result = None
        session.find_loop()
        self._table.show_loop(session.loop, session.request)
        has_picks = bool(session.request.edges or session.request.faces)
        ui.promptLabel.setVisible(not has_picks)
        for widget in (ui.allG2Button, ui.allG1Button, ui.allG0Button, ui.clearButton):
            widget.setEnabled(has_picks)
        self._through.show(None, has_picks)
        edges = [side["edge"] for side in session.loop]
        if edges != self._shown_loop:
            self._shown_loop = edges
            self._show_unsolved("")
        self._solve_or_wait(session.problem, has_picks)

    def _show_result(self, value):
        self._result, mesh = value
        report = self._result.report
        self._display.show_fill(report, mesh)
        self._table.show_report(report)
        self._choices.show_limits(report["limits"])
        self._choices.show_layout(report["layout"])
        self._through.show(report, True)
        notes = "".join(f"\n{note['text']}" for note in report["notes"])
        self._ui.verdictLabel.setToolTip(self._result.composition + notes)
        return status.of_fill(self._result), self._result.verdict + notes

    def _show_nothing(self) -> None:
        self._display.show_unsolved()
        self._table.show_report(None)
        self._ui.verdictLabel.setToolTip("")
