# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows of an edit being made: the new face, the border that stays, what guides."""

from __future__ import annotations

from .fill_display import FillDisplay
from .status import Status

SEEN_THROUGH = 70  # percent: the old face must not hide the new one


class EditDisplay(FillDisplay):
    """Draws an EditSession; its base is seen through meanwhile."""

    def __init__(self, view, session):
        self._base, self._looked = None, (0, True)
        super().__init__(view, session, lambda *_: None, lambda *_: None)

    def see_through(self, base) -> None:
        """Another base, None for none: the one before looks as it did."""
        if base is self._base:
            return
        if self._base is not None:
            view, (transparency, was_shown) = self._base.ViewObject, self._looked
            view.Transparency, view.Visibility = transparency, view.Visibility and was_shown
        self._base = base if base is not None and hasattr(base.ViewObject, "Transparency") else None
        if self._base is not None:
            view = self._base.ViewObject
            self._looked = view.Transparency, view.Visibility
            view.Transparency, view.Visibility = max(view.Transparency, SEEN_THROUGH), True

    def show_border(self) -> None:
        """The face was chosen anew."""
        self._draw_edges()

    def remove(self) -> None:
        self.see_through(None)
        super().remove()

    def _draw_lines(self) -> None:
        lines = self._session.lines
        self._preview.show_edges(lines, [Status.GOOD.rgb] * len(lines))
