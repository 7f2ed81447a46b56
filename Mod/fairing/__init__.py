# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing: fills holes with fair B-spline faces that meet their neighbours smoothly.

    shape, report = fairing.fill(base.Shape, edges=["Edge3"])     shapes only, no document
    obj = fairing.make_fill(base, ["Edge3"], continuity="G1")     a parametric document object
    fairing.change_fill(obj, energy="membrane")                   with other choices
    fairing.holes(base.Shape)                                     the loops of free edges

Lengths are in mm, angles in degrees. What cannot be done raises fairing.FairingError, whose text is one sentence.
"""

from .api import fill, holes, report
from .features.fill_feature import change_fill, make_fill
from .native import NativeModuleError

__all__ = ["FairingError", "NativeModuleError", "change_fill", "fill", "holes", "make_fill", "report"]


def __getattr__(name):
    if name == "FairingError":  # lives in the native module, which is loaded when first needed
        from . import native

        return native.module().FairingError
    raise AttributeError(f"module 'fairing' has no attribute '{name}'")
