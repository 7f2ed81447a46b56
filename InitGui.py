# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this file inside a function: names of the top level are not visible within methods, which import their own.
import FreeCADGui


class FairingWorkbench(FreeCADGui.Workbench):
    from fairing import workbench as _workbench

    MenuText = _workbench.TITLE
    ToolTip = _workbench.tooltip()
    Icon = _workbench.icon("Fairing.svg")

    def Initialize(self):
        from fairing import workbench

        self.commands = workbench.register_commands()
        self.appendToolbar(workbench.TITLE, self.commands)
        self.appendMenu(workbench.TITLE, self.commands)

    def ContextMenu(self, recipient):
        if recipient == "View":
            from fairing import workbench

            self.appendContextMenu("", workbench.context_commands())

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FairingWorkbench._workbench.start(FairingWorkbench())
