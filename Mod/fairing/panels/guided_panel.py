# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels have in common whose surface is guided: the box, the arrows in the 3D view, and the surface that
follows at once."""

from __future__ import annotations

import time

import FreeCADGui as Gui

from .. import paths
from ..features.guides import NormalHandle
from .guidance_box import GuidanceBox
from .pictured_panel import PicturedPanel
from .status import Status

LONGEST_STEP = 0.15  # s the window may stand still for a surface that follows


class GuidedPanel(PicturedPanel):
    """A GuidedSession's panel. `_kept` is the native result that other weights and handles start from."""

    _kept = None
    _is_slow = False  # a step took too long for the surface to follow

    def _make_boxes(self) -> list:
        guidance_ui = Gui.PySideUic.loadUi(paths.form("guidance.ui"))
        self._guidance = GuidanceBox(guidance_ui, self._session)
        return [guidance_ui.guidanceBox, *super()._make_boxes()]

    def _set_up(self) -> None:
        super()._set_up()
        self._guidance.changed.connect(self._refresh)
        self._guidance.moved.connect(self._guide)
        self._guidance.shown.connect(self._draw_guides)
        self._guidance.failed.connect(lambda sentence: self._say(Status.BAD, sentence))
        handles = self._display.guide_handles
        handles.on_turn = self._turn
        handles.on_choose = self._guidance.select
        handles.on_place = self._guidance.place
        self._guidance.normal_near = handles.normal_near

    def _show_object(self, shown: bool) -> None:
        """The arrows to drag stand for its guides."""
        super()._show_object(shown)
        for guide in self._session.obj.Guides if self._session.obj else ():
            guide.ViewObject.Visibility = shown

    def _turn(self, position: int, changes: dict) -> None:
        self._guidance.turn(position, **changes)

    def _start_anew(self) -> None:
        super()._start_anew()
        self._kept, self._is_slow = None, False

    def _guide(self) -> None:
        """Shows the surface under another guide at once where there is one to start from, and it is quick; what OK takes
        is solved when the guide stays."""
        self._draw_handles()
        if self._kept is None or not self._ui.previewCheck.isChecked():
            self._refresh()
            return
        self._result = None
        self._settled.stop()
        if self._is_slow or not self._kept.guides_quickly:
            self._solve_or_wait(self._session.problem, True)
            return
        self._idle()
        began = time.monotonic()
        try:
            guided = self._session.guided(self._kept)
        except ValueError as error:
            self._say(Status.BAD, str(error))
        else:
            self._show_guided(*guided)
            self._settled.start()
        self._is_slow = time.monotonic() - began > LONGEST_STEP

    def _show_guided(self, fill, mesh) -> None:
        """The surface, how it follows and how good it is; the rest of its numbers are read when it stays."""
        guidance = self._guidance
        report = fill.report
        self._say(*self._judge(fill, report))
        self._display.show_mesh(mesh)
        self._draw_picture(fill)
        self._display.show_guidance(fill, guidance.shows_field, guidance.shows_net)
        guidance.show_followed(*self._followed(report))

    def _show_result(self, value):
        self._kept = value[0]
        shown = super()._show_result(value)
        self._guidance.show_report(self._kept.report, *self._followed(self._kept.report))
        self._draw_guides()
        self._draw_picture(self._kept)
        return shown

    def _show_nothing(self) -> None:
        super()._show_nothing()
        self._draw_picture(None)
        self._guidance.show_report(None)
        self._draw_handles()

    def _draw_guides(self) -> None:
        """What is to be seen of the guidance has changed."""
        if self._is_closed:
            return
        self._make_way()
        self._draw_handles()
        if self._result is not None:
            self._display.show_guidance(self._result, self._guidance.shows_field, self._guidance.shows_net)

    def _make_way(self) -> None:
        """Once the surface is guided the limits, rarely needed then, fold away, so that nothing scrolls."""
        if self._session.is_guided:
            self._fold_limits()

    def _draw_handles(self) -> None:
        session = self._session
        handles = [(position, guide.point, session.normal_of(position), guide.radius) for position, guide in enumerate(session.guides)
                   if isinstance(guide, NormalHandle)]
        self._display.guide_handles.show(handles, self._guidance.position, session.placement)
        self._display.guide_handles.is_placing = self._guidance.is_placing

    def _followed(self, report: dict) -> tuple:
        """Of a report how well the guide is followed, and the energy."""
        return report["guidance"], report["solve"]["energy"]
