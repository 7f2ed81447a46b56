# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel draws into the 3D view: the new surface and the edges round the hole. Never selected, never saved."""

from __future__ import annotations

import numpy as np
from pivy import coin

from .guidance_drawing import GuidanceDrawing
from .scene_vectors import set_faces, set_vectors

TRANSPARENCY = 0.15
MATCH_COLOR, DOTTED = (0.13, 0.15, 0.18), 0x3333
EDGE_WIDTH, THICK_WIDTH = 4.0, 9.0  # pixels
DEPTH_RANGE = (0.0, 0.9998)  # a touch nearer than the base's own edges, which would show through otherwise
DEPTH_ON_PICTURE = (0.0, 0.9965)  # nearer than a picture of curvature


class Preview:
    """Nodes of their own under the view's scene graph; call from the window's thread only."""

    def __init__(self, view, color):
        self._view = view
        self._root = coin.SoSeparator()
        self._transform = coin.SoTransform()
        self._root.addChild(_unpickable())
        self._root.addChild(self._transform)
        self._surface = _Surface(color)
        self._edges = _Edges()
        self._veil = coin.SoSwitch()
        self._veil.addChild(self._surface.root)
        self._veil.whichChild = coin.SO_SWITCH_ALL
        self._root.addChild(self._veil)
        self._root.addChild(self._edges.root)
        self._matches = _Matches()
        self._root.addChild(self._matches.root)
        self.guidance = GuidanceDrawing()
        self._root.addChild(self.guidance.root)
        view.getSceneGraph().addChild(self._root)

    def place(self, placement) -> None:
        """From the coordinates of what is shown to the document's."""
        self._transform.translation = tuple(placement.Base)
        self._transform.rotation = coin.SbRotation(*placement.Rotation.Q)

    def show_surface(self, mesh) -> None:
        """Points (n x 3), normals (n x 3) and triangles (m x 3) as numpy arrays."""
        self._surface.show(*mesh)

    def hide_surface(self) -> None:
        self._surface.clear()

    def give_way(self, to_picture: bool) -> None:
        """Whether a picture of its curvature stands for the surface; its edges stay in sight."""
        self._veil.whichChild = coin.SO_SWITCH_NONE if to_picture else coin.SO_SWITCH_ALL
        self._edges.depth.range = DEPTH_ON_PICTURE if to_picture else DEPTH_RANGE

    def show_edges(self, lines, colors, thick=()) -> None:
        """Polylines (each n x 3), their colours, and the positions of those that stand out."""
        self._edges.show(lines, colors, thick)

    def show_matches(self, pairs) -> None:
        """Pairs of points that belong together: a dot at each and a dotted line between."""
        self._matches.show([point for pair in pairs for point in pair])

    def remove(self) -> None:
        if self._root is None:
            return
        try:
            self._view.getSceneGraph().removeChild(self._root)
        except RuntimeError:  # the view has been closed
            pass
        self._root = None


class _Surface:
    def __init__(self, color):
        self.root = coin.SoSeparator()
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE  # lit from both sides
        material = coin.SoMaterial()
        material.diffuseColor = color
        material.specularColor = (0.35, 0.35, 0.35)
        material.shininess = 0.6
        material.transparency = TRANSPARENCY
        binding = coin.SoNormalBinding()
        binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        self._points, self._normals, self._faces = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        self._triangles = None
        self.clear()
        for node in (hints, material, self._points, self._normals, binding, self._faces):
            self.root.addChild(node)

    def show(self, points, normals, triangles) -> None:
        if self._triangles is None or not np.array_equal(triangles, self._triangles):
            self.clear()  # never an index beyond the points
        set_vectors(self._points.point, points)
        set_vectors(self._normals.vector, normals)
        if self._triangles is None:
            set_faces(self._faces.coordIndex, triangles)
            self._triangles = triangles

    def clear(self) -> None:
        self._faces.coordIndex.setNum(0)
        self._triangles = None


class _Edges:
    def __init__(self):
        self.root, self.depth = coin.SoSeparator(), coin.SoDepthBuffer()
        self.depth.range = DEPTH_RANGE

    def show(self, lines, colors, thick) -> None:
        self.root.removeAllChildren()
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        for node in (light, self.depth):
            self.root.addChild(node)
        for position, (line, color) in enumerate(zip(lines, colors)):
            style, material = coin.SoDrawStyle(), coin.SoBaseColor()
            style.lineWidth = THICK_WIDTH if position in thick else EDGE_WIDTH
            material.rgb = color
            points, strip = coin.SoCoordinate3(), coin.SoLineSet()
            set_vectors(points.point, np.asarray(line, np.float32))
            strip.numVertices.setValue(len(line))
            for node in (style, material, points, strip):
                self.root.addChild(node)


class _Matches:
    def __init__(self):
        self.root = coin.SoAnnotation()
        light, color, style = coin.SoLightModel(), coin.SoBaseColor(), coin.SoDrawStyle()
        light.model = coin.SoLightModel.BASE_COLOR
        color.rgb = MATCH_COLOR
        style.linePattern = DOTTED
        self._points, self._lines, self._dots = coin.SoCoordinate3(), coin.SoLineSet(), coin.SoMarkerSet()
        self._dots.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_7_7
        for node in (light, color, style, self._points, self._lines, self._dots):
            self.root.addChild(node)
        self.show([])

    def show(self, points) -> None:
        """Two by two."""
        self._lines.numVertices.setNum(0)
        set_vectors(self._points.point, points)
        self._dots.numPoints = len(points)
        if points:
            self._lines.numVertices.setValues(0, len(points) // 2, [2] * (len(points) // 2))


def _unpickable():
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style
