// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How fast Gauss-Newton steps on an energy of the shape come home from a dented surface.
#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/assembly/assemble_shape_energy.h"
#include "core/shape_energy/mean_curvature_gradient.h"
#include "support/known_surface.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: known surfaces, random splines, quadratic forms
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using spline::BsplineSurface;
using spline::KnotVector;

const shape_energy::MeanCurvatureGradient kEnergy;

double energyOf(const BsplineSurface& patch) {
  return assembly::shapeEnergyOf({patch}, kEnergy);
}

BsplineSurface patchOf(const KnownSurface& surface) {
  const KnotVector knots = KnotVector::fromBreaks(5, {0.0, 0.5, 1.0});
  return interpolated([&](double u, double v) { return surface(u, v).point; }, knots, knots);
}

// The poles that a side with a tangent plane leaves free: all but the outer two rows.
std::vector<int> innerPoles(const BsplineSurface& patch) {
  std::vector<int> inner;
  for (int i = 2; i < patch.u.poleCount() - 2; ++i)
    for (int j = 2; j < patch.v.poleCount() - 2; ++j) inner.push_back(patch.index(i, j));
  return inner;
}

Vector3d normalAbove(const BsplineSurface& patch, int pole) {
  const int columns = patch.v.poleCount();
  return normalOf(patch.jet(patch.u.greville(pole / columns), patch.v.greville(pole % columns)));
}

BsplineSurface dented(BsplineSurface patch, double depth) {
  Random random{0};
  const BsplineSurface before = patch;
  for (const int pole : innerPoles(patch))
    patch.poles.row(pole) += depth * randomNumber(random) * normalAbove(before, pole).transpose();
  return patch;
}

// One step of the inner poles, full length, displacements along the surface pinned.
BsplineSurface stepped(BsplineSurface patch) {
  const layout::PatchLayout layout = freePatch(patch.u, patch.v);
  MatrixXd hessian = MatrixXd::Zero(3 * layout.pointCount, 3 * layout.pointCount);
  VectorXd gradient = VectorXd::Zero(3 * layout.pointCount);
  for (const auto& e : assembly::assembleShapeEnergy(layout, {patch}, kEnergy))
    for (std::size_t a = 0; a < e.points.size(); ++a) {
      const auto row = 3 * static_cast<Eigen::Index>(a);
      gradient.segment<3>(3 * e.points[a]) += e.gradient.segment<3>(row);
      for (std::size_t b = 0; b < e.points.size(); ++b)
        hessian.block<3, 3>(3 * e.points[a], 3 * e.points[b]) +=
            e.hessian.block<3, 3>(row, 3 * static_cast<Eigen::Index>(b));
    }
  const double pin = 0.1 * hessian.diagonal().mean();
  std::vector<int> coordinates;
  for (const int pole : innerPoles(patch)) {
    const Vector3d n = normalAbove(patch, pole);
    hessian.block<3, 3>(3 * pole, 3 * pole) += pin * (Matrix3d::Identity() - n * n.transpose());
    for (int c = 0; c < 3; ++c) coordinates.push_back(3 * pole + c);
  }
  const MatrixXd matrix = hessian(coordinates, coordinates);
  VectorXd step = VectorXd::Zero(gradient.size());
  step(coordinates) = -matrix.ldlt().solve(gradient(coordinates));
  patch.poles += unflattened(step);
  return patch;
}

class ShapeEnergySteps : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] BsplineSurface exact() const {
    const KnownSurface surfaces[] = {sphere(1.0), cylinder(1.0), plane()};
    return patchOf(surfaces[GetParam()]);
  }
};

TEST_P(ShapeEnergySteps, TheFirstTakesNearlyAllAway) {
  const BsplineSurface start = dented(exact(), 0.01);
  EXPECT_LT(energyOf(stepped(start)), 1e-4 * energyOf(start));
}

// What remains after a step is of second order in the dent, its energy of fourth.
TEST_P(ShapeEnergySteps, WhatRemainsFallsWithTheSquareOfTheDent) {
  const BsplineSurface home = stepped(stepped(stepped(exact())));
  const auto offAfterOne = [&](double depth) {
    const BsplineSurface patch = stepped(dented(exact(), depth));
    double off = 0.0;
    for (const double u : {0.2, 0.4, 0.7})
      for (const double v : {0.3, 0.6, 0.8}) {
        const Vector3d apart = patch.evaluate(u, v) - home.evaluate(u, v);
        off = std::max(off, std::abs(apart.dot(normalOf(home.jet(u, v)))));
      }
    return off;
  };
  EXPECT_LT(offAfterOne(0.01), 0.3 * offAfterOne(0.02));
}

INSTANTIATE_TEST_SUITE_P(SphereCylinderPlane, ShapeEnergySteps, ::testing::Range(0, 3));

}  // namespace
}  // namespace fairing
