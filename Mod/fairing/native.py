# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the native module `_fairing`, or says in one sentence why it cannot be used."""

from __future__ import annotations

import importlib
import importlib.machinery
import platform
from pathlib import Path

PACKAGE_DIR = Path(__file__).resolve().parent


class NativeModuleError(RuntimeError):
    """Fairing's native module is missing or was built for other versions; the text says which and what to do."""


def module():
    """The native module. Raises NativeModuleError."""
    try:
        native = importlib.import_module("fairing._fairing")
    except ImportError as error:
        raise NativeModuleError(_reason(error)) from None
    _check_occt(native)
    return native


def problem() -> str:
    """Why the native module cannot be used; empty when it can."""
    try:
        module()
    except NativeModuleError as error:
        return str(error)
    return ""


def _reason(error: ImportError) -> str:
    built = sorted(path.name for path in PACKAGE_DIR.glob("_fairing*.so"))
    if not built:
        return (f"Fairing's native module is missing in {PACKAGE_DIR}: build the add-on on this machine "
                "(see Fairing's README) and install it again.")
    if not {"_fairing" + suffix for suffix in importlib.machinery.EXTENSION_SUFFIXES}.intersection(built):
        return (f"Fairing's native module {built[0]} was built for another Python than FreeCAD's "
                f"{platform.python_version()}: build the add-on with FreeCAD's Python and install it again.")
    return (f"Fairing's native module {built[0]} does not load ({error}): it was built for other libraries than "
            "this FreeCAD uses; build the add-on on this machine and install it again.")


def _check_occt(native) -> None:
    """Two versions of OCCT in one process would mix their symbols."""
    import Part

    used = getattr(Part, "OCC_VERSION", native.occt_version)
    if used.split(".")[:2] != native.occt_version.split(".")[:2]:
        raise NativeModuleError(f"Fairing's native module was built for OCCT {native.occt_version}, but this FreeCAD "
                                f"uses {used}: build the add-on on this machine and install it again.")
