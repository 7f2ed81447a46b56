# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Fill Hole: pick, look at the surface and its numbers, press OK."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App

from .. import selection, settings
from ..fill_request import FillRequest
from .boundary_table import BoundaryTable
from .compared_panel import ComparedPanel
from .edge_panel import EdgePanel
from .fill_session import FillSession
from .through_list import ThroughList


class FillPanel(ComparedPanel, EdgePanel):
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

    def _make_table(self) -> BoundaryTable:
        return BoundaryTable(self._ui.boundaryTable)

    def _set_up(self) -> None:
        super()._set_up()
        self._shown_loop: Optional[list[int]] = None
        self._through = ThroughList(self._ui, self._session)
        self._through.changed.connect(self._refresh)

    @property
    def _wanted(self) -> selection.Wanted:
        if self._guidance.is_picking:
            return selection.Wanted.GUIDES
        return selection.Wanted.POINTS if self._through.is_picking else selection.Wanted.EDGES

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if self._through.is_picking:
            self._through.picked(obj, name)
            return
        if self._guidance.is_picking:
            self._guidance.picked(obj, name)
            return
        edge = self._session.edge_in_loop(name) if obj is self._session.base else 0
        if edge:
            self._table.select(edge)
        elif selection.has_shape(obj):
            self._session.pick(obj, [name])
            self._refresh()

    def _refresh(self, *_) -> None:
        """Something changed: find the hole, show it, and have its surface computed."""
        session = self._session
        self._start_anew()
        session.find_loop()
        self._table.show_loop(session.loop, session.request)
        has_picks = bool(session.request.edges or session.request.faces)
        self._ui.promptLabel.setVisible(not has_picks)
        self._show_picks(has_picks)
        self._through.show(None, has_picks)
        edges = [side["edge"] for side in session.loop]
        if edges != self._shown_loop:
            self._shown_loop = edges
            self._show_unsolved("")
        self._solve_or_wait(session.problem, has_picks)

    def _show_report(self, report: dict) -> None:
        super()._show_report(report)
        self._choices.show_layout(report["layout"])
        self._through.show(report, True)
