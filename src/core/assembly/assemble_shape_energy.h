// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/layout/patch_layout.h"
#include "core/shape_energy/shape_energy.h"
#include "core/spline/bspline_surface.h"
#include "core/spline/quadrature.h"

namespace fairing::assembly {

/// The Gauss-Newton model of a shape energy over one span of one patch, about the given patches:
///   E(x + d) ~ value + gradient . d + 1/2 d' hessian d,   gradient = 2 J'r,  hessian = 2 J'J,
/// d the coordinates of the span's control points, 3 a point.
struct ShapeElement {
  std::vector<int> points;  ///< point numbers of the layout
  double value = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

/// The points of each element, in the order of the elements.
[[nodiscard]] std::vector<std::vector<int>> spanPoints(const layout::PatchLayout& layout);

/// One element a span, the same with any number of threads. The rule's default, Gauss-Legendre with
/// as many points a span and direction as the degree there, leaves no zero modes but the energy's
/// own and is good to 1e-3 of a shape that its spans can write. The patches lie on the layout's
/// knots. Not finite where a normal vanishes. `pinning` adds  1/2 pinning * integral |d - (d . n)
/// n|^2 du dv  to the model: the energy does not see displacements along the surface.
[[nodiscard]] std::vector<ShapeElement> assembleShapeEnergy(
    const layout::PatchLayout& layout,
    const std::vector<spline::BsplineSurface>& patches,
    const shape_energy::ShapeEnergy& energy,
    const spline::QuadratureRule& rule = {},
    double pinning = 0.0);

/// The same with all second derivatives: the expansion of the energy itself up to second order,
/// whose hessian need not be positive semidefinite.
[[nodiscard]] std::vector<ShapeElement> expandShapeEnergy(
    const layout::PatchLayout& layout,
    const std::vector<spline::BsplineSurface>& patches,
    const shape_energy::ShapeEnergy& energy,
    const spline::QuadratureRule& rule = {});

/// The matrix P of  d' P d = integral |d - (d . n) n|^2 du dv,  d displacements of the layout's
/// points, n the normals of the given patches, by the same quadrature: as the hessians of one
/// element a span.
[[nodiscard]] std::vector<ShapeElement> assembleTangential(
    const layout::PatchLayout& layout,
    const std::vector<spline::BsplineSurface>& patches,
    const spline::QuadratureRule& rule = {});

/// The energy alone, by the same quadrature.
[[nodiscard]] double shapeEnergyOf(const std::vector<spline::BsplineSurface>& patches,
                                   const shape_energy::ShapeEnergy& energy,
                                   const spline::QuadratureRule& rule = {});

}  // namespace fairing::assembly
