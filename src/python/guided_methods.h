// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <pybind11/pybind11.h>

#include "occt/edit_face.h"
#include "occt/guide_live.h"
#include "python/conversions.h"

namespace fairing::python {

[[nodiscard]] inline std::vector<spline::BsplineSurface> patchesOf(const occt::ShapeFill& fill) {
  return fill.fill.patches;
}
[[nodiscard]] inline std::vector<spline::BsplineSurface> patchesOf(const occt::ShapeEdit& edit) {
  return {edit.edit.surface};
}

/// Arrows and nets as Python sees them.
[[nodiscard]] pybind11::tuple arrowsOf(const energy::Guidance& guidance,
                                       const std::vector<spline::BsplineSurface>& patches,
                                       int count);
[[nodiscard]] pybind11::list netsOf(const std::vector<spline::BsplineSurface>& patches);
/// What guided before under other weights, and with other handles, curves and fields where given.
[[nodiscard]] energy::Guidance changed(energy::Guidance guidance,
                                       double lambda,
                                       double gamma,
                                       const pybind11::object& guide);

/// Gives a type that has a live member the methods guiding, guide_arrows and control_net.
template <class Class>
void bindGuidance(Class& bound) {
  using Shape = typename Class::type;
  bound
      .def(
          "guiding",
          [](const Shape& shape, double lambda, double gamma, const pybind11::object& guide) {
            const auto guidance = changed(shape.live->guidance(), lambda, gamma, guide);
            const bool lookUp = !guide.is_none();
            const pybind11::gil_scoped_release release;
            return valueOf(occt::guiding(shape, guidance, lookUp));
          },
          pybind11::arg("lambda_"),
          pybind11::arg("gamma"),
          pybind11::arg("guide") = pybind11::none(),
          "The same under other weights, as a preview: one solve, so that it follows a "
          "slider or a handle. guide as in fill() (None: what guided before); the reference stays. "
          "By one thread at a time. The GIL is released while solving. Raises FairingError.")
      .def_property_readonly(
          "guides_quickly",
          [](const Shape& shape) { return shape.live->isQuick(); },
          "Whether guiding() costs one solve; a trimmed face is filled anew.")
      .def(
          "guide_arrows",
          [](const Shape& shape, int count) {
            return arrowsOf(shape.live->guidance(), patchesOf(shape), count);
          },
          pybind11::arg("count") = 12,
          "What guides, for drawing, at about count x count places a patch: points and unit "
          "normals (n x 3) and weights (n).")
      .def(
          "control_net",
          [](const Shape& shape) { return netsOf(patchesOf(shape)); },
          "The control net of each patch: numbers of rows and columns, and the control points row "
          "by row (rows * columns x 3).");
}

}  // namespace fairing::python
