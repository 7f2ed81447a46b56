# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Blend Faces: pick the edges of either side, look at the surface and its numbers, press OK."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from .. import selection, settings, subelements
from ..blend_request import BlendRequest
from ..features.blend_sides import Side
from ..translation import translate
from .blend_display import BlendDisplay
from .blend_session import CHOICES, FROM, TO, BlendSession
from .compared_panel import ComparedPanel
from .edge_panel import EdgePanel
from .ends_list import EndsList
from .fill_choices import LimitChoices
from .more_choices import MoreChoices
from .pair_list import PairList
from .reach_rows import ReachRows
from .ring_row import RingRow
from .setback_curves import SetbackCurves
from .side_tables import SideTables
from .status import Status


class BlendPanel(ComparedPanel, EdgePanel):
    """Connects a BlendSession with its form."""

    FORM, BOX, ICON, MAKE_CHOICES = "blend_faces.ui", "sidesBox", "Fairing_BlendFaces.svg", LimitChoices
    DISPLAY = BlendDisplay

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

    def _make_table(self) -> SideTables:
        return SideTables(self._ui)

    def _set_up(self) -> None:
        super()._set_up()
        self._reaches = ReachRows(self._ui, self._asked_reaches())
        self._reaches.changed.connect(self._reach)
        self._display.on_reach = self._drag
        self._more = MoreChoices(self._ui, self._session)
        self._pairs = PairList(self._ui, self._session)
        self._curves = SetbackCurves(self._ui, self._session)
        self._ends = EndsList(self._ui, self._session)
        self._ring = RingRow(self._ui, self._session)
        for part in (self._more, self._pairs, self._curves, self._ends, self._ring):
            part.changed.connect(self._refresh)
        self._pointed = 0
        self._table.pointed.connect(self._point_at)
        self._ui.dropButton.clicked.connect(self._drop)

    @property
    def _wanted(self) -> selection.Wanted:
        if self._guidance.is_picking:
            return selection.Wanted.GUIDES
        return selection.Wanted.POINTS if self._pairs.is_picking or self._curves.is_picking else selection.Wanted.EDGES

    def _picked(self, obj: App.DocumentObject, name: str) -> None:
        for part in (self._guidance, self._pairs, self._curves, self._ends, self._ring):
            if part.is_picking:
                part.picked(obj, name)
                return
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

    def _point_at(self, edge: int) -> None:
        self._pointed = edge
        self._ui.dropButton.setEnabled(self._session.is_picked(edge))

    def _drop(self) -> None:
        self._session.drop(self._pointed)
        self._refresh()

    def _clear(self) -> None:
        self._ui.fromButton.setChecked(True)
        super()._clear()

    def _drag(self, side: int, middle: float) -> None:
        """An arrow was dragged: where the reach changes along the side, both ends follow in proportion."""
        self._reach(side, self._session.scale_reach(side, middle))
        self._more.show_ends()

    def _reach(self, side: int, value: float) -> None:
        """Shows another reach at once where there is a blend to start from; what OK takes is solved when it stays."""
        try:
            reached = self._session.reach(side, value)
        except ValueError as error:
            self._say(Status.BAD, str(error))
            return
        self._reaches.show(self._asked_reaches())
        if reached is None:
            self._refresh()
            return
        self._drop_comparison()
        self._idle()  # what still runs is of another reach
        self._result, self._kept = None, reached[0]
        self._say(*self._show_surface(*reached))
        self._draw_picture(reached[0])
        self._settled.start()

    def _show_guided(self, blend, mesh) -> None:
        self._session.keep(blend)  # reaches start from it
        super()._show_guided(blend, mesh)

    def _asked_reaches(self) -> tuple[float, float]:
        return self._session.request.from_reach, self._session.request.to_reach

    def _show_result(self, value):
        self._session.keep(value[0])
        return super()._show_result(value)

    def _show_report(self, report: dict) -> None:
        super()._show_report(report)
        self._ends.show(report)

    def _refresh(self, *_) -> None:
        """Something changed: show the sides, and have the surface computed."""
        session = self._session
        self._start_anew()
        session.update()
        self._table.show(session.loops, session.request)
        has_both = None not in session.sides
        self._ui.promptLabel.setVisible(not has_both)
        self._reaches.set_visible(has_both)
        self._more.show_sides()
        self._pairs.show()
        self._curves.show()
        self._ends.show()
        self._ring.show()
        self._show_picks(any(session.sides))
        self._point_at(self._pointed)
        self._show_unsolved("")
        self._solve_or_wait(session.problem, has_both)
