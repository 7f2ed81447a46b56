# SPDX-License-Identifier: LGPL-2.1-or-later
"""View providers of normal handles and feature curves: arrows along their normals, and how far a handle reaches."""

from __future__ import annotations

import math

import FreeCAD as App
from pivy import coin

from ..paths import icon

LENGTH = 0.5  # of an arrow, in radii
HEAD = 0.3  # of it, the length of its head
CIRCLE_SIDES = 48
MODE = "Arrows"
COLOR = (0.80, 0.25, 0.15)
LINE_WIDTH = 2.0  # pixels


class GuideView:
    """Draws (point, normal) pairs as arrows, and lines beside them; subclasses say which."""

    ICON = ""

    @classmethod
    def attach_to(cls, view_object) -> None:
        """Gives a view provider its proxy."""
        view_object.Proxy = cls()

    def arrows(self, obj) -> list[tuple[App.Vector, App.Vector]]:
        raise NotImplementedError

    def lines(self, obj) -> list[list[App.Vector]]:
        raise NotImplementedError

    def attach(self, view_object) -> None:
        self.object = view_object.Object
        self._root, self._shapes = coin.SoSeparator(), coin.SoSeparator()
        color, style = coin.SoBaseColor(), coin.SoDrawStyle()
        color.rgb, style.lineWidth = COLOR, LINE_WIDTH
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        for node in (light, color, style, self._shapes):
            self._root.addChild(node)
        view_object.addDisplayMode(self._root, MODE)
        self._draw()

    def updateData(self, obj, name: str) -> None:
        if hasattr(self, "_shapes") and name in ("Position", "Normal", "Radius", "Points", "Normals"):
            self._draw()

    def getDisplayModes(self, view_object):
        return [MODE]

    def getDefaultDisplayMode(self) -> str:
        return MODE

    def setDisplayMode(self, mode: str) -> str:
        return mode

    def getIcon(self) -> str:
        return icon(self.ICON)

    def doubleClicked(self, view_object) -> bool:
        """Opens the panel of what it guides."""
        for guided in view_object.Object.InList:
            if "Guides" in guided.PropertiesList:
                return guided.ViewObject.Proxy.doubleClicked(guided.ViewObject)
        return False

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads

    def _draw(self) -> None:
        self._shapes.removeAllChildren()
        length = LENGTH * self.object.Radius.Value
        for point, normal in self.arrows(self.object):
            if normal.Length > 0.0 and length > 0.0:
                self._shapes.addChild(_arrow(point, normal, length))
        lines = [line for line in self.lines(self.object) if line]
        if lines:
            self._shapes.addChild(_polylines(lines))


class NormalHandleView(GuideView):
    ICON = "Fairing_NormalHandle.svg"

    def arrows(self, obj):
        return [(obj.Position, obj.Normal)]

    def lines(self, obj):
        """The circle round the handle's foot where it has faded to nothing."""
        if obj.Normal.Length == 0.0:
            return []
        turn = App.Rotation(App.Vector(0, 0, 1), obj.Normal)
        angles = [2.0 * math.pi * k / CIRCLE_SIDES for k in range(CIRCLE_SIDES + 1)]
        return [[obj.Position + turn.multVec(App.Vector(math.cos(a), math.sin(a), 0)) * obj.Radius.Value for a in angles]]


class FeatureCurveView(GuideView):
    ICON = "Fairing_FeatureCurve.svg"

    def arrows(self, obj):
        return list(zip(obj.Points, obj.Normals))

    def lines(self, obj):
        return []


VIEWS = {"NormalHandle": NormalHandleView, "FeatureCurve": FeatureCurveView}


def _arrow(point: App.Vector, normal: App.Vector, length: float) -> coin.SoSeparator:
    root, place, head = coin.SoSeparator(), coin.SoTransform(), coin.SoCone()
    tip = point + App.Vector(normal).normalize() * length
    head.height, head.bottomRadius = HEAD * length, 0.4 * HEAD * length
    place.translation = tuple(tip)
    place.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), coin.SbVec3f(*normal))
    root.addChild(_polylines([[point, tip]]))
    root.addChild(place)
    root.addChild(head)
    return root


def _polylines(lines) -> coin.SoSeparator:
    root, points, strips = coin.SoSeparator(), coin.SoCoordinate3(), coin.SoLineSet()
    points.point.setValues(0, sum(map(len, lines)), [tuple(point) for line in lines for point in line])
    strips.numVertices.setValues(0, len(lines), list(map(len, lines)))
    root.addChild(points)
    root.addChild(strips)
    return root
