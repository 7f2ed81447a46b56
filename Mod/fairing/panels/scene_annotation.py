# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn above everything else in the 3D view and hears the mouse."""

from __future__ import annotations

from pivy import coin

from .scene_mouse import SceneMouse


class SceneAnnotation:
    """Nodes of their own below `_root`. Subclasses say in _button(node) and _moved(node) what the mouse does, and
    start() when they are ready."""

    def __init__(self, mouse: SceneMouse):
        self._mouse, self._view = mouse, mouse.view
        self._root = coin.SoAnnotation()

    def start(self) -> None:
        # removal goes by identity
        self._callbacks = ((coin.SoMouseButtonEvent.getClassTypeId(), self._button),
                           (coin.SoLocation2Event.getClassTypeId(), self._moved))
        self._view.getSceneGraph().addChild(self._root)
        for kind, callback in self._callbacks:
            self._view.addEventCallbackPivy(kind, callback)

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
