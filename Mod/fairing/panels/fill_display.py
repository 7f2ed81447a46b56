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
from .guide_handles import GuideHandles
from .scene_mouse import SceneMouse
from .status import Status

FIELD_POINTS = 12  # arrows along either direction of a patch


class FillDisplay:
    """Draws a session; on_click(edge, with_shift) and on_hover(edge) come from the labels."""

    def __init__(self, view, session: FillSession, on_click: Callable[[int, bool], None],
                 on_hover: Callable[[int], None]):
        self._session = session
        self._preview = Preview(view, settings.patch_color())
        self._mouse = SceneMouse(view)
        self.guide_handles = GuideHandles(self._mouse)
        self._put_up_handles()
        self._labels = EdgeLabels(self._mouse, on_click, on_hover)
        self._report: Optional[dict] = None
        self._with_labels = True
        self._pointed = 0

    def _put_up_handles(self) -> None:
        """What takes clicks below the labels, where there is anything."""

    def show_labels(self, shown: bool) -> None:
        self._with_labels = shown
        self._draw_edges()

    def point_at(self, edge: int) -> None:
        """Lets one edge stand out, 0 for none."""
        self._pointed = edge
        self._draw_lines()  # not the labels: this may come from one under the mouse

    def show_unsolved(self) -> None:
        """The edges alone."""
        self._report = None
        self._preview.hide_surface()
        self._preview.guidance.clear()
        self.guide_handles.use_mesh(None)
        self._draw_edges()

    def show_fill(self, report: dict, mesh) -> None:
        self._report = report
        self.show_mesh(mesh)
        self._draw_edges()

    def show_mesh(self, mesh) -> None:
        """The surface alone."""
        self._preview.show_surface(mesh)
        self.guide_handles.use_mesh(mesh)

    def give_way(self, to_picture: bool) -> None:
        """Whether a picture of its curvature stands for the surface."""
        self._preview.give_way(to_picture)

    def show_guidance(self, fill, with_field: bool, with_net: bool) -> None:
        """What guides a native result, and its control points, where they are wanted."""
        drawing = self._preview.guidance
        drawing.clear()
        if with_field:
            drawing.show_field(*fill.guide_arrows(FIELD_POINTS))
        if with_net:
            drawing.show_net(fill.control_net())

    def remove(self) -> None:
        self.guide_handles.remove()
        self._labels.remove()
        self._preview.remove()

    def _draw_edges(self) -> None:
        for drawn in (self._preview, self._labels):
            drawn.place(self._session.placement)
        self._draw_lines()
        shown = self._measured_sides() if self._with_labels else ()
        self._labels.show([self._label(side, sign, measured) for side, sign, measured in shown])

    def _draw_lines(self) -> None:
        sides = self._measured_sides()
        pointed = [position for position, (side, _, _) in enumerate(sides) if side["edge"] == self._pointed]
        self._preview.show_edges([side["points"] for side, _, _ in sides], [sign.rgb for _, sign, _ in sides], pointed)

    def _measured_sides(self) -> list[tuple[dict, Status, Optional[dict]]]:
        """Every side of the hole, how well it is met, and what was measured along it."""
        measured = {side["edge"]: side for side in self._report["sides"]} if self._report else {}
        sides = [(side, measured.get(side["edge"])) for side in self._session.loop]
        return [(side, status.of_side(found, self._report), found) for side, found in sides]

    def _label(self, side: dict, sign: Status, measured: Optional[dict]) -> Label:
        text = side["continuity"]
        if measured and sign is not Status.GOOD:
            text += "  " + deviation_text(measured, self._report["limits"])
        middle = side["points"][len(side["points"]) // 2]
        return Label(side["edge"], tuple(float(x) for x in middle), text, sign.rgb)
