# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows of a blend being made: what it shows of a fill, and a handle for the reach of either side."""

from __future__ import annotations

from .fill_display import FillDisplay
from .reach_handles import ReachHandles


class BlendDisplay(FillDisplay):
    """Draws a BlendSession. The panel sets on_reach(side, reach), which is called while a handle is dragged."""

    def __init__(self, view, session, on_click, on_hover):
        self.on_reach = lambda side, reach: None
        super().__init__(view, session, on_click, on_hover)

    def _put_up_handles(self) -> None:
        self._handles = ReachHandles(self._mouse, lambda side, reach: self.on_reach(side, reach))

    def show_unsolved(self) -> None:
        super().show_unsolved()
        self._show_handles()

    def show_fill(self, report: dict, mesh) -> None:
        super().show_fill(report, mesh)
        self._show_handles()

    def remove(self) -> None:
        self._handles.remove()
        super().remove()

    def _show_handles(self) -> None:
        request = self._session.request
        self._handles.show(self._session.arms, (request.from_reach, request.to_reach), self._session.placement)
