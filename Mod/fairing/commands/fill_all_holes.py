# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Fill All Holes."""

from __future__ import annotations

from .. import selection
from ..translation import NOOP


class FillAllHolesCommand:
    NAME = "Fairing_FillAllHoles"

    def GetResources(self) -> dict:
        return {
            "Pixmap": self.NAME,
            "MenuText": NOOP(self.NAME, "Fill All Holes"),
            "ToolTip": NOOP(self.NAME, "Fill every hole of the selected object with a surface that meets its "
                                       "neighbours smoothly"),
            "Accel": "F, A",
        }

    def IsActive(self) -> bool:
        """FreeCAD asks several times a second."""
        return selection.can_start(selection.current_base)

    def Activated(self) -> None:
        from ..panels.fill_all_panel import FillAllPanel

        FillAllPanel.show(base=selection.current_base())
