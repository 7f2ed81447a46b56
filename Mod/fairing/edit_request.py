# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shaping one face anew is asked to do, and the one place that has it solved."""

from __future__ import annotations

import dataclasses
import json
from typing import Any, Optional

from . import native
from .choices import SOLVED


@dataclasses.dataclass(frozen=True)
class EditRequest:
    """One edit: the face, and the choices."""

    face: int = 0
    energy: str = "thin-plate"
    keep: Optional[str] = None  # what stays along the border; None: G1, or G0 for the membrane
    degree: int = 0  # 0: the face's own
    spans: int = 0  # 0: the face's own
    lambda_: float = 0.0  # weight of the guiding normals
    gamma: float = 0.0  # weight of the guiding points
    reference: Optional[bytes] = dataclasses.field(default=None, repr=False)  # BREP of the faces that guide
    guide: str = dataclasses.field(default="[]", repr=False)  # JSON: handles, curves, a field
    result: str = "patches"

    NOT_SCRIPTED = ("face", "reference", "guide")  # members that scripts give in another way

    def differences(self, other: "EditRequest") -> dict[str, Any]:
        """Choices that differ from another request's, as scripts give them."""
        return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)
                if field.name not in self.NOT_SCRIPTED and getattr(self, field.name) != getattr(other, field.name)}

    def arguments(self) -> dict[str, Any]:
        """Keyword arguments of the native Shape.edit()."""
        given = dataclasses.asdict(self)
        return {**given, "guide": json.loads(self.guide)}

    def solve(self, brep: bytes, progress=None):
        """The native Edit of this request on a shape given as BREP text.

        May be called from any thread; the GIL is released while solving. Raises FairingError or NativeModuleError.
        """
        return SOLVED.get_or_make(
            brep, self, lambda progress: native.module().Shape(brep).edit(progress=progress, **self.arguments()), progress)
