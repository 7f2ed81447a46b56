# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs inside FreeCAD, started by scripts/with_freecad: one script, once, and its exit status.

FreeCAD's own way runs a failing script twice and exits with 0; this one prints the traceback and says 1.
"""

import faulthandler
import os
import runpy
import sys
import traceback

import FreeCAD

log = open(os.environ["FAIRING_LOG"], "w", buffering=1)
started = False


def run_script():
    """Runs the script as __main__ and ends the process with its status."""
    global started
    if started:
        return
    started = True
    faulthandler.enable(log)
    with open(os.environ["FAIRING_ARGUMENTS"]) as arguments:
        sys.argv = arguments.read().splitlines()
    sys.stdout = sys.stderr = log
    sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[0])))
    status = 0
    try:
        # FreeCAD itself runs Python lines in __main__ and counts on these names there.
        names = {"App": FreeCAD, "Gui": sys.modules.get("FreeCADGui")}
        runpy.run_path(sys.argv[0], init_globals=names, run_name="__main__")
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else int(end.code is not None)
        if isinstance(end.code, str):
            print(end.code)
    except BaseException:
        traceback.print_exc(file=log)
        status = 1
    log.flush()
    os._exit(status)


if FreeCAD.GuiUp:
    import FreeCADGui
    from PySide import QtCore

    def start():
        FreeCADGui.getMainWindow().statusBar().clearMessage()  # FreeCAD's warnings about its own parts
        run_script()

    QtCore.QTimer.singleShot(200, start)
else:
    run_script()
