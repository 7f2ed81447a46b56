# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field that guides a surface as arrows, and the surface's control net, in the 3D view."""

from __future__ import annotations

import numpy as np
from pivy import coin

from .scene_vectors import set_vectors

ARROW = 0.05  # of the size of what guides, the length of an arrow
HEAD = 0.3, 0.12  # of an arrow, length and half width of its head
WEAK, STRONG = np.array([0.35, 0.55, 0.85]), np.array([0.90, 0.15, 0.10])
NET_COLOR = (0.10, 0.35, 0.30)
LINE_WIDTH, POINT_SIZE = 1.0, 3.0  # pixels


class GuidanceDrawing:
    """Nodes of their own below `root`."""

    def __init__(self):
        self.root = coin.SoSeparator()
        light, style = coin.SoLightModel(), coin.SoDrawStyle()
        light.model, style.lineWidth = coin.SoLightModel.BASE_COLOR, LINE_WIDTH
        style.pointSize = POINT_SIZE
        self._field, self._net = _Field(), _Net()
        for node in (light, style, self._field.root, self._net.root):
            self.root.addChild(node)

    def show_field(self, points, normals, weights) -> None:
        """n x 3, n x 3 and n; none: nothing is drawn."""
        self._field.show(np.asarray(points, float), np.asarray(normals, float), np.asarray(weights, float))

    def show_net(self, nets) -> None:
        """(rows, columns, points row by row) of every patch."""
        self._net.show(nets)

    def clear(self) -> None:
        self._field.show(np.empty((0, 3)), np.empty((0, 3)), np.empty(0))
        self._net.show(())


class _Field:
    """A polyline an arrow: foot, tip, one barb, tip, the other barb."""

    def __init__(self):
        self.root = coin.SoSeparator()
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE
        self._colors, self._points, self._lines = coin.SoBaseColor(), coin.SoCoordinate3(), coin.SoLineSet()
        self._lines.numVertices.setNum(0)
        for node in (self._colors, binding, self._points, self._lines):
            self.root.addChild(node)

    def show(self, points, normals, weights) -> None:
        acting = weights > 0.0
        points, normals, weights = points[acting], normals[acting], weights[acting]
        self._lines.numVertices.setNum(0)
        if not len(points):
            return
        length = ARROW * np.linalg.norm(points.max(axis=0) - points.min(axis=0))
        along = length * normals / np.linalg.norm(normals, axis=1, keepdims=True)
        least = np.eye(3)[np.argmin(np.abs(normals), axis=1)]
        aside = np.cross(normals, least)
        aside *= length * HEAD[1] / np.linalg.norm(aside, axis=1, keepdims=True)
        tip, back = points + along, points + (1.0 - HEAD[0]) * along
        set_vectors(self._points.point, np.stack([points, tip, back + aside, tip, back - aside], axis=1).reshape(-1, 3))
        share = (weights / weights.max())[:, None]
        set_vectors(self._colors.rgb, (1.0 - share) * WEAK + share * STRONG)
        self._lines.numVertices.setValues(0, len(points), [5] * len(points))


class _Net:
    """Rows and columns as lines, above everything else, with a dot at every control point."""

    def __init__(self):
        self.root = coin.SoAnnotation()
        color = coin.SoBaseColor()
        color.rgb = NET_COLOR
        self._points, self._lines, self._dots = coin.SoCoordinate3(), coin.SoIndexedLineSet(), coin.SoMarkerSet()
        self._dots.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_5_5
        for node in (color, self._points, self._lines, self._dots):
            self.root.addChild(node)
        self.show(())

    def show(self, nets) -> None:
        self._lines.coordIndex.setNum(0)
        indices, points, first = [], [np.empty((0, 3))], 0
        for rows, columns, poles in nets:
            numbers = first + np.arange(rows * columns).reshape(rows, columns)
            for grid in (numbers, numbers.T):
                indices += np.hstack([grid, np.full((len(grid), 1), -1)]).ravel().tolist()
            points.append(np.asarray(poles, float))
            first += rows * columns
        set_vectors(self._points.point, np.vstack(points))
        self._dots.numPoints = first
        if indices:
            self._lines.coordIndex.setValues(0, len(indices), indices)
