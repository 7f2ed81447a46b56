# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD is told about Fairing when its window starts."""

from __future__ import annotations

from . import paths
from .translation import translate

TITLE = "Fairing"


def tooltip() -> str:
    return translate("Workbench", "Fill holes and join edges with surfaces that meet their neighbours smoothly")


def icon(name: str) -> str:
    return paths.icon(name)


def register_commands() -> list[str]:
    """Names of the commands in the order of the toolbar."""
    from .commands.blend_faces import BlendFacesCommand
    from .commands.curvature_picture import CurvaturePictureCommand
    from .commands.edit_surface import EditSurfaceCommand
    from .commands.fill_all_holes import FillAllHolesCommand
    from .commands.fill_hole import FillHoleCommand
    from .commands.reconnect import ReconnectCommand
    import FreeCADGui as Gui

    commands = [FillHoleCommand(), FillAllHolesCommand(), BlendFacesCommand(), EditSurfaceCommand(),
                CurvaturePictureCommand(), ReconnectCommand()]
    # The macro recorder writes `import <file that added the command>` into every macro: let that be the package.
    add = compile("add(command.NAME, command)", "fairing.py", "exec")
    for command in commands:
        exec(add, {"add": Gui.addCommand, "command": command})
    return [command.NAME for command in commands]


def context_commands() -> list[str]:
    """Names of the commands in the 3D view's context menu: those that make something of what is selected."""
    from . import selection
    from .commands.blend_faces import BlendFacesCommand
    from .commands.curvature_picture import CurvaturePictureCommand
    from .commands.edit_surface import EditSurfaceCommand
    from .commands.fill_hole import FillHoleCommand

    return ([FillHoleCommand.NAME] + [BlendFacesCommand.NAME] * bool(selection.current_edges())
            + [EditSurfaceCommand.NAME] * bool(selection.current_face())
            + [CurvaturePictureCommand.NAME] * bool(selection.current_shapes()))


def start(workbench) -> None:
    """Registers the workbench, its icons, translations and preferences, and watches for objects to reconnect."""
    from .features import reconnect
    import FreeCADGui as Gui

    Gui.addIconPath(str(paths.RESOURCES / "icons"))
    Gui.addLanguagePath(paths.translations())
    Gui.addPreferencePage(paths.form("preferences.ui"), TITLE)
    Gui.addWorkbench(workbench)
    reconnect.start()
