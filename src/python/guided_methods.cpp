// SPDX-License-Identifier: LGPL-2.1-or-later
#include "python/guided_methods.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "core/energy/guide_arrows.h"
#include "occt/guide_curve.h"
#include "occt/mesh_reference.h"
#include "occt/shape_bytes.h"
#include "python/bindings.h"

namespace py = pybind11;

namespace fairing::python {
namespace {

using Corners = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

py::array_t<double> arrayOf(const Rows& rows) {
  return py::array_t<double>({rows.rows(), Eigen::Index(3)}, rows.data());
}

py::array_t<double> arrayOf(const std::vector<Eigen::Vector3d>& vectors) {
  Rows rows(static_cast<Eigen::Index>(vectors.size()), 3);
  for (std::size_t k = 0; k < vectors.size(); ++k) rows.row(Eigen::Index(k)) = vectors[k];
  return arrayOf(rows);
}

}  // namespace

py::tuple arrowsOf(const energy::Guidance& guidance,
                   const std::vector<spline::BsplineSurface>& patches,
                   int count) {
  const auto arrows = energy::guideArrows(guidance, patches, std::max(1, count));
  const auto n = static_cast<Eigen::Index>(arrows.size());
  Rows points(n, 3), normals(n, 3);
  py::array_t<double> weights(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const energy::GuideArrow& arrow = arrows[static_cast<std::size_t>(k)];
    points.row(k) = arrow.point;
    normals.row(k) = arrow.normal;
    weights.mutable_at(k) = arrow.weight;
  }
  return py::make_tuple(arrayOf(points), arrayOf(normals), weights);
}

py::list netsOf(const std::vector<spline::BsplineSurface>& patches) {
  py::list nets;
  for (const spline::BsplineSurface& patch : patches)
    nets.append(py::make_tuple(patch.u.poleCount(), patch.v.poleCount(), arrayOf(patch.poles)));
  return nets;
}

energy::Guidance changed(energy::Guidance guidance,
                         double lambda,
                         double gamma,
                         const py::object& guide) {
  if (!guide.is_none()) {
    energy::Guidance other = guidanceOf(lambda, gamma, std::nullopt, guide);
    other.reference = std::move(guidance.reference);
    return other;
  }
  guidance.lambda = lambda;
  guidance.gamma = gamma;
  return guidance;
}

void bindGuides(py::module_& module) {
  module.def(
      "mesh_faces",
      [](const Rows& points, const Corners& triangles) {
        return py::bytes(valueOf(occt::bytesFromShape(valueOf(occt::meshFace(points, triangles)))));
      },
      py::arg("points"),
      py::arg("triangles"),
      "A mesh as BREP of one face, to be a reference of fill(), blend() or edit(): points n x 3, "
      "triangles m x 3 with corners counted from 0. Raises FairingError where neighbouring "
      "triangles are turned against each other.");
  module.def(
      "guide_curve",
      [](const py::bytes& edges,
         const std::optional<py::bytes>& faces,
         const std::optional<Triple>& normal) {
        const TopoDS_Shape beside = faces ? shapeOf(*faces) : TopoDS_Shape();
        const auto direction = normal ? std::optional(vectorOf(*normal)) : std::nullopt;
        const auto curve = valueOf(occt::guideCurve(shapeOf(edges), beside, direction));
        return py::make_tuple(arrayOf(curve.points), arrayOf(curve.normals));
      },
      py::arg("edges"),
      py::arg("faces") = py::none(),
      py::arg("normal") = py::none(),
      "Points along edges (BREP) that make one curve, and the normals there, n x 3 each: those of "
      "faces (BREP) near it, or the given direction turned square to it. For the \"curves\" of a "
      "guide. Raises FairingError.");
}

}  // namespace fairing::python
