# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changing the document by lines of Python that FreeCAD's macro recorder writes down."""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from .. import migrate


def run(command: str) -> None:
    """Runs a line of Python; the macro recorder writes it down."""
    for module in ("FreeCAD", "fairing"):
        Gui.addModule(module)
    Gui.doCommand(command)


def run_as_one_step(document: App.Document, title: str, command: str) -> None:
    """The same as one step to undo. Where it fails, nothing is done."""
    document.openTransaction(title)
    try:
        run(command)
        document.commitTransaction()
    except Exception:
        document.abortTransaction()
        raise


def make_as_one_step(document: App.Document, title: str, command: str, kind: str) -> App.DocumentObject:
    """The same for a line that makes an object of Fairing's, and what belongs to it; returns the object."""
    known = {obj.Name for obj in document.Objects}
    run_as_one_step(document, title, command)
    return next(obj for obj in document.Objects if obj.Name not in known and migrate.kind_of(obj) == kind)


def link_command(link) -> str:
    return f"({object_command(link[0])}, {list(link[1])!r})" if link else "None"


def object_command(obj: App.DocumentObject) -> str:
    """The Python expression that finds an object again."""
    if obj.Document.Name == App.ActiveDocument.Name:
        return f"FreeCAD.ActiveDocument.getObject({obj.Name!r})"
    return f"FreeCAD.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"
