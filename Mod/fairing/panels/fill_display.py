# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows of a fill being made: its surface, the edges round the hole, a label at each edge."""

from __future__ import annotations

from typing import Callable, Optional

from .. import settings
from . import status
from .edge_labels import EdgeLabels, Label
from .fill_session import FillSession
from .preview import Preview
from .quantities import deviation_text
from .status import Status


class FillDisplay:
    """Draws a session; on_click(edge, with_shift) and on_hover(edge) come from the labels."""

    def __init__(self, view, session: FillSession, on_click: Callable[[int, bool], None],
                 on_hover: Callable[[int], None]):
        self._session = session
        self._preview = Preview(view, settings.patch_color())
        self._labels = EdgeLabels(view, on_click, on_hover)
        self._report: Optional[dict] = None
        self._with_labels = True

    def show_labels(self, shown: bool) -> None:
        self._with_labels = shown
        self._draw_edges()

    def show_unsolved(self) -> None:
        """The edges alone."""
        self._report = None
        self._preview.hide_surface()
        self._draw_edges()

    def show_fill(self, report: dict, mesh) -> None:
        self._report = report
        self._preview.show_surface(mesh)
        self._draw_edges()

    def remove(self) -> None:
        self._labels.remove()
        self._preview.remove()

    def _draw_edges(self) -> None:
        for drawn in (self._preview, self._labels):
            drawn.place(self._session.placement)
        loop, report = self._session.loop, self._report
        measured = {side["edge"]: side for side in report["sides"]} if report else {}
        signs = [status.of_side(measured.get(side["edge"]), report) for side in loop]
        self._preview.show_edges([side["points"] for side in loop], [sign.rgb for sign in signs])
        labelled = zip(loop, signs) if self._with_labels else ()
        self._labels.show([self._label(side, sign, measured.get(side["edge"])) for side, sign in labelled])

    def _label(self, side: dict, sign: Status, measured: Optional[dict]) -> Label:
        text = side["continuity"]
        if measured and sign is not Status.GOOD:
            text += f"  {deviation_text(measured)}"
        middle = side["points"][len(side["points"]) // 2]
        return Label(side["edge"], tuple(float(x) for x in middle), text, sign.rgb)
