# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse over what the panels put into the 3D view: where it points, and who gets it first."""

from __future__ import annotations

from pivy import coin

from .viewers import viewer_of, viewport_of

KEEPS_EVENTS = ("Inventor", "OpenSCAD")  # navigation styles that keep the mouse from the scene unless told otherwise


class SceneMouse:
    """Shared by all that takes clicks in one view: the scene gets the mouse before the navigation does while any of
    them wants it."""

    def __init__(self, view):
        self.view = view
        self._wanted: set[int] = set()

    def want(self, who, wants: bool) -> None:
        (self._wanted.add if wants else self._wanted.discard)(id(who))
        style = self.view.getNavigationType()
        viewer_of(self.view).setRedirectToSceneGraph(bool(self._wanted) or any(name in style for name in KEEPS_EVENTS))

    def view_volume(self):
        region = viewport_of(self.view)
        return self.view.getCameraNode().getViewVolume(region.getViewportAspectRatio())

    def on_screen(self, point) -> tuple[float, float]:
        """A point of the document in pixels."""
        width, height = viewport_of(self.view).getViewportSizePixels().getValue()
        x, y, _ = self.view_volume().projectToScreen(coin.SbVec3f(*point)).getValue()
        return x * width, y * height

    def is_near(self, event, point, pixels: float) -> bool:
        """Whether the mouse is so near to a point of the document."""
        x, y = event.getPosition().getValue()
        at = self.on_screen(point)
        return (at[0] - x) ** 2 + (at[1] - y) ** 2 <= pixels ** 2

    def ray(self, event, shift=(0.0, 0.0)) -> tuple[tuple, tuple]:
        """(start, direction) of the line of points under the mouse, or so many pixels beside it, in the document's
        coordinates."""
        size = viewport_of(self.view).getViewportSizePixels().getValue()
        x, y = ((at + by) / full for at, by, full in zip(event.getPosition().getValue(), shift, size))
        near, far = self.view_volume().projectPointToLine(coin.SbVec2f(x, y))
        return near.getValue(), (far - near).getValue()

    def pixel_size(self, point) -> float:
        """Millimetres of a pixel at a point."""
        height = viewport_of(self.view).getViewportSizePixels().getValue()[1]
        return self.view_volume().getWorldToScreenScale(coin.SbVec3f(*point), 1.0 / height)
