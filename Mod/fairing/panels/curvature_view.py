# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of curvature in the 3D view, as its box in the panel asks for it, and its values under the mouse."""

from __future__ import annotations

import FreeCAD as App
import numpy as np
from pivy import coin

from ..pictures import NONE, QUANTITIES, ZEBRA, is_signed
from .mesh_hit import nearest_triangle
from .pause import pause
from .picture_box import PictureBox
from .picture_drawing import PictureDrawing
from .scene_mouse import SceneMouse

REST = 40  # ms the mouse stays before values are read: on its way to the panel it leaves the last ones standing


class CurvatureView:
    """`box` is the part of the panel; it is connected by whoever makes the pictures."""

    def __init__(self, view, ui):
        self.box = PictureBox(ui)
        self._view, self._mouse, self._drawing = view, SceneMouse(view), PictureDrawing(view)
        self._pictures, self._ranging, self._meshes, self._values = [], 0, [], []
        self._placement, self._ray = App.Placement(), None
        self._rest = pause(ui, REST, self._read_place)
        self._callback = self._moved  # removal goes by identity
        view.addEventCallbackPivy(coin.SoLocation2Event.getClassTypeId(), self._callback)

    @property
    def is_on(self) -> bool:
        return self.box.picture != NONE

    @property
    def is_empty(self) -> bool:
        return not self._pictures

    def show(self, pictures, beside=(), placement=App.Placement(), are_closed=None) -> None:
        """Native CurvaturePictures: those that the range is taken of, and others beside them; from their coordinates to
        the document's; and which of them are on solids, where nothing is seen from behind."""
        known = {id(picture): own for picture, *own in zip(self._pictures, self._meshes, self._values)}
        self._pictures, self._ranging, self._placement = [*pictures, *beside], len(pictures), placement
        parts = [known.get(id(picture)) or (picture.mesh(), picture.values()) for picture in self._pictures]
        self._meshes, self._values = [mesh for mesh, _ in parts], [values for _, values in parts]
        self._drawing.place(placement)
        self._drawing.show_meshes(self._meshes, are_closed or [False] * len(self._pictures))
        self.paint()

    def paint(self) -> None:
        """The same pictures as the box asks for them now."""
        picture = self.box.picture
        if picture == NONE or not self._pictures:
            self._drawing.hide()
        elif picture == ZEBRA:
            self._drawing.paint_zebra(self.box.stripes)
        else:
            low, high = self.range()
            self.box.show_range(low, high)
            column = QUANTITIES.index(picture)
            self._drawing.paint_values([values[:, column] for values in self._values], low, high, is_signed(picture))

    def range(self) -> tuple[float, float]:
        """What the colours span: the user's, or what the pictures have between them."""
        asked = self.box.range
        if asked is not None:
            return asked
        ranges = [picture.range(self.box.picture) for picture in self._pictures[:self._ranging]]
        return min(low for low, _ in ranges), max(high for _, high in ranges)

    def clear(self) -> None:
        """There is nothing to show."""
        self._pictures, self._meshes, self._values = [], [], []
        self._drawing.hide()
        self.box.forget_place()

    def detach(self) -> None:
        """Listens no longer; touches no scene."""
        self._rest.stop()
        self._pictures = []

    def remove(self) -> None:
        self.detach()
        self._drawing.remove()
        try:
            self._view.removeEventCallbackPivy(coin.SoLocation2Event.getClassTypeId(), self._callback)
        except RuntimeError:  # the view has been closed
            pass

    def place_on(self, start, direction):
        """What the native module tells of the first place on a line of sight in the document, None where it meets
        nothing."""
        back = self._placement.inverse()
        start = np.array(back.multVec(App.Vector(*start)))
        direction = np.array(back.Rotation.multVec(App.Vector(*direction)))
        hits = [(nearest_triangle(mesh, start, direction), picture)
                for mesh, picture in zip(self._meshes, self._pictures)]
        hits = [(hit, picture) for hit, picture in hits if hit is not None]
        if not hits:
            return None
        (_, triangle, a, b), picture = min(hits, key=lambda hit: hit[0][0])
        place = picture.at(triangle, a, b)
        return {**place, "point": tuple(self._placement.multVec(App.Vector(*place["point"])))}

    def _moved(self, node) -> None:
        if self.is_on and self._pictures:
            self._drawing.follow_camera()
            self._ray = self._mouse.ray(node.getEvent())
            self._rest.start()

    def _read_place(self) -> None:
        if self.is_on and self._pictures:
            self.box.show_place(self.place_on(*self._ray))
