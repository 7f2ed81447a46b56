# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing: fills holes and joins edges with fair B-spline faces that meet their neighbours smoothly.

    shape, report = fairing.fill(base.Shape, edges=["Edge3"])     shapes only, no document
    shape, reports = fairing.fill_all(base.Shape)                 every hole of a shape
    obj = fairing.make_fill(base, ["Edge3"], continuity="G1")     a parametric document object
    fairing.change_fill(obj, energy="membrane")                   with other choices
    obj = fairing.make_fill_all(base)                             one for every hole of another object
    shape, report = fairing.blend(base.Shape, ["Edge1"], ["Edge4"])       joins two edges, or two chains of them
    obj = fairing.make_blend((base, ["Edge1"]), (other, ["Edge3"]))       the same as a parametric document object
    obj = fairing.make_blend((pipe, ["Edge1"]), [(a, ["Edge3"]), (b, ["Edge3"])])     a side of several objects
    fairing.change_blend(obj, continuity="G2")                    with other choices
    shape, report = fairing.edit(base.Shape, "Face3", guide=handles, lambda_=50)   shapes a face anew, its border kept
    obj = fairing.make_edit(base, "Face3", guides=handles, lambda_=50)    the same as a parametric document object
    fairing.holes(base.Shape)                                     the loops of free edges
    fairing.compare(base.Shape, edges=["Edge3"])                  a report an energy
    fairing.curvature_picture(base.Shape, "gauss")                points, triangles and the curvature at each point
    fairing.show_curvature([base], "zebra")                       the same to be looked at, in FreeCAD's window

Lengths are in mm, angles in degrees. What cannot be done raises fairing.FairingError, whose text is one sentence.
"""

from .api import blend, compare, compare_blend, curvature_picture, edit, fill, fill_all, holes, report, show_curvature
from .features.blend_feature import change_blend, make_blend
from .features.edit_feature import change_edit, make_edit
from .features.fill_all_feature import change_fill_all, make_fill_all
from .features.fill_feature import change_fill, make_fill
from .native import NativeModuleError

__all__ = ["FairingError", "NativeModuleError", "blend", "change_blend", "change_edit", "change_fill", "change_fill_all",
           "compare", "compare_blend", "curvature_picture", "edit", "fill", "fill_all", "holes", "make_blend",
           "make_edit", "make_fill", "make_fill_all", "report", "show_curvature"]


def __getattr__(name):
    if name == "FairingError":  # lives in the native module, which is loaded when first needed
        from . import native

        return native.module().FairingError
    raise AttributeError(f"module 'fairing' has no attribute '{name}'")
