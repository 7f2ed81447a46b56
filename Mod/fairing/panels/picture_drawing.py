# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature pictures in the 3D view: meshes painted through a texture, so that colours are exact inside triangles, too.

A scale of colours is looked up by each vertex's value. Stripes are looked up by how each vertex mirrors the camera
(Coin's SoTextureCoordinateEnvironment): they follow the view without a shader.
"""

from __future__ import annotations

import numpy as np
from pivy import coin

from . import picture_colors as colors
from .scene_vectors import set_indices, set_vectors

# Nearer than what FreeCAD draws of the same faces: its triangles are coarser and lie off by as much as this share of
# the depth of the scene.
DEPTH_RANGE = (0.0, 0.9985)


class PictureDrawing:
    """Nodes of their own under a view's scene graph; call from the window's thread only."""

    def __init__(self, view):
        self._view, self._parts = view, []
        self._root, self._shown = coin.SoSeparator(), coin.SoSwitch()
        self._transform, self._texture = coin.SoTransform(), coin.SoTexture2()
        self._meshes = coin.SoSeparator()
        pick, hints, depth = coin.SoPickStyle(), coin.SoShapeHints(), coin.SoDepthBuffer()
        pick.style = coin.SoPickStyle.UNPICKABLE
        hints.vertexOrdering, hints.shapeType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        depth.range = DEPTH_RANGE
        material, quality = coin.SoMaterial(), coin.SoComplexity()
        material.diffuseColor, material.ambientColor = (0.86, 0.86, 0.86), (0.5, 0.5, 0.5)
        material.specularColor = (0.0, 0.0, 0.0)
        quality.textureQuality = 0.5  # interpolated, but not averaged: the scale has sharp ends
        self._texture.model = coin.SoTexture2.MODULATE
        self._texture.wrapS = self._texture.wrapT = coin.SoTexture2.CLAMP
        for node in (pick, self._transform, hints, depth, material, quality, self._texture, self._meshes):
            self._shown.addChild(node)
        self._root.addChild(self._shown)
        self._shown.whichChild = coin.SO_SWITCH_NONE
        view.getSceneGraph().addChild(self._root)

    def place(self, placement) -> None:
        """From the coordinates of what is shown to the document's."""
        self._transform.translation = tuple(placement.Base)
        self._transform.rotation = coin.SbRotation(*placement.Rotation.Q)

    def show_meshes(self, meshes) -> None:
        """(points, normals, triangles) each."""
        while len(self._parts) > len(meshes):
            self._meshes.removeChild(self._parts.pop().root)
        while len(self._parts) < len(meshes):
            self._parts.append(_Part())
            self._meshes.addChild(self._parts[-1].root)
        for part, mesh in zip(self._parts, meshes):
            part.show(*mesh)

    def paint_values(self, values, low: float, high: float, is_signed: bool) -> None:
        """A value a vertex of every mesh, over a range."""
        self._set_image(colors.scale_image(is_signed))
        for part, own in zip(self._parts, values):
            part.paint(colors.places_in(np.asarray(own), low, high))
        self._shown.whichChild = coin.SO_SWITCH_ALL

    def paint_zebra(self, stripes: int) -> None:
        self._set_image(colors.zebra(stripes))
        for part in self._parts:
            part.paint(None)
        self._shown.whichChild = coin.SO_SWITCH_ALL

    def hide(self) -> None:
        self._shown.whichChild = coin.SO_SWITCH_NONE

    def remove(self) -> None:
        if self._root is None:
            return
        try:
            self._view.getSceneGraph().removeChild(self._root)
        except RuntimeError:  # the view has been closed
            pass
        self._root = None

    def _set_image(self, image) -> None:
        height, width, channels = image.shape
        self._texture.image.setValue(coin.SbVec2s(width, height), channels, image.tobytes())


class _Part:
    """One mesh, and how its vertices look up the texture."""

    def __init__(self):
        self.root = coin.SoSeparator()
        self._values, self._mirror = coin.SoTextureCoordinate2(), coin.SoTextureCoordinateEnvironment()
        self._lookup = coin.SoSwitch()
        self._points, self._normals, self._faces = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        normals, places = coin.SoNormalBinding(), coin.SoTextureCoordinateBinding()
        normals.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        places.value = coin.SoTextureCoordinateBinding.PER_VERTEX_INDEXED
        for node in (self._values, self._mirror):
            self._lookup.addChild(node)
        for node in (places, self._lookup, self._points, self._normals, normals, self._faces):
            self.root.addChild(node)

    def show(self, points, normals, triangles) -> None:
        self._faces.coordIndex.setNum(0)  # never an index beyond the points
        set_vectors(self._points.point, points)
        set_vectors(self._normals.vector, normals)
        set_vectors(self._values.point, np.zeros((len(points), 2)))
        ends = np.full((len(triangles), 1), -1, np.int32)
        set_indices(self._faces.coordIndex, np.hstack([triangles, ends]).ravel())

    def paint(self, places) -> None:
        """Where each vertex looks its colour up; None: by what it mirrors."""
        self._lookup.whichChild = 0 if places is not None else 1
        if places is not None:
            set_vectors(self._values.point, places)
