// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/pass_through.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/fill/fill_hole.h"
#include "core/spline/nearest_patch.h"
#include "support/many_sided_loops.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Vector3d;

InnerConstraint pointAt(const Vector3d& point) {
  return {[point](double) { return point; }, true};
}

/// A curve over a straight line of the parameters, lifted off the surface by `lift` in its middle.
InnerConstraint curveOver(const KnownSurface& surface, double lift) {
  return {[surface, lift](double t) -> Vector3d {
            const double x = 0.7 * t - 0.3;
            return surface(x, 0.5 * x).point + lift * t * (1.0 - t) * Vector3d::UnitZ();
          },
          false};
}

double distanceTo(const Patches& patches, const InnerConstraint& constraint) {
  double worst = 0.0;
  for (int k = 0; k <= 60; ++k)
    worst =
        std::max(worst, spline::NearestPatch(patches).to(constraint.at(k / 60.0)).foot.distance);
  return worst;
}

struct Hole {
  const char* name;
  Sides (*sides)();
};

class PassThrough : public ::testing::TestWithParam<Hole> {
 protected:
  [[nodiscard]] FillResult filled(std::vector<InnerConstraint> through) const {
    FillOptions options;
    options.through = std::move(through);
    auto result = fillHole(loop_, options);
    EXPECT_TRUE(result.has_value());
    return result ? std::move(*result) : FillResult{};
  }

  boundary::BoundaryLoop loop_ = finished(GetParam().sides());
};

TEST_P(PassThrough, PointsAreMetToRounding) {
  const auto point = [](double x, double y, double lift) {
    return pointAt(waves()(x, y).point + lift * Vector3d::UnitZ());
  };
  const std::vector<InnerConstraint> through{point(0.1, 0.15, 0.02), point(-0.2, 0.3, -0.01)};
  const FillResult fill = filled(through);
  EXPECT_TRUE(fill.report.withinTolerance);
  ASSERT_EQ(fill.report.inner.size(), 2U);
  for (const InnerConstraint& constraint : through)
    EXPECT_LT(distanceTo(fill.patches, constraint), 1e-9);
  EXPECT_LT(fill.report.largestInnerGap, 1e-9);
}

TEST_P(PassThrough, ACurveIsMetToTheGapLimitAndTheBorderStaysWithinItsOwn) {
  const InnerConstraint curve = curveOver(waves(), 0.0);
  const FillResult fill = filled({curve});
  EXPECT_TRUE(fill.report.withinTolerance);
  // A tenth more than the limit: our places are not the report's, the peaks lie between both.
  EXPECT_LT(distanceTo(fill.patches, curve), 1.1 * fill.report.gapLimit);
  EXPECT_LE(fill.report.largestInnerGap, fill.report.gapLimit);
  EXPECT_LE(fill.report.largestGap, fill.report.gapLimit);
  EXPECT_LE(fill.report.largestAngle, 0.02);
  EXPECT_LE(fill.report.largestSeamAngle, 0.02);
}

INSTANTIATE_TEST_SUITE_P(
    Fill,
    PassThrough,
    ::testing::Values(Hole{"Quad",
                           [] { return sidesOf(waves(), rectangle(-0.6, 0.6, -0.5, 0.7)); }},
                      Hole{"Star", [] { return polygonOn(waves(), 5, 0.8); }},
                      Hole{"OGrid", [] { return circleOn(waves(), 0.8); }}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace fairing
