# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrows in the 3D view that are as long as either side of a blend reaches: drag their tips."""

from __future__ import annotations

from typing import Callable

import FreeCAD as App
import FreeCADGui as Gui
from pivy import coin

from .scene_mouse import SceneMouse

SMALLEST, LARGEST = 0.05, 20.0  # what a tip can be dragged to
TIP = 13.0  # pixels, length of the arrow's head and radius within which the mouse grabs it
LINE_WIDTH = 3.0  # pixels
COLOR, LIT = (0.13, 0.42, 0.85), (0.20, 0.62, 1.0)
TEXT_SIZE = 13  # pixels


class ReachHandles:
    """One arrow a side. on_drag(side, reach) while a tip is dragged; everything else in the view works as always."""

    def __init__(self, mouse: SceneMouse, on_drag: Callable[[int, float], None]):
        self._mouse, self._on_drag = mouse, on_drag
        self._view = mouse.view
        self._root = coin.SoAnnotation()
        self._scaling = coin.SoCallback()
        self._arrows: list[_Arrow] = []
        self._lit = self._dragged = -1
        self._grabbed = 0.0  # reach under the mouse less that of the tip
        self._rescale = self._scale  # Coin keeps no reference
        self._scaling.setCallback(self._rescale, None)
        self._root.addChild(self._scaling)
        # removal goes by identity
        self._callbacks = ((coin.SoMouseButtonEvent.getClassTypeId(), self._button),
                           (coin.SoLocation2Event.getClassTypeId(), self._moved))
        self._view.getSceneGraph().addChild(self._root)
        for kind, callback in self._callbacks:
            self._view.addEventCallbackPivy(kind, callback)

    @property
    def is_dragged(self) -> bool:
        return self._dragged >= 0

    def show(self, arms, reaches, placement) -> None:
        """Arms as the native Blend tells them, in the coordinates of a placement; none: no arrows."""
        if len(arms) != len(self._arrows):
            for arrow in self._arrows:
                self._root.removeChild(arrow.root)
            self._arrows = [_Arrow() for _ in arms]
            for arrow in self._arrows:
                self._root.addChild(arrow.root)
            self._lit = self._dragged = -1
            self._mouse.want(self, False)
        for arrow, (point, vector), reach in zip(self._arrows, arms, reaches):
            arrow.show(placement.multVec(App.Vector(*point)), placement.Rotation.multVec(App.Vector(*vector)), reach)
        self._light(self._lit)

    def remove(self) -> None:
        if self._root is None:
            return
        try:
            self._mouse.want(self, False)
            for kind, callback in self._callbacks:
                self._view.removeEventCallbackPivy(kind, callback)
            self._view.getSceneGraph().removeChild(self._root)
        except RuntimeError:  # the view has been closed
            pass
        self._root = None

    def _scale(self, _, action) -> None:
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            for arrow in self._arrows:
                arrow.scale(TIP * self._mouse.pixel_size(arrow.tip))

    def _moved(self, node) -> None:
        event = node.getEvent()
        if self.is_dragged:
            node.setHandled()
            reach = self._reach_under(event) - self._grabbed
            self._on_drag(self._dragged, round(min(max(reach, SMALLEST), LARGEST), 2))
        else:
            under = self._under(event)
            if under != self._lit:
                self._light(under)
                self._mouse.want(self, under >= 0)

    def _button(self, node) -> None:
        event = node.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1:
            return
        if event.getState() == coin.SoButtonEvent.DOWN:
            self._dragged = self._under(event)
            if self.is_dragged:
                self._grabbed = self._reach_under(event) - self._arrows[self._dragged].reach
                self._light(self._dragged)
                Gui.Selection.clearPreselection()  # what lies behind stays as it is
                node.setHandled()
                node.grabEvents()  # neither selection nor navigation
        elif self.is_dragged:
            node.releaseEvents()
            node.setHandled()
            self._dragged = -1

    def _under(self, event) -> int:
        """The arrow whose tip lies under the mouse, -1 for none."""
        x, y = event.getPosition().getValue()
        for side, arrow in enumerate(self._arrows):
            tip = self._mouse.on_screen(arrow.tip)
            if (tip[0] - x) ** 2 + (tip[1] - y) ** 2 <= TIP ** 2:
                return side
        return -1

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

    def _light(self, side: int) -> None:
        self._lit = side
        for number, arrow in enumerate(self._arrows):
            arrow.light(number == side)


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

    def scale(self, length: float) -> None:
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
