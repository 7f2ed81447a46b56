# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of Curvature Picture: look at any faces; closing it takes the picture away."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import exchange, native, paths, selection, subelements
from ..features.placement import shape_in
from ..pictures import PICTURES
from ..translation import translate
from . import opening, task_boxes
from .background import BackgroundSolver
from .curvature_view import CurvatureView
from .message import show_problem
from .picking import ClosingDocument, EscapeKey

DIVISIONS = 80  # of the diagonal of what is seen: longer edges of triangles are split


class CurvaturePanel:
    """Shows what is selected; another selection while it is open is shown in its place."""

    @classmethod
    def show(cls, picks, picture: str = "mean") -> bool:
        """Opens the panel on [(object, face names; none: the whole object)] with one of PICTURES. False, with a
        message, where that cannot be. Raises ValueError for another word."""
        if picture not in PICTURES:
            raise ValueError(f"{picture!r} is no picture: {', '.join(PICTURES)} are.")
        problem = opening.obstacle()
        if problem:
            show_problem(problem)
            return False
        opening.put_up(cls(App.ActiveDocument, picks, picture))
        return True

    def __init__(self, document: App.Document, picks, picture: str):
        self._document, self._is_closed = document, False
        self._are_closed: list[bool] = []  # which of the pictures are on solids
        self._ui = Gui.PySideUic.loadUi(paths.form("picture.ui"))
        self.form = [self._ui.pictureRows]
        self.form[0].setWindowIcon(QtGui.QIcon(paths.icon("Fairing_CurvaturePicture.svg")))
        self._view = Gui.getDocument(document.Name).ActiveView
        self._solver = BackgroundSolver(native.module().Progress, self._made, lambda fraction: None, self._ui)
        self._curvature = CurvatureView(self._view, self._ui)
        self._curvature.box.picture = picture
        self._curvature.box.changed.connect(self._curvature.paint)
        self._escape = EscapeKey(self._view, self._close)
        self._closing = ClosingDocument(document, self._document_closed)
        Gui.Selection.clearSelection()
        Gui.Selection.addObserver(self)
        self._look_at(picks)

    # --- called by FreeCAD ---

    def getStandardButtons(self):
        try:
            return int(QtGui.QDialogButtonBox.Close)  # PySide2; FreeCAD 0.20 insists on it
        except TypeError:
            return QtGui.QDialogButtonBox.Close  # PySide6

    def reject(self) -> bool:
        self._close()
        return True

    def addSelection(self, document: str, obj: str, sub: str, point) -> None:
        if document == self._document.Name:
            QtCore.QTimer.singleShot(0, self._selected)  # FreeCAD is still busy with its own selection here

    # --- its own ---

    def _selected(self) -> None:
        if not self._is_closed and Gui.Selection.hasSelection():
            picks = selection.current_shapes()
            if picks:
                self._look_at(picks)

    def _look_at(self, picks) -> None:
        """Has the pictures made."""
        self._say(", ".join(f"{obj.Label}: {', '.join(names)}" if names else obj.Label for obj, names in picks))
        shapes = [(shape_in(None, obj), list(subelements.face_numbers(names))) for obj, names in picks]
        shapes = [(shape, faces) for shape, faces in shapes if not shape.isNull()]
        self._are_closed = [bool(shape.Solids) for shape, _ in shapes]
        asked = [(exchange.data_of(shape), faces) for shape, faces in shapes]
        self._solver.request(lambda progress: [exchange.native_shape_of(brep).curvature_picture(faces, DIVISIONS)
                                               for brep, faces in asked])

    def _made(self, pictures, error) -> None:
        if error is not None:
            self._curvature.clear()
            self._say(str(error))
        elif not any(len(picture.mesh()[2]) for picture in pictures):
            self._curvature.clear()
            self._say(translate("Fairing", "What is selected has no faces with a surface."))
        else:
            self._curvature.show(pictures, are_closed=self._are_closed)

    def _say(self, text: str) -> None:
        self._ui.facesLabel.setText(text)

    def gone(self) -> None:
        """Takes away the picture, and listens no longer."""
        if not self._is_closed:
            self._curvature.remove()
            self._detach()

    def make_room(self) -> None:
        if not self._is_closed:
            task_boxes.make_room(self.form[0])

    def _close(self) -> None:
        if not self._is_closed:
            self.gone()
            Gui.Control.closeDialog()

    def _document_closed(self) -> None:
        self._curvature.detach()
        self._detach()
        QtCore.QTimer.singleShot(0, Gui.Control.closeDialog)

    def _detach(self) -> None:
        if self._is_closed:
            return
        self._is_closed = True
        self._solver.finish()
        self._closing.stop()
        self._escape.stop()
        Gui.Selection.removeObserver(self)
