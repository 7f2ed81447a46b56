# SPDX-License-Identifier: LGPL-2.1-or-later
"""View provider of a fill."""

from __future__ import annotations

from .. import settings
from ..paths import icon

EDIT_DEFAULT = 0  # FreeCAD's edit mode of a double-click


class FillView:
    def __init__(self, view_object):
        view_object.ShapeColor = settings.patch_color()
        FillView.attach_to(view_object, self)
        if view_object.Object.ResultMode == "base":
            view_object.Object.Edges[0].ViewObject.Visibility = False

    @staticmethod
    def attach_to(view_object, view=None) -> None:
        """Gives a view provider its proxy; the colours stay."""
        view_object.Proxy = view or FillView.__new__(FillView)

    def attach(self, view_object) -> None:
        self.object = view_object.Object

    def getIcon(self) -> str:
        return icon("Fairing_FillHole.svg")

    def claimChildren(self):
        """A fill that contains its base stands above it in the tree, as Part's operations do."""
        obj = getattr(self, "object", None)
        return [obj.Edges[0]] if obj and obj.Edges and obj.ResultMode == "base" else []

    def setEdit(self, view_object, mode: int = EDIT_DEFAULT):
        if mode != EDIT_DEFAULT:
            return None
        from ..panels.fill_panel import FillPanel

        return FillPanel.show(obj=view_object.Object)

    def unsetEdit(self, view_object, mode: int = EDIT_DEFAULT):
        import FreeCADGui as Gui

        Gui.Control.closeDialog()
        return True

    def doubleClicked(self, view_object) -> bool:
        import FreeCADGui as Gui

        if Gui.Control.activeDialog():
            return False
        Gui.getDocument(view_object.Object.Document.Name).setEdit(view_object.Object.Name)
        return True

    def onDelete(self, view_object, sub_elements) -> bool:
        obj = view_object.Object
        if obj.Edges and obj.ResultMode == "base":
            obj.Edges[0].ViewObject.Visibility = True
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads
