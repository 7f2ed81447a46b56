# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Edit Surface."""

from __future__ import annotations

from .. import selection
from ..translation import NOOP


class EditSurfaceCommand:
    NAME = "Fairing_EditSurface"

    def GetResources(self) -> dict:
        return {
            "Pixmap": self.NAME,
            "MenuText": NOOP(self.NAME, "Edit Surface"),
            "ToolTip": NOOP(self.NAME, "Shape a face anew by normals, curves and other surfaces, its border kept: "
                                       "pick the face"),
            "Accel": "F, E",
        }

    def IsActive(self) -> bool:
        """FreeCAD asks several times a second."""
        return selection.can_start(selection.current_face)

    def Activated(self) -> None:
        from ..panels.edit_panel import EditPanel

        EditPanel.show(picks=selection.current_face())
