# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows of a blend being made: what it shows of a fill, a handle for the reach of either side,
and which points of the sides belong together."""

from __future__ import annotations

from .blend_session import FROM, TO
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
        self._preview.show_matches(())
        self._show_handles()

    def show_fill(self, report: dict, mesh) -> None:
        super().show_fill(report, mesh)
        matches = report["matches"] if self._session.is_strip else ()
        self._preview.show_matches([(match["from"], match["to"]) for match in matches])
        self._show_handles()

    def remove(self) -> None:
        self._handles.remove()
        super().remove()

    def _show_handles(self) -> None:
        session = self._session
        self._handles.show(session.arms, [session.middle_reach(side) for side in (FROM, TO)], session.placement)
