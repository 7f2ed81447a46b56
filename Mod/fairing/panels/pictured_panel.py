# SPDX-License-Identifier: LGPL-2.1-or-later
"""What task panels have in common that show the curvature of their surface and of its neighbours."""

from __future__ import annotations

import FreeCADGui as Gui
from PySide import QtGui

from .. import exchange, paths
from . import task_boxes
from .curvature_view import CurvatureView
from .solving_panel import SolvingPanel

PROGRESS_WIDTH = 24  # pixels: the row has other things to show
PICTURE_CELLS = 48  # along either direction of a patch: stripes are smooth to the eye


class PicturedPanel(SolvingPanel):
    """Subclasses call _draw_picture() with whatever native result is to be seen."""

    _has_folded = False
    _drawn = None  # the native result that is to be seen
    _beside: tuple = (None, ())  # what the pictures of the neighbours were made of, and they
    _knows_beside = False  # whether they are those of what is asked now

    def _set_up(self) -> None:
        super()._set_up()
        self._picture_ui = Gui.PySideUic.loadUi(paths.form("picture.ui"))
        self._curvature = CurvatureView(self._view, self._picture_ui)
        self._curvature.box.changed.connect(self._picture_changed)
        self._put_up_switch()

    def _put_up_switch(self) -> None:
        """In the row of what is drawn; the rest below it, where there is a picture."""
        ui, row = self._picture_ui, self._ui.findChild(QtGui.QHBoxLayout, "showLayout")
        self._show_row = row
        for label in (ui.pictureLabel, ui.facesLabel):
            label.hide()
        row.insertWidget(row.indexOf(self._ui.progressBar), ui.pictureCombo, 1)
        self._ui.progressBar.setFixedWidth(PROGRESS_WIDTH)
        getattr(self._ui, self.BOX).layout().addWidget(ui.pictureRows)
        ui.pictureRows.hide()

    def _needed_width(self) -> int:
        return max(super()._needed_width(), self._show_row.minimumSize().width())

    def _fold_limits(self) -> None:
        """Once, so that nothing scrolls: who wants them back unfolds them."""
        if not self._has_folded:
            self._has_folded = True
            task_boxes.fold(self.form[-1])

    def _start_anew(self) -> None:
        super()._start_anew()
        self._knows_beside = False

    def _draw_picture(self, native) -> None:
        """The curvature of a native result, None: there is none."""
        self._drawn = native
        is_seen = native is not None and self._curvature.is_on
        self._display.give_way(is_seen)
        if is_seen:
            self._curvature.show([native.curvature_picture(PICTURE_CELLS)], self._pictures_beside(native),
                                 self._session.placement)
        else:
            self._curvature.clear()

    def _picture_changed(self) -> None:
        if self._is_closed:
            return
        self._picture_ui.pictureRows.setVisible(self._curvature.is_on)
        if self._curvature.is_on:
            self._fold_limits()
        if self._curvature.is_on and not self._curvature.is_empty:
            self._curvature.paint()
        else:
            self._draw_picture(self._drawn)

    def _pictures_beside(self, native) -> tuple:
        """Of the faces it meets: they stay while it is guided."""
        if not self._knows_beside:
            brep, faces = self._session.neighbours(native.report)
            if self._beside[0] != (brep, faces):
                pictures = (exchange.native_shape_of(brep).curvature_picture(faces),) if faces else ()
                self._beside = (brep, faces), pictures
            self._knows_beside = True
        return self._beside[1]

    def _detach(self) -> None:
        if not self._is_closed:
            self._curvature.detach()
        super()._detach()

    def gone(self) -> None:
        if not self._is_closed:
            self._curvature.remove()
        super().gone()
