// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Version.hxx>

#include "python/bindings.h"

PYBIND11_MODULE(_fairing, module) {
  module.doc() =
      "Fairing's native module: holes of shapes filled and edges joined with B-spline faces. "
      "Lengths in mm, angles "
      "in degrees.";
  module.attr("__version__") = FAIRING_VERSION;
  module.attr("occt_version") = OCC_VERSION_COMPLETE;
  fairing::python::bindErrors(module);
  fairing::python::bindProgress(module);
  fairing::python::bindPicture(module);
  fairing::python::bindFill(module);
  fairing::python::bindFillAll(module);
  fairing::python::bindShape(module);
  fairing::python::bindGuides(module);
}
