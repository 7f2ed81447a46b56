# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature pictures in the 3D view: meshes painted through a texture, so that colours are exact inside triangles, too.

A scale of colours is looked up by each vertex's value, stripes by what each vertex mirrors as the camera stands: they
follow it, and need no shader. Coin's own environment texture would do so, too, but has too few texels for nearly flat
faces.
"""

from __future__ import annotations

import numpy as np
from pivy import coin

from . import picture_colors as colors
from .scene_vectors import set_faces, set_vectors

# Nearer than what FreeCAD draws of the same faces: its triangles are coarser and lie off by as much as this share of
# the depth of the scene.
DEPTH_RANGE = (0.0, 0.997)

# Coin's words for how a texture is looked up: between neighbouring texels, or on smaller copies of it as well. Those
# of a scale would mix its colours with that of what is unknown.
INTERPOLATED, AVERAGED = 0.3, 0.9


class PictureDrawing:
    """Nodes of their own under a view's scene graph; call from the window's thread only."""

    def __init__(self, view):
        self._view, self._parts, self._stripes = view, [], 0
        self._root, self._shown = coin.SoSeparator(), coin.SoSwitch()
        self._transform, self._texture = coin.SoTransform(), coin.SoTexture2()
        self._meshes = coin.SoSeparator()
        pick, depth = coin.SoPickStyle(), coin.SoDepthBuffer()
        pick.style = coin.SoPickStyle.UNPICKABLE
        depth.range = DEPTH_RANGE
        material, self._quality = coin.SoMaterial(), coin.SoComplexity()
        material.diffuseColor, material.ambientColor = (0.68, 0.68, 0.68), (0.5, 0.5, 0.5)
        material.emissiveColor = (0.22, 0.22, 0.22)  # slopes that lean away from the light keep their colours
        material.specularColor = (0.0, 0.0, 0.0)
        self._texture.model = coin.SoTexture2.MODULATE
        self._texture.wrapT = coin.SoTexture2.CLAMP
        for node in (pick, self._transform, depth, material, self._quality, self._texture, self._meshes):
            self._shown.addChild(node)
        self._root.addChild(self._shown)
        self._shown.whichChild = coin.SO_SWITCH_NONE
        view.getSceneGraph().addChild(self._root)
        self._sensor = coin.SoNodeSensor(self._camera_moved, None)

    def place(self, placement) -> None:
        """From the coordinates of what is shown to the document's."""
        self._transform.translation = tuple(placement.Base)
        self._transform.rotation = coin.SbRotation(*placement.Rotation.Q)

    def show_meshes(self, meshes, are_closed) -> None:
        """(points, normals, triangles) each, and whether it is seen from its front alone."""
        while len(self._parts) > len(meshes):
            self._meshes.removeChild(self._parts.pop().root)
        while len(self._parts) < len(meshes):
            self._parts.append(_Part())
            self._meshes.addChild(self._parts[-1].root)
        for part, mesh, is_closed in zip(self._parts, meshes, are_closed):
            part.show(*mesh, is_closed)

    def paint_values(self, values, low: float, high: float, is_signed: bool) -> None:
        """A value a vertex of every mesh, over a range."""
        self._stop_stripes()
        self._set_image(colors.scale_image(is_signed), coin.SoTexture2.CLAMP, INTERPOLATED)
        for part, own in zip(self._parts, values):
            part.paint(colors.places_in(np.asarray(own), low, high))
        self._shown.whichChild = coin.SO_SWITCH_ALL

    def paint_zebra(self, stripes: int) -> None:
        self._stripes = stripes
        self._set_image(colors.zebra_image(), coin.SoTexture2.REPEAT, AVERAGED)
        self._shown.whichChild = coin.SO_SWITCH_ALL
        self._sensor.detach()
        self.follow_camera()

    def follow_camera(self) -> None:
        """FreeCAD puts up another one when it changes between parallel and perspective."""
        camera = self._view.getCameraNode()
        if self._stripes and self._sensor.getAttachedNode() != camera:
            self._sensor.detach()
            self._sensor.attach(camera)
            self._paint_stripes()

    def hide(self) -> None:
        self._stop_stripes()
        self._shown.whichChild = coin.SO_SWITCH_NONE

    def remove(self) -> None:
        if self._root is None:
            return
        self._stop_stripes()
        try:
            self._view.getSceneGraph().removeChild(self._root)
        except RuntimeError:  # the view has been closed
            pass
        self._root = None

    def _set_image(self, image, wrap, quality: float) -> None:
        height, width, channels = image.shape
        self._quality.textureQuality = quality
        self._texture.wrapS = wrap
        self._texture.image.setValue(coin.SbVec2s(width, height), channels, image.tobytes())

    def _stop_stripes(self) -> None:
        self._stripes = 0
        self._sensor.detach()

    def _camera_moved(self, *_) -> None:
        """Before the next frame is drawn."""
        if self._stripes:
            self._paint_stripes()

    def _paint_stripes(self) -> None:
        camera = self._camera()
        for part in self._parts:
            part.paint(colors.stripes_at(part.points, part.normals, camera, self._stripes))

    def _camera(self) -> colors.Camera:
        """In the coordinates of the meshes."""
        node, back = self._view.getCameraNode(), self._transform.rotation.getValue().inverse()

        def turned(vector):
            return np.array(back.multVec(coin.SbVec3f(*vector)).getValue(), np.float32)

        up, out = (turned(node.orientation.getValue().multVec(coin.SbVec3f(*axis)).getValue())
                   for axis in ((0, 1, 0), (0, 0, 1)))
        if not node.isOfType(coin.SoPerspectiveCamera.getClassTypeId()):
            return colors.Camera(up, out, None)
        away = node.position.getValue() - self._transform.translation.getValue()
        return colors.Camera(up, out, turned(away.getValue()))


class _Part:
    """One mesh, and where its vertices look up the texture."""

    def __init__(self):
        self.root, self.points, self.normals = coin.SoSeparator(), None, None
        self._values, self._hints = coin.SoTextureCoordinate2(), coin.SoShapeHints()
        self._points, self._normals, self._faces = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        normals, places = coin.SoNormalBinding(), coin.SoTextureCoordinateBinding()
        normals.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        places.value = coin.SoTextureCoordinateBinding.PER_VERTEX_INDEXED
        self._hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        for node in (self._hints, places, self._values, self._points, self._normals, normals, self._faces):
            self.root.addChild(node)

    def show(self, points, normals, triangles, is_closed: bool) -> None:
        if points is self.points:  # the mesh it has
            return
        self.points, self.normals = points, normals
        self._hints.shapeType = coin.SoShapeHints.SOLID if is_closed else coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        self._faces.coordIndex.setNum(0)  # never an index beyond the points
        set_vectors(self._points.point, points)
        set_vectors(self._normals.vector, normals)
        set_vectors(self._values.point, np.zeros((len(points), 2)))
        set_faces(self._faces.coordIndex, triangles)

    def paint(self, places) -> None:
        """n x 2, in the texture."""
        set_vectors(self._values.point, places)
