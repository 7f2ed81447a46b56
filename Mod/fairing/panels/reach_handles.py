# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrows in the 3D view that are as long as either side of a blend reaches: drag their tips."""

from __future__ import annotations

from typing import Callable

import FreeCAD as App
from pivy import coin

from .scene_handles import NOTHING, SceneHandles
from .scene_mouse import SceneMouse

SMALLEST, LARGEST = 0.05, 20.0  # what a tip can be dragged to
TIP = 13.0  # pixels, length of the arrow's head and radius within which the mouse grabs it
LINE_WIDTH = 3.0  # pixels
COLOR, LIT = (0.13, 0.42, 0.85), (0.20, 0.62, 1.0)
TEXT_SIZE = 13  # pixels


class ReachHandles(SceneHandles):
    """One arrow a side. on_drag(side, reach) while a tip is dragged; everything else in the view works as always."""

    def __init__(self, mouse: SceneMouse, on_drag: Callable[[int, float], None]):
        self._on_drag = on_drag
        self._grabbed = 0.0  # reach under the mouse less that of the tip
        super().__init__(mouse)

    def show(self, arms, reaches, placement) -> None:
        """Arms as the native Blend tells them, in the coordinates of a placement; none: no arrows."""
        self._make(len(arms), _Arrow)
        for arrow, (point, vector), reach in zip(self._arrows, arms, reaches):
            arrow.show(placement.multVec(App.Vector(*point)), placement.Rotation.multVec(App.Vector(*vector)), reach)
        self._light(self._lit)

    def _grab(self, event) -> None:
        self._grabbed = self._reach_under(event) - self._arrows[self._dragged].reach

    def _drag(self, event) -> None:
        reach = self._reach_under(event) - self._grabbed
        self._on_drag(self._dragged, round(min(max(reach, SMALLEST), LARGEST), 2))

    def _under(self, event) -> int:
        return next((side for side, arrow in enumerate(self._arrows) if self._mouse.is_near(event, arrow.tip, TIP)),
                    NOTHING)

    def _reach_under(self, event) -> float:
        """The reach at the point of the dragged arrow's line that is nearest to what lies under the mouse."""
        arrow = self._arrows[self._dragged]
        start, direction = (App.Vector(*item) for item in self._mouse.ray(event))
        along, between = arrow.vector, arrow.point - start
        direction.normalize()
        slant = along.dot(direction)
        square = along.dot(along) - slant ** 2
        if square < 1e-6 * along.dot(along):  # seen end on: no telling how far
            return arrow.reach
        return (slant * direction.dot(between) - along.dot(between)) / square


class _Arrow:
    """A line with a head of constant size, and its reach as text while it is lit."""

    def __init__(self):
        self.point = self.vector = self.tip = App.Vector()
        self.reach = 1.0
        self.root = coin.SoSeparator()
        self._color, self._line = coin.SoBaseColor(), coin.SoCoordinate3()
        self._move, self._turn, self._size = coin.SoTranslation(), coin.SoRotation(), coin.SoScale()
        self._text = coin.SoSwitch()
        self._label = coin.SoType.fromName("SoFrameLabel").createInstance()
        self._label.getField("size").setValue(TEXT_SIZE)
        self._label.getField("textColor").setValue(coin.SbColor(1.0, 1.0, 1.0))
        self._label.getField("backgroundColor").setValue(coin.SbColor(*COLOR))
        self._label.vertAlignment = coin.SoImage.HALF
        self._label.horAlignment = coin.SoImage.LEFT
        self._build()

    def show(self, point, vector, reach: float) -> None:
        self.point, self.vector, self.reach = point, vector, reach
        self.tip = point + vector * reach
        self._line.point.setValues(0, 2, [tuple(point), tuple(self.tip)])
        self._move.translation = tuple(self.tip)
        self._turn.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), coin.SbVec3f(*vector))
        self._label.getField("string").setValue(f"   {reach:.2f} \u00d7")

    def light(self, lit: bool) -> None:
        self._color.rgb = LIT if lit else COLOR
        self._text.whichChild = coin.SO_SWITCH_ALL if lit else coin.SO_SWITCH_NONE

    def scale(self, mouse: SceneMouse) -> None:
        length = TIP * mouse.pixel_size(self.tip)
        if abs(length - self._size.scaleFactor.getValue()[0]) > 1e-5 * length:
            self._size.scaleFactor = (length, length, length)

    def _build(self) -> None:
        light, style, hidden = coin.SoLightModel(), coin.SoDrawStyle(), coin.SoPickStyle()
        light.model = coin.SoLightModel.BASE_COLOR
        style.lineWidth = LINE_WIDTH
        hidden.style = coin.SoPickStyle.UNPICKABLE
        strip, head = coin.SoLineSet(), coin.SoCone()
        strip.numVertices.setValue(2)
        head.bottomRadius, head.height = 0.45, 1.2
        shaft, tip = coin.SoSeparator(), coin.SoSeparator()
        for node in (self._line, strip):
            shaft.addChild(node)
        for node in (self._move, self._text, self._turn, self._size, head):
            tip.addChild(node)
        self._text.addChild(self._label)
        for node in (hidden, light, style, self._color, shaft, tip):
            self.root.addChild(node)
