# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Fill All Holes: look at the table of holes, press OK."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from .. import paths, selection, settings
from ..choices import CONTINUITIES
from ..features.fill_all_properties import verdict
from ..fill_all_request import FillAllRequest
from . import status
from .fill_all_session import FillAllSession
from .guidance_box import GuidanceBox
from .holes_display import HolesDisplay
from .holes_table import HolesTable, sentence_of
from .solving_panel import SolvingPanel
from .status import Status


class FillAllPanel(SolvingPanel):
    """Connects a FillAllSession with its form."""

    FORM, BOX, ICON = "fill_all.ui", "holesBox", "Fairing_FillAllHoles.svg"

    @classmethod
    def show(cls, base: Optional[App.DocumentObject] = None, obj: Optional[App.DocumentObject] = None) -> bool:
        """Opens the panel for the holes of an object, or to edit what fills them. False, with a message, where that
        cannot be."""
        def make_session() -> FillAllSession:
            if obj:
                return FillAllSession.of_object(obj)
            return FillAllSession(App.ActiveDocument, FillAllRequest(**settings.new_choices()), base)

        return cls.launch(make_session)

    def _make_boxes(self) -> list:
        guidance_ui = Gui.PySideUic.loadUi(paths.form("guidance.ui"))
        self._guidance = GuidanceBox(guidance_ui, self._session, takes_guides=False)
        self._guidance.changed.connect(self._refresh)
        self._guidance.moved.connect(self._refresh)
        self._guidance.failed.connect(lambda sentence: self._say(Status.BAD, sentence))
        return [guidance_ui.guidanceBox, *super()._make_boxes()]

    @property
    def _wanted(self) -> selection.Wanted:
        return selection.Wanted.GUIDES if self._guidance.is_picking else selection.Wanted.EDGES

    def _set_up(self) -> None:
        ui, session = self._ui, self._session
        self._choices_ui.compareButton.hide()  # it is about one surface
        self._shown: Optional[list[list[int]]] = None
        self._fills: list = []
        self._table = HolesTable(ui.holesTable)
        self._display = HolesDisplay(self._view, session, self._table.select)
        ui.continuityCombo.setCurrentIndex(CONTINUITIES.index(session.request.continuity))
        ui.outerCheck.setChecked(session.request.outer_borders)
        self._table.chosen.connect(lambda: self._fill(self._table.ticks()))
        self._table.pointed.connect(self._point_at)
        ui.allButton.clicked.connect(lambda: self._fill([True] * len(session.holes)))
        ui.noneButton.clicked.connect(lambda: self._fill([False] * len(session.holes)))
        ui.continuityCombo.currentIndexChanged.connect(
            lambda index: self._change(continuity=CONTINUITIES[index], edge_continuity=()))
        ui.outerCheck.toggled.connect(lambda on: self._change(outer_borders=on))

    def _change(self, **changes) -> None:
        self._session.change(**changes)
        self._refresh()

    def _fill(self, chosen: list[bool]) -> None:
        """Later: the table must not be rebuilt while it says what has changed in it."""
        self._session.set_filled(chosen)
        QtCore.QTimer.singleShot(0, self._refresh)

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        if self._guidance.is_picking:
            self._guidance.picked(obj, name)
        elif obj is self._session.base:
            self._table.select(self._session.hole_with(name))
        elif selection.has_shape(obj):
            self._session.use_base(obj)
            self._refresh()

    def _point_at(self, position: int) -> None:
        """A row was selected: its hole stands out, and its own verdict is read."""
        self._display.point_at(position)
        if 0 <= position < len(self._fills) and self._fills[position]:
            hole = self._fills[position]
            self._say(status.of_hole(hole), f"{position + 1}: {sentence_of(hole)}")

    def _refresh(self, *_) -> None:
        """Something changed: show the holes, and have their surfaces computed."""
        if self._is_closed:
            return
        session, ui = self._session, self._ui
        self._start_anew()
        ui.promptLabel.setVisible(session.base is None)
        self._table.show_holes(session.holes, [session.is_filled(hole) for hole in session.holes])
        for widget in (ui.allButton, ui.noneButton, ui.continuityCombo, ui.outerCheck):
            widget.setEnabled(session.base is not None)
        if session.holes != self._shown:
            self._shown = session.holes
            self._display.show_holes()
            self._show_unsolved("")
        self._solve_or_wait(session.what_is_missing, session.base is not None)

    def _show_result(self, value):
        self._result, mesh = value
        known = {hole.edges[0]: hole for hole in self._result.holes}
        self._fills = [known.get(hole[0]) for hole in self._session.holes]
        self._display.show_fills(self._fills, mesh)
        self._table.show_fills(self._fills)
        limits = [hole.fill.report["limits"] for hole in self._result.holes if hole.fill]
        self._choices.show_limits(min(limits, key=lambda limit: limit["gap"]))
        signs = [status.of_hole(hole) for hole in self._result.holes]
        worst = next((sign for sign in (Status.BAD, Status.NEARLY) if sign in signs), Status.GOOD)
        return worst, verdict(self._result)

    def _show_nothing(self) -> None:
        self._fills = [None] * len(self._session.holes)
        self._display.show_unsolved()
        self._table.show_fills(self._fills)
