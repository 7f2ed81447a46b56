# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows while all holes are filled: the surfaces, the edges round every hole, its number."""

from __future__ import annotations

from typing import Callable

import numpy as np

from .. import settings
from . import status
from .edge_labels import EdgeLabels, Label
from .fill_all_session import FillAllSession
from .preview import Preview
from .scene_mouse import SceneMouse


class HolesDisplay:
    """Draws a session; on_click(position) when the number of a hole is clicked."""

    def __init__(self, view, session: FillAllSession, on_click: Callable[[int], None]):
        self._session = session
        self._preview = Preview(view, settings.patch_color())
        self._labels = EdgeLabels(SceneMouse(view), lambda number, _: on_click(number - 1), lambda number: None)
        self._lines: list[list[np.ndarray]] = []  # hole by hole
        self._fills: list = []
        self._with_labels = True
        self._pointed = -1

    def show_labels(self, shown: bool) -> None:
        self._with_labels = shown
        self._draw_labels()

    def point_at(self, position: int) -> None:
        """Lets one hole stand out, -1 for none."""
        self._pointed = position
        self._draw_lines()  # not the labels: this may come from one under the mouse

    def show_holes(self) -> None:
        """The edges of other holes."""
        self._lines = [[np.asarray([tuple(point) for point in line], np.float32)
                        for line in self._session.lines(hole)] for hole in self._session.holes]
        self._pointed = -1
        self.show_unsolved()

    def show_unsolved(self) -> None:
        self._fills = [None] * len(self._lines)
        self._preview.hide_surface()
        self._draw()

    def show_fills(self, fills: list, mesh) -> None:
        self._fills = fills
        self._preview.show_surface(mesh)
        self._draw()

    def remove(self) -> None:
        self._labels.remove()
        self._preview.remove()

    def _draw(self) -> None:
        for drawn in (self._preview, self._labels):
            drawn.place(self._session.placement)
        self._draw_lines()
        self._draw_labels()

    def _draw_lines(self) -> None:
        lines, colors, thick = [], [], []
        for position, (edges, fill) in enumerate(zip(self._lines, self._fills)):
            if position == self._pointed:
                thick = range(len(lines), len(lines) + len(edges))
            lines += edges
            colors += [status.of_hole(fill).rgb] * len(edges)
        self._preview.show_edges(lines, colors, thick)

    def _draw_labels(self) -> None:
        labels = []
        for position, (edges, fill) in enumerate(zip(self._lines, self._fills)):
            middle = self._middle(position, edges)
            labels.append(Label(position + 1, tuple(map(float, middle)), str(position + 1), status.of_hole(fill).rgb))
        self._labels.show(labels if self._with_labels else [])

    def _middle(self, position: int, edges: list[np.ndarray]) -> np.ndarray:
        """Of a hole; of an outer border a place on it, where no hole's number is in the way."""
        if self._session.holes[position] in self._session.outer:
            return edges[0][len(edges[0]) // 2]
        return np.concatenate(edges).mean(axis=0)
