# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD is told about Fairing when its window starts."""

from __future__ import annotations

from . import paths
from .translation import translate

TITLE = "Fairing"


def tooltip() -> str:
    return translate("Workbench", "Fill holes with surfaces that meet their neighbours smoothly")


def icon(name: str) -> str:
    return paths.icon(name)


def register_commands() -> list[str]:
    """Names of the commands in the order of the toolbar."""
    from .commands.fill_hole import FillHoleCommand
    from .commands.reconnect import ReconnectCommand
    import FreeCADGui as Gui

    commands = [FillHoleCommand(), ReconnectCommand()]
    for command in commands:
        Gui.addCommand(command.NAME, command)
    return [command.NAME for command in commands]


def start(workbench) -> None:
    """Registers the workbench, its icons, translations and preferences, and watches for objects to reconnect."""
    from .features import reconnect
    import FreeCADGui as Gui

    Gui.addIconPath(str(paths.RESOURCES / "icons"))
    Gui.addLanguagePath(paths.translations())
    Gui.addPreferencePage(paths.form("preferences.ui"), TITLE)
    Gui.addWorkbench(workbench)
    reconnect.start()
