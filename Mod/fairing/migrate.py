# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which version made an object, and how objects of older versions become objects of this one.

Every object of Fairing carries its kind and the version of its properties. Renames belong into UPDATES, one function a
version, each with a test on an old object.
"""

from __future__ import annotations

import FreeCAD as App

MARK = "FairingType"
VERSION = "FairingVersion"
CURRENT = 2  # raised whenever a property is renamed or changes its meaning

_READ_ONLY_HIDDEN = 1 | 4


def _let_reference_hold_several(obj: App.DocumentObject) -> None:
    """Version 1 had a reference of one object alone."""
    if "Reference" not in obj.PropertiesList:
        return
    kept = obj.Reference
    obj.removeProperty("Reference")
    obj.addProperty("App::PropertyLinkSubListGlobal", "Reference", "Guidance")
    obj.Reference = [(kept[0], list(kept[1]) or [""])] if kept else []


UPDATES = {1: _let_reference_hold_several}  # version -> function that makes an object of it one of the next version


def mark(obj: App.DocumentObject, kind: str) -> None:
    """Writes the kind and the current version into an object."""
    for name, property_type in ((MARK, "App::PropertyString"), (VERSION, "App::PropertyInteger")):
        if name not in obj.PropertiesList:
            obj.addProperty(property_type, name, "Fairing", "", _READ_ONLY_HIDDEN)
    setattr(obj, MARK, kind)
    setattr(obj, VERSION, CURRENT)


def kind_of(obj: App.DocumentObject) -> str:
    """What kind of object of Fairing's this is; empty for any other object."""
    return getattr(obj, MARK) if MARK in obj.PropertiesList else ""


def update(obj: App.DocumentObject) -> None:
    """Makes an object of an older version one of this version; one of a newer version is left alone, with a warning."""
    if getattr(obj, VERSION) > CURRENT:
        App.Console.PrintWarning(f"{obj.Label} was made by a newer Fairing: some of its settings may be lost.\n")
        return
    while getattr(obj, VERSION) < CURRENT:
        UPDATES[getattr(obj, VERSION)](obj)
        setattr(obj, VERSION, getattr(obj, VERSION) + 1)
