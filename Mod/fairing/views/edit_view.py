# SPDX-License-Identifier: LGPL-2.1-or-later
"""View provider of an edited face."""

from __future__ import annotations

from .fill_view import FillView


class EditView(FillView):
    ICON = "Fairing_EditSurface.svg"

    @staticmethod
    def bases_of(obj):
        return [obj.Face[0]] if obj.Face else []

    @classmethod
    def replaces(cls, obj) -> bool:
        """The base would hide the new face where it is the old one and no more."""
        return super().replaces(obj) or (bool(obj.Face) and len(obj.Face[0].Shape.Faces) == 1)

    @staticmethod
    def open_panel(obj):
        from ..panels.edit_panel import EditPanel

        return EditPanel.show(obj=obj)
