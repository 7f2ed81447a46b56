# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panels that says what guides the surface, how strongly, and how well it follows."""

from __future__ import annotations

from typing import Optional

import FreeCAD as App
from PySide import QtCore

from .. import selection, subelements
from ..features import links
from ..features.guides import FeatureCurve, NormalHandle, faces_beside, frozen_links, middle_of
from ..translation import translate
from .guide_fields import GuideFields
from .guide_list import GuideList
from .quantities import angle_text, length_text, percent_text
from .sliders import WeightSlider

FIRST_LAMBDA = 100.0  # what a first handle or curve starts with
RADIUS = 0.25  # of a new guide, in diagonals of the surface
DIGITS = 6  # of the numbers a new handle is written with


class GuidanceBox(QtCore.QObject):
    """Shows what guides a GuidedSession and writes the user's into it. Emits changed() where the surface has to be made
    anew, moved() where it is the same one under another guide, shown() when something else is to be drawn, and
    failed(sentence)."""

    changed = QtCore.Signal()
    moved = QtCore.Signal()
    shown = QtCore.Signal()
    failed = QtCore.Signal(str)

    def __init__(self, ui, session, takes_guides: bool = True):
        super().__init__(ui)
        self._ui, self._session, self._diagonal = ui, session, 0.0
        self.normal_near = lambda point: (0.0, 0.0, 1.0)  # of the surface, what a curve without faces starts with
        self._list, self._fields = GuideList(ui, session), GuideFields(ui, session)
        self._lambda = WeightSlider(ui.lambdaSlider, ui.lambdaSpin, session.request.lambda_)
        self._gamma = WeightSlider(ui.gammaSlider, ui.gammaSpin, session.request.gamma)
        for widget in (ui.normalButton, ui.curveButton, ui.fieldCheck, ui.netCheck):
            widget.setVisible(takes_guides)
        self._connect()
        self.show()
        self.show_report(None)

    @property
    def is_placing(self) -> bool:
        """Whether a click on the surface is to make a handle."""
        return self._ui.normalButton.isChecked()

    @property
    def is_picking(self) -> bool:
        """Whether what is picked in the 3D view belongs here."""
        return self._ui.curveButton.isChecked() or self._ui.referenceButton.isChecked() or self._fields.is_picking

    @property
    def position(self) -> int:
        """Of the selected handle or curve, -1 for none."""
        return self._list.position

    @property
    def shows_field(self) -> bool:
        return self._ui.fieldCheck.isChecked()

    @property
    def shows_net(self) -> bool:
        return self._ui.netCheck.isChecked()

    def picked(self, obj: App.DocumentObject, name: str) -> None:
        ui = self._ui
        try:
            if self._fields.is_picking:
                self._fields.picked(obj, name)
            elif ui.referenceButton.isChecked():
                self._add_reference(obj, name)
            elif ui.curveButton.isChecked():
                self._add_curve(obj, name)
        except ValueError as error:
            self.failed.emit(str(error))

    def place(self, point, normal) -> None:
        """A new handle on the surface."""
        self._ui.normalButton.setChecked(False)
        self._add(NormalHandle(_rounded(point), _rounded(normal), self._radius()))

    def turn(self, position: int, **changes) -> None:
        """A handle was dragged. One that is turned takes its direction from nothing any more."""
        changes = {name: _rounded(value) for name, value in changes.items()}
        self._session.change_guide(position, **changes, **({"direction": ()} if "normal" in changes else {}))
        self._fields.show(position)
        self._list.rename(position)
        self.moved.emit()

    def select(self, position: int) -> None:
        self._list.select(position)

    def show(self) -> None:
        """What guides, and what makes sense for it."""
        session = self._session
        self._list.show()
        self._ui.weightsRow.setVisible(session.is_guided)
        self._lambda.set_enabled(session.is_guided)
        self._gamma.set_enabled(session.has_points)

    def show_report(self, report: Optional[dict], guidance: Optional[dict] = None, energy: float = 0.0) -> None:
        """How well the surface follows, and what that costs."""
        if report:
            self._diagonal = report["diagonal"]
        for button in (self._ui.normalButton, self._ui.curveButton):
            button.setEnabled(self._diagonal > 0.0)  # there has been a surface
        self.show_followed(guidance, energy)
        self._ui.followLabel.setVisible(self._session.is_guided)

    def show_followed(self, guidance: Optional[dict], energy: float) -> None:
        """The same while something is dragged."""
        self._ui.followLabel.setText(follow_text(guidance, energy, bool(self._session.reference)))

    def _connect(self) -> None:
        ui = self._ui
        self._list.selected.connect(self._select)
        self._list.removed.connect(self._removed)
        self._fields.changed.connect(self._fields_changed)
        self._fields.failed.connect(self.failed)
        for name, slider in (("lambda_", self._lambda), ("gamma", self._gamma)):
            slider.changed.connect(lambda value, name=name: self._weigh(**{name: value}))
        for button in self._buttons():
            button.toggled.connect(lambda on, button=button: self._toggled(button, on))
        for check in (ui.fieldCheck, ui.netCheck):
            check.toggled.connect(lambda *_: self.shown.emit())

    def _buttons(self):
        ui = self._ui
        return ui.normalButton, ui.curveButton, ui.referenceButton, ui.directionButton

    def _toggled(self, button, on: bool) -> None:
        """One thing is picked at a time."""
        if on:
            for other in self._buttons():
                other.setChecked(other is button)
            hints = (translate("Fairing", "Click on the surface where it is to have a normal."),
                     translate("Fairing", "Pick an edge, or a sketch, for the surface to follow."),
                     translate("Fairing", "Pick a face, a mesh or an object that the surface is to be like."),
                     translate("Fairing", "Pick a face, an edge or a datum with the direction."))
            selection.tell(hints[self._buttons().index(button)])
        else:
            selection.tell("")
        self.shown.emit()

    def _select(self, position: int) -> None:
        self._fields.show(position)
        self.shown.emit()

    def _fields_changed(self, position: int) -> None:
        self._list.rename(position)
        self.moved.emit()

    def _weigh(self, **weight) -> None:
        self._session.change(**weight)
        self.moved.emit()

    def _removed(self, is_reference: bool) -> None:
        self.show()
        (self.changed if is_reference else self.moved).emit()

    def _add_reference(self, obj: App.DocumentObject, name: str) -> None:
        if name and not subelements.is_face(name) and not links.is_mesh(obj):
            return
        self._session.set_reference(self._session.reference
                                    + [(obj, [name] if subelements.is_face(name) else [])])
        self._ui.referenceButton.setChecked(False)
        self.show()
        self.changed.emit()

    def _add_curve(self, obj: App.DocumentObject, name: str) -> None:
        if name and not subelements.is_edge(name):
            return
        self._ui.curveButton.setChecked(False)
        curve, container = frozen_links((obj, [name] if name else [])), self._session.container
        normal = None if faces_beside(curve, container) else _rounded(self.normal_near(middle_of(curve, container)))
        self._add(FeatureCurve(curve, self._radius(), normal=normal))

    def _add(self, guide) -> None:
        session = self._session
        session.set_guides(session.guides + (guide,))
        if session.request.lambda_ == 0.0:
            session.change(lambda_=FIRST_LAMBDA)
            self._lambda.show(FIRST_LAMBDA)
        self._list.show(len(session.guides) - 1)
        self.show()
        self.moved.emit()

    def _radius(self) -> float:
        return float(f"{RADIUS * self._diagonal:.2g}")


def follow_text(guidance: Optional[dict], energy: float, has_reference: bool) -> str:
    """How well a surface follows its guide, in a line. Without a reference its points are those of the face edited."""
    if guidance is None:
        return ""
    parts = []
    if guidance["normals"]:
        parts.append(translate("Fairing", "Follows within {0} rms, {1} at most").format(
            angle_text(guidance["rms_angle"]), angle_text(guidance["largest_angle"])))
    if guidance["points"]:
        apart = (translate("Fairing", "{0} from the reference") if has_reference
                 else translate("Fairing", "{0} from the face as it was"))
        parts.append(apart.format(length_text(guidance["rms_distance"])))
    if guidance["covered"] < 1.0:
        parts.append(translate("Fairing", "it covers {0}").format(percent_text(guidance["covered"])))
    parts.append(translate("Fairing", "energy {0}").format(f"{energy:.0f}" if energy >= 1000.0 else f"{energy:.3g}"))
    return "; ".join(parts)


def _rounded(numbers):
    return tuple(round(float(number), DIGITS) + 0.0 for number in numbers)
