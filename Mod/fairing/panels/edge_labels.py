# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels on the edges in the 3D view: how the surface meets each, with the number where it does not."""

from __future__ import annotations

import dataclasses
from typing import Callable

from pivy import coin

from .scene_annotation import SceneAnnotation
from .scene_mouse import SceneMouse
from .viewers import viewport_of

TEXT_SIZE = 13  # pixels
PICK_RADIUS = 3.0  # pixels


@dataclasses.dataclass(frozen=True)
class Label:
    edge: int
    point: tuple[float, float, float]
    text: str
    color: tuple[float, float, float]


class EdgeLabels(SceneAnnotation):
    """Boxes of constant size that take clicks; everything else in the view works as always.

    on_click(edge, with_shift) when one is clicked, on_hover(edge) when the mouse comes over one.
    """

    def __init__(self, mouse: SceneMouse, on_click: Callable[[int, bool], None], on_hover: Callable[[int], None]):
        super().__init__(mouse)
        self._on_click, self._on_hover = on_click, on_hover
        self._transform = coin.SoTransform()
        self._root.addChild(self._transform)
        self._labels: list[Label] = []
        self._boxes: dict[int, coin.SoSeparator] = {}
        self._pressed = self._hovered = 0
        self.start()

    def place(self, placement) -> None:
        """From the coordinates of the labels to the document's."""
        self._transform.translation = tuple(placement.Base)
        self._transform.rotation = coin.SbRotation(*placement.Rotation.Q)

    def show(self, labels: list[Label]) -> None:
        if labels == self._labels:
            return
        self._labels = labels
        self._root.removeAllChildren()
        self._root.addChild(self._transform)
        self._boxes = {label.edge: _box(label) for label in labels}
        for box in self._boxes.values():
            self._root.addChild(box)

    def _moved(self, node) -> None:
        edge = self._edge_under(node.getEvent())
        if edge == self._hovered:
            return
        self._hovered = edge
        self._mouse.want(self, edge != 0)
        if edge:
            self._on_hover(edge)

    def _button(self, node) -> None:
        event = node.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1 or node.isHandled():
            return
        if event.getState() == coin.SoButtonEvent.DOWN:
            self._pressed = self._edge_under(event)
            if self._pressed:
                node.setHandled()
                node.grabEvents()  # neither selection nor navigation
        elif self._pressed:
            node.releaseEvents()
            node.setHandled()
            pressed, self._pressed = self._pressed, 0
            if self._edge_under(event) == pressed:
                self._on_click(pressed, event.wasShiftDown())

    def _edge_under(self, event) -> int:
        """The edge whose label lies under the mouse, 0 for none. Looks at the labels only: 0.1 ms."""
        if not self._boxes:
            return 0
        scene = coin.SoSeparator()
        scene.ref()
        scene.addChild(self._view.getCameraNode())
        scene.addChild(self._root)
        action = coin.SoRayPickAction(viewport_of(self._view))
        action.setPoint(event.getPosition())
        action.setRadius(PICK_RADIUS)
        action.apply(scene)
        picked = action.getPickedPoint()
        edges = [edge for edge, box in self._boxes.items() if picked and picked.getPath().containsNode(box)]
        scene.unref()
        return edges[0] if edges else 0


def _box(label: Label):
    root, place = coin.SoSeparator(), coin.SoTranslation()
    place.translation = label.point
    box = coin.SoType.fromName("SoFrameLabel").createInstance()
    box.getField("string").setValue(label.text)
    box.getField("size").setValue(TEXT_SIZE)
    box.getField("textColor").setValue(coin.SbColor(1.0, 1.0, 1.0))
    box.getField("backgroundColor").setValue(coin.SbColor(*label.color))
    box.vertAlignment = coin.SoImage.HALF
    box.horAlignment = coin.SoImage.CENTER
    root.addChild(place)
    root.addChild(box)
    return root
