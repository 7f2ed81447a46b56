# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the mouse can drag in the 3D view. Coin's own draggers crash FreeCAD when Python listens to them, so these are
plain nodes and the view's event callbacks."""

from __future__ import annotations

import FreeCADGui as Gui
from pivy import coin

from .scene_annotation import SceneAnnotation
from .scene_mouse import SceneMouse

NOTHING = -1


class SceneHandles(SceneAnnotation):
    """Arrows drawn above everything else, of which one at a time is grabbed; all other clicks do what they always do.
    Subclasses say what lies under the mouse and what dragging it does; an arrow has root, light(lit) and
    scale(mouse), which is called before it is drawn."""

    def __init__(self, mouse: SceneMouse):
        super().__init__(mouse)
        self._arrows: list = []
        self._lit = self._dragged = NOTHING
        self._holds = False  # the mouse, until it is released
        scaling = coin.SoCallback()
        self._rescale = self._scale  # Coin keeps no reference
        scaling.setCallback(self._rescale, None)
        self._root.addChild(scaling)
        self.start()

    # --- subclasses ---

    def _under(self, event) -> int:
        """The number of what lies under the mouse, NOTHING for none."""
        raise NotImplementedError

    def _grab(self, event) -> None:
        """The mouse was pressed on `_dragged`."""

    def _drag(self, event) -> None:
        raise NotImplementedError

    def _pressed_beside(self, event) -> bool:
        """The mouse was pressed on nothing of these; whether that is taken."""
        return False

    # --- all of them ---

    @property
    def is_dragged(self) -> bool:
        return self._dragged != NOTHING

    def _make(self, count: int, make) -> None:
        """So many arrows, made anew where there are more or fewer."""
        if count == len(self._arrows):
            return
        for arrow in self._arrows:
            self._root.removeChild(arrow.root)
        self._arrows = [make() for _ in range(count)]
        for arrow in self._arrows:
            self._root.addChild(arrow.root)
        self._lit = self._dragged = NOTHING
        self._want()

    def _want(self) -> None:
        self._mouse.want(self, self._lit != NOTHING)

    def _scale(self, _, action) -> None:
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            for arrow in self._arrows:
                arrow.scale(self._mouse)

    def _moved(self, node) -> None:
        event = node.getEvent()
        if self.is_dragged:
            node.setHandled()
            self._drag(event)
            return
        under = self._under(event)
        if under != self._lit:
            self._light(under)
            self._want()

    def _button(self, node) -> None:
        event = node.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1:
            return
        if event.getState() == coin.SoButtonEvent.DOWN:
            self._dragged = self._under(event)
            if self.is_dragged:
                self._grab(event)
                self._light(self._dragged)
                Gui.Selection.clearPreselection()  # what lies behind stays as it is
            elif not self._pressed_beside(event):
                return
            node.setHandled()
            node.grabEvents()  # neither selection nor navigation
            self._holds = True
        elif self._holds:
            node.releaseEvents()
            node.setHandled()
            self._dragged, self._holds = NOTHING, False

    def _light(self, lit: int) -> None:
        self._lit = lit
        for number, arrow in enumerate(self._arrows):
            arrow.light(number == lit)
