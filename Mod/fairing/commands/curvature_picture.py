# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Curvature Picture."""

from __future__ import annotations

from .. import selection
from ..translation import NOOP


class CurvaturePictureCommand:
    NAME = "Fairing_CurvaturePicture"

    def GetResources(self) -> dict:
        return {
            "Pixmap": self.NAME,
            "MenuText": NOOP(self.NAME, "Curvature Picture"),
            "ToolTip": NOOP(self.NAME, "Show the curvature of faces in colours, or the stripes that light lines leave on "
                                       "them, and read its values: select faces or objects, or nothing for all that is "
                                       "visible"),
            "Accel": "F, C",
        }

    def IsActive(self) -> bool:
        """FreeCAD asks several times a second."""
        return selection.can_start(selection.current_shapes)

    def Activated(self) -> None:
        from ..panels.commands import link_command, run

        run(f"fairing.show_curvature([{', '.join(map(link_command, selection.current_shapes()))}])")
