# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Fill Hole."""

from __future__ import annotations

from .. import selection
from ..translation import NOOP


class FillHoleCommand:
    NAME = "Fairing_FillHole"

    def GetResources(self) -> dict:
        return {
            "Pixmap": self.NAME,
            "MenuText": NOOP(self.NAME, "Fill Hole"),
            "ToolTip": NOOP(self.NAME, "Fill a hole with a surface that meets its neighbours smoothly: "
                                       "pick one edge of the hole, or the face to be replaced"),
            "Accel": "F, H",
        }

    def IsActive(self) -> bool:
        """FreeCAD asks several times a second."""
        return selection.can_start(selection.current_picks)

    def Activated(self) -> None:
        from ..panels.fill_panel import FillPanel

        FillPanel.show(picks=selection.current_picks())
