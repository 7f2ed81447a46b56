// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <pybind11/pybind11.h>

#include "occt/shape_index.h"

/// Names and conversions only: what Python sees of Fairing. One function an area, called by
/// module.cpp.
namespace fairing::python {

void bindErrors(pybind11::module_& module);
void bindProgress(pybind11::module_& module);
void bindFill(pybind11::module_& module);
void bindFillAll(pybind11::module_& module);
void bindShape(pybind11::module_& module);
/// The type CurvaturePicture.
void bindPicture(pybind11::module_& module);
/// What prepares guides: mesh_faces and guide_curve.
void bindGuides(pybind11::module_& module);
/// The methods fill and fill_all of Shape.
void bindFilling(pybind11::class_<occt::ShapeIndex>& shape);
/// The type Blend, and the methods chains, whole_chain and blend of Shape.
void bindBlend(pybind11::module_& module, pybind11::class_<occt::ShapeIndex>& shape);
/// The type Edit, and the method edit of Shape.
void bindEdit(pybind11::module_& module, pybind11::class_<occt::ShapeIndex>& shape);

}  // namespace fairing::python
