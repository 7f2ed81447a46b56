# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every parametric object of ours has in common: it solves when recomputed and keeps the numbers."""

from __future__ import annotations

import FreeCAD as App

from .. import exchange, migrate


class SolvedFeature:
    """Proxy of an object whose shape is solved for. A kind of object names its type and its properties' module."""

    TYPE = ""  # stored with the object, see migrate.py
    properties = None  # module with add_properties(), write_report() and write_failure()

    def __init__(self, obj: App.DocumentObject):
        migrate.mark(obj, self.TYPE)
        self.properties.add_properties(obj)
        obj.Proxy = self

    def solve(self, obj: App.DocumentObject):
        """What the object asks for. Raises ValueError or RuntimeError where there is no result."""
        raise NotImplementedError

    def is_good(self, solved) -> bool:
        """Whether what was solved needs no warning."""
        return solved.within_tolerance

    def execute(self, obj: App.DocumentObject) -> None:
        """Solves and measures. Where that fails the last good shape stays, and the verdict says why."""
        try:
            solved = self.solve(obj)
        except (ValueError, RuntimeError) as error:  # FairingError is a ValueError, NativeModuleError a RuntimeError
            self.properties.write_failure(obj, str(error))
            raise
        obj.Shape = exchange.part_shape(solved.brep())
        self.properties.write_report(obj, solved)
        if not self.is_good(solved):
            App.Console.PrintWarning(f"{obj.Label}: {obj.Verdict}\n")

    def onDocumentRestored(self, obj: App.DocumentObject) -> None:
        migrate.update(obj)
        self.properties.add_properties(obj)

    # Nothing of the proxy itself is saved. FreeCAD 0.20 calls the second pair of names, later versions the first.
    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__, __setstate__ = dumps, loads
