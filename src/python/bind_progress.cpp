// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/base/progress.h"
#include "python/bindings.h"

namespace py = pybind11;

namespace fairing::python {

void bindProgress(py::module_& module) {
  py::class_<Progress>(
      module, "Progress", "Shared between the thread that solves and the one that watches.")
      .def(py::init<>())
      .def(
          "abort", &Progress::requestAbort, "Asks the solve to stop; it then fails with Cancelled.")
      .def("finish",
           &Progress::requestFinish,
           "Asks for the best so far: no more steps towards the least energy, what they have "
           "reached is finished and returned, and the report says so.")
      .def_property_readonly("finishing", &Progress::isFinishRequested)
      .def_property_readonly("aborted", &Progress::isAbortRequested)
      .def_property_readonly("fraction", &Progress::fraction, "Share of the work done, 0 to 1.");
}

}  // namespace fairing::python
