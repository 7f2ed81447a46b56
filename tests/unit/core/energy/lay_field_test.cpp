// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/lay_field.h"

#include <gmock/gmock.h>

#include "support/random_splines.h"

namespace fairing::energy {
namespace {

using namespace ::fairing::testing;  // NOLINT: random splines
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

/// The plane rectangle [0, 3] x [0, 2], its parameters (0, 0), (1, 0), (0, 1) at given corners.
BsplineSurface rectangle(const Vector3d& origin, const Vector3d& alongU, const Vector3d& alongV) {
  const KnotVector u = KnotVector::bezier(2), v = KnotVector::bezier(3);
  return interpolated(
      [&](double s, double t) {
        return Vector3d(origin + s * (alongU - origin) + t * (alongV - origin));
      },
      u,
      v);
}

/// A field that says where it is: at the place (x, y) of the rectangle the normal is (x, y, 1).
Guidance placed() {
  Guidance guidance;
  guidance.corners = FieldCorners{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}};
  DiscreteGuidance grid;
  grid.n = 3;
  grid.m = 2;
  grid.normals.resize(12, 3);
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= 2; ++j) grid.normals.row(i * 3 + j) << i, j, 1;
  grid.points = grid.normals;
  grid.lambda = grid.normals.col(0);
  grid.gamma = grid.normals.col(1);
  guidance.discrete = grid;
  guidance.continuous = {
      interpolated([](double u, double v) { return Vector3d(3.0 * u, 2.0 * v, 1.0); },
                   KnotVector::fromBreaks(2, {0.0, 0.3, 1.0}),
                   KnotVector::bezier(4))};
  return guidance;
}

TEST(LayField, LiesTheSameInSpaceHoweverThePatchRuns) {
  const Vector3d corners[4] = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}};
  for (int start = 0; start < 4; ++start)
    for (const int step : {1, 3}) {
      const BsplineSurface patch =
          rectangle(corners[start], corners[(start + step) % 4], corners[(start + 4 - step) % 4]);
      const Guidance laid = laidOn(placed(), patch);
      const DiscreteGuidance& grid = *laid.discrete;
      for (int i = 0; i <= grid.n; ++i)
        for (int j = 0; j <= grid.m; ++j) {
          const double u = double(i) / grid.n, v = double(j) / grid.m;
          const Vector3d at = patch.evaluate(u, v);
          const Eigen::Index k = i * (grid.m + 1) + j;
          EXPECT_LT((grid.normals.row(k).transpose() - Vector3d(at.x(), at.y(), 1)).norm(), 1e-12);
          EXPECT_NEAR(grid.lambda[k], at.x(), 1e-12);
          EXPECT_NEAR(grid.gamma[k], at.y(), 1e-12);
          const BsplineSurface& normals = laid.continuous->normals;
          EXPECT_LT((normals.evaluate(u, v) - Vector3d(at.x(), at.y(), 1)).norm(), 1e-12);
        }
    }
}

TEST(LayField, StaysAsItIsWithoutCorners) {
  Guidance field = placed();
  field.corners.reset();
  const BsplineSurface patch = rectangle({3, 2, 0}, {0, 2, 0}, {3, 0, 0});
  EXPECT_EQ(laidOn(field, patch).discrete->normals, field.discrete->normals);
}

}  // namespace
}  // namespace fairing::energy
