// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <pybind11/pybind11.h>

/// Names and conversions only: what Python sees of Fairing. One function an area, called by
/// module.cpp.
namespace fairing::python {

void bindErrors(pybind11::module_& module);
void bindProgress(pybind11::module_& module);
void bindFill(pybind11::module_& module);
void bindShape(pybind11::module_& module);

}  // namespace fairing::python
