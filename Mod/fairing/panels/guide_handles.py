# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrows in the 3D view for normal handles: drag the tip to turn the normal, the foot to move it over the surface."""

from __future__ import annotations

import math
from typing import Callable

import FreeCAD as App
import numpy as np
from pivy import coin

from .mesh_hit import first_hit
from .scene_handles import NOTHING, SceneHandles
from .scene_mouse import SceneMouse

LENGTH = 64.0  # pixels, of an arrow
TIP, FOOT = 13.0, 9.0  # pixels, radii within which the mouse grabs either end
LINE_WIDTH = 3.0  # pixels
CIRCLE_SIDES = 64
COLOR, CHOSEN, LIT = (0.80, 0.25, 0.15), (0.95, 0.45, 0.05), (1.0, 0.70, 0.20)


class GuideHandles(SceneHandles):
    """One arrow a handle. The panel sets on_turn(position, changes), called while one is dragged with what changes of
    the handle, on_choose(position), called when one is grabbed, and on_place(point, normal), called for a click on
    the surface while is_placing; all in the coordinates of the session."""

    def __init__(self, mouse: SceneMouse):
        self.on_turn: Callable[[int, dict], None] = lambda position, changes: None
        self.on_choose: Callable[[int], None] = lambda position: None
        self.on_place: Callable[[tuple, tuple], None] = lambda point, normal: None
        self._is_placing = False
        self._placement, self._mesh = App.Placement(), None
        self._positions: list[int] = []  # of the handles among the guides
        self._shift, self._is_front = (0.0, 0.0), True  # from the mouse to what it grabbed; the side it was grabbed on
        super().__init__(mouse)

    @property
    def is_placing(self) -> bool:
        return self._is_placing

    @is_placing.setter
    def is_placing(self, placing: bool) -> None:
        self._is_placing = placing
        self._want()

    def show(self, handles, chosen: int, placement: App.Placement) -> None:
        """(position, point, normal, radius) of every handle, and the position of the one that stands out."""
        self._placement, self._positions = placement, [position for position, *_ in handles]
        self._make(len(handles), _Arrow)
        for arrow, (position, point, normal, radius) in zip(self._arrows, handles):
            arrow.show(placement.multVec(App.Vector(*point)), placement.Rotation.multVec(App.Vector(*normal)),
                       radius, position == chosen)
        self._light(self._lit)

    def use_mesh(self, mesh) -> None:
        """The surface that clicks and feet meet, None for none."""
        self._mesh = mesh

    def normal_near(self, point) -> tuple:
        """Of the surface at its corner of the mesh that is nearest to a point. Raises ValueError without a surface."""
        if self._mesh is None:
            raise ValueError("There is no surface yet to take a normal from: wait for it, or give it what it lacks.")
        points, normals, _ = self._mesh
        return tuple(normals[np.argmin(np.linalg.norm(points - np.asarray(point), axis=1))])

    def _want(self) -> None:
        self._mouse.want(self, self._lit != NOTHING or self._is_placing)

    def _under(self, event) -> int:
        """Twice the arrow's number for its tip, one more for its foot."""
        for number, arrow in enumerate(self._arrows):
            if self._mouse.is_near(event, arrow.tip(self._mouse), TIP):
                return 2 * number
            if self._mouse.is_near(event, arrow.point, FOOT):
                return 2 * number + 1
        return NOTHING

    def _light(self, lit: int) -> None:
        self._lit = lit
        for number, arrow in enumerate(self._arrows):
            arrow.light(lit != NOTHING and number == lit // 2)

    def _grab(self, event) -> None:
        arrow, is_foot = self._arrows[self._dragged // 2], self._dragged % 2
        grabbed = self._mouse.on_screen(arrow.point if is_foot else arrow.tip(self._mouse))
        self._shift = tuple(there - here for there, here in zip(grabbed, event.getPosition().getValue()))
        self._is_front = arrow.normal.dot(App.Vector(*self._mouse.ray(event)[1])) <= 0.0
        self.on_choose(self._positions[self._dragged // 2])

    def _drag(self, event) -> None:
        number, ray = self._dragged // 2, self._mouse.ray(event, self._shift)
        if self._dragged % 2:
            met = self._hit(ray)
            changes = {"point": tuple(met[0])} if met else {}
        else:
            changes = {"normal": tuple(self._to_session(self._direction(self._arrows[number], ray)))}
        if changes:
            self.on_turn(self._positions[number], changes)

    def _pressed_beside(self, event) -> bool:
        if not self._is_placing:
            return False
        met = self._hit(self._mouse.ray(event))
        if met:
            self.on_place(*met)
        return True

    def _direction(self, arrow, ray) -> App.Vector:
        """From the foot to where the line of sight meets the sphere of the tip, its silhouette where it passes by."""
        start, along = (App.Vector(*item) for item in ray)
        along.normalize()
        from_foot, radius = start - arrow.point, arrow.length(self._mouse)
        middle = -from_foot.dot(along)
        depth = radius ** 2 - (from_foot + along * middle).dot(from_foot + along * middle)
        if depth > 0.0:
            middle += -math.sqrt(depth) if self._is_front else math.sqrt(depth)
        return (from_foot + along * middle).normalize()

    def _hit(self, ray):
        if self._mesh is None:
            return None
        inverse = self._placement.inverse()
        return first_hit(self._mesh, tuple(inverse.multVec(App.Vector(*ray[0]))),
                         tuple(self._to_session(App.Vector(*ray[1]))))

    def _to_session(self, vector: App.Vector) -> App.Vector:
        return self._placement.inverse().Rotation.multVec(vector)


class _Arrow:
    """A ball at the foot, a line and a head, all of constant size; round the chosen one's foot a circle where it has
    faded to nothing."""

    def __init__(self):
        self.point, self.normal = App.Vector(), App.Vector(0, 0, 1)
        self._is_chosen = False
        self.root = coin.SoSeparator()
        self._color, self._place, self._size = coin.SoBaseColor(), coin.SoTransform(), coin.SoScale()
        light, style, hidden = coin.SoLightModel(), coin.SoDrawStyle(), coin.SoPickStyle()
        light.model, style.lineWidth = coin.SoLightModel.BASE_COLOR, LINE_WIDTH
        hidden.style = coin.SoPickStyle.UNPICKABLE
        points, line, ball, up, head = (coin.SoCoordinate3(), coin.SoLineSet(), coin.SoSphere(), coin.SoTranslation(),
                                        coin.SoCone())
        points.point.setValues(0, 2, [(0, 0, 0), (0, 1, 0)])
        line.numVertices.setValue(2)
        ball.radius = 0.07
        up.translation = (0, 0.94, 0)
        head.bottomRadius, head.height = 0.09, 0.24
        constant = coin.SoSeparator()
        for node in (self._size, points, line, ball, up, head):
            constant.addChild(node)
        self._circle, self._reach, ring, thin = coin.SoSwitch(), coin.SoScale(), coin.SoSeparator(), coin.SoDrawStyle()
        thin.lineWidth = 1.0
        for node in (thin, self._reach, *_unit_circle()):
            ring.addChild(node)
        self._circle.addChild(ring)
        for node in (hidden, light, style, self._color, self._place, constant, self._circle):
            self.root.addChild(node)

    def show(self, point: App.Vector, normal: App.Vector, radius: float, is_chosen: bool) -> None:
        self.point, self._is_chosen = point, is_chosen
        self._circle.whichChild = coin.SO_SWITCH_ALL if is_chosen and radius > 0.0 else coin.SO_SWITCH_NONE
        if radius > 0.0:
            self._reach.scaleFactor = (radius, radius, radius)
        if normal.Length > 0.0:
            self.normal = App.Vector(normal).normalize()
        self._place.translation = tuple(point)
        self._place.rotation = coin.SbRotation(coin.SbVec3f(0, 1, 0), coin.SbVec3f(*self.normal))

    def light(self, lit: bool) -> None:
        self._color.rgb = LIT if lit else CHOSEN if self._is_chosen else COLOR

    def length(self, mouse: SceneMouse) -> float:
        """In mm, as it is now on the screen."""
        return LENGTH * mouse.pixel_size(self.point)

    def tip(self, mouse: SceneMouse) -> App.Vector:
        return self.point + self.normal * self.length(mouse)

    def scale(self, mouse: SceneMouse) -> None:
        length = self.length(mouse)
        if abs(length - self._size.scaleFactor.getValue()[0]) > 1e-5 * length:
            self._size.scaleFactor = (length, length, length)


def _unit_circle():
    """Round the y axis."""
    points, line = coin.SoCoordinate3(), coin.SoLineSet()
    angles = [2.0 * math.pi * k / CIRCLE_SIDES for k in range(CIRCLE_SIDES + 1)]
    points.point.setValues(0, len(angles), [(math.cos(a), 0.0, math.sin(a)) for a in angles])
    line.numVertices.setValue(len(angles))
    return points, line
