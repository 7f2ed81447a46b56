# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Reconnect Fills."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..features import reconnect
from ..translation import NOOP


class ReconnectCommand:
    NAME = "Fairing_Reconnect"

    def GetResources(self) -> dict:
        return {
            "Pixmap": self.NAME,
            "MenuText": NOOP(self.NAME, "Reconnect Fills"),
            "ToolTip": NOOP(self.NAME, "Make fills compute again that were saved by a FreeCAD without Fairing"),
        }

    def IsActive(self) -> bool:
        return bool(App.ActiveDocument and not Gui.Control.activeDialog()
                    and reconnect.dead_objects(App.ActiveDocument))

    def Activated(self) -> None:
        document = App.ActiveDocument
        reconnect.report(document, reconnect.reconnect(document))
        document.recompute()
