# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Blend Faces."""

from __future__ import annotations

from .. import native, selection
from ..features.blend_picks import two_sides
from ..translation import NOOP, translate


class BlendFacesCommand:
    NAME = "Fairing_BlendFaces"

    def GetResources(self) -> dict:
        return {
            "Pixmap": self.NAME,
            "MenuText": NOOP(self.NAME, "Blend Faces"),
            "ToolTip": NOOP(self.NAME, "Join two edges with a surface that leaves the faces beside them smoothly: "
                                       "select the edge it starts from, then the edge it ends at"),
            "Accel": "F, B",
        }

    def IsActive(self) -> bool:
        """FreeCAD asks several times a second."""
        return selection.can_start(selection.current_edges)

    def Activated(self) -> None:
        from ..panels.blend_panel import BlendPanel
        from ..panels.message import show_problem

        try:
            picks = [] if native.problem() else selection.current_edges()
            sides = two_sides(picks) if picks else ()
        except ValueError as error:
            show_problem(str(error), translate(self.NAME, "The edges cannot be joined"))
        else:
            BlendPanel.show(sides)
