# SPDX-License-Identifier: LGPL-2.1-or-later
"""View provider of a fill."""

from __future__ import annotations

from .. import settings
from ..features import guide_objects
from ..paths import icon

EDIT_DEFAULT = 0  # FreeCAD's edit mode of a double-click


class FillView:
    ICON = "Fairing_FillHole.svg"

    def __init__(self, view_object):
        view_object.ShapeColor = settings.patch_color()
        self.attach_to(view_object, self)
        if self.replaces(view_object.Object):
            self._show_bases(view_object.Object, False)

    @classmethod
    def replaces(cls, obj) -> bool:
        """Whether the result stands for its bases, too."""
        return obj.ResultMode == "base"

    @staticmethod
    def bases_of(obj):
        """The objects a result in the mode "base" contains: the one whose hole is filled, if any."""
        return [obj.Edges[0]] if obj.Edges else []

    @staticmethod
    def open_panel(obj):
        from ..panels.fill_panel import FillPanel

        return FillPanel.show(obj=obj)

    @classmethod
    def attach_to(cls, view_object, view=None) -> None:
        """Gives a view provider its proxy; the colours stay."""
        view_object.Proxy = view or cls.__new__(cls)

    def attach(self, view_object) -> None:
        self.object = view_object.Object

    def getIcon(self) -> str:
        return icon(self.ICON)

    def claimChildren(self):
        """A fill stands above its guides in the tree, and above its base where it contains it, as Part's operations
        do."""
        obj = getattr(self, "object", None)
        if not obj:
            return []
        bases = self.bases_of(obj) if self.replaces(obj) else []
        return bases + self._guides_of(obj)

    def setEdit(self, view_object, mode: int = EDIT_DEFAULT):
        return self.open_panel(view_object.Object) if mode == EDIT_DEFAULT else None

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
        """Its bases are to be seen again; its guides, of no use without it, go with it."""
        obj = view_object.Object
        if self.replaces(obj):
            self._show_bases(obj, True)
        guide_objects.remove(self._guides_of(obj), obj)
        return True

    @staticmethod
    def _guides_of(obj) -> list:
        return list(obj.Guides) if "Guides" in obj.PropertiesList else []

    def _show_bases(self, obj, shown: bool) -> None:
        for base in self.bases_of(obj):
            base.ViewObject.Visibility = shown

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads
