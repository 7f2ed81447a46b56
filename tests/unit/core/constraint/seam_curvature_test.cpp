// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/seam_curvature.h"

#include <gmock/gmock.h>

#include "core/analysis/curvature.h"
#include "core/fill/fill_hole.h"
#include "core/layout/layouts.h"
#include "core/span/span_hole.h"
#include "support/many_sided_loops.h"
#include "support/random_splines.h"

namespace fairing::constraint {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops
using Eigen::Vector3d;

struct Hole {
  const char* name;
  LayoutKind kind;
  Sides (*sides)();
};

class CurvedSeams : public ::testing::TestWithParam<Hole> {
 protected:
  static FillResult filled() {
    FillOptions options;
    options.layout = GetParam().kind;
    options.inner = Continuity::G2;
    auto fill = fillHole(finished(GetParam().sides()), options);
    EXPECT_TRUE(fill.has_value());
    return std::move(*fill);
  }

  // What the patches have in one of their corners, by its place.
  static std::vector<std::vector<spline::SurfaceJet>> cornersOf(const Patches& patches) {
    std::vector<std::vector<spline::SurfaceJet>> corners;
    for (const spline::BsplineSurface& patch : patches)
      for (const double u : {patch.u.first(), patch.u.last()})
        for (const double v : {patch.v.first(), patch.v.last()}) {
          const spline::SurfaceJet jet = patch.jet(u, v);
          const auto here = std::find_if(corners.begin(), corners.end(), [&](const auto& corner) {
            return (corner.front().point - jet.point).norm() < 1e-9;
          });
          if (here == corners.end())
            corners.push_back({jet});
          else
            here->push_back(jet);
        }
    return corners;
  }
};

TEST_P(CurvedSeams, AreMetWithEqualCurvature) {
  const FillResult fill = filled();
  ASSERT_GT(fill.patches.size(), 1U);
  EXPECT_TRUE(fill.report.withinTolerance);
  EXPECT_LE(fill.report.largestSeamJump, 0.01);
  EXPECT_LE(fill.report.largestSeamAngle, 0.02);
  for (const auto& seam : fill.report.seams) EXPECT_GT(seam.jump.count, 0);
}

// All patches that meet in an inner vertex have one second fundamental form there: three
// directions tell it.
TEST_P(CurvedSeams, MeetInVerticesOfOneSecondForm) {
  const FillResult fill = filled();
  int inner = 0;
  for (const auto& corner : cornersOf(fill.patches)) {
    if (corner.size() < 3) continue;
    ++inner;
    const Vector3d u = corner.front().u.normalized();
    const Vector3d v = corner.front().normalVector().normalized().cross(u);
    const double scale = std::abs(analysis::normalCurvature(corner.front(), u)) +
                         std::abs(analysis::normalCurvature(corner.front(), v));
    for (const Vector3d& way : {u, v, Vector3d((u + v).normalized())})
      for (const spline::SurfaceJet& other : corner)
        EXPECT_NEAR(analysis::normalCurvature(other, way),
                    analysis::normalCurvature(corner.front(), way),
                    1e-6 * scale);
  }
  EXPECT_GT(inner, 0);
}

// Where the curvatures agree the rows vanish; beside it they tell how the jump changes.
TEST_P(CurvedSeams, AreLinearisedExactly) {
  const FillResult fill = filled();
  auto plan = layout::planLayout(finished(GetParam().sides()), GetParam().kind);
  plan->inner = Continuity::G2;
  const layout::PatchLayout layout = layoutOf(*plan, fill.patches);
  const solver::Points points = pointsOf(layout, fill.patches);
  Random random{0};
  solver::Points move(points.rows(), 3);
  for (Eigen::Index k = 0; k < move.rows(); ++k) move.row(k) = randomVector(random).transpose();
  const auto valuesAt = [](const solver::ConstraintBlock& rows, const solver::Points& at) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(rows.rows.size()));
    for (std::size_t r = 0; r < rows.rows.size(); ++r) {
      const solver::LinearRow& row = rows.rows[r];
      values[static_cast<Eigen::Index>(r)] = -row.right;
      for (std::size_t k = 0; k < row.points.size(); ++k)
        values[static_cast<Eigen::Index>(r)] += row.weights[k].dot(at.row(row.points[k]));
    }
    return values;
  };
  constexpr double kStep = 1e-6;
  const auto jumpAt = [&](double step) {
    const solver::Points moved = points + step * move;
    return valuesAt(*seamCurvatureRows(layout, moved), moved);
  };
  const auto rows = seamCurvatureRows(layout, points);
  ASSERT_TRUE(rows.has_value());
  EXPECT_LT(valuesAt(*rows, points).cwiseAbs().maxCoeff(), 1e-8);
  const Eigen::VectorXd told = valuesAt(*rows, move);
  const Eigen::VectorXd found = (jumpAt(kStep) - jumpAt(-kStep)) / (2.0 * kStep);
  EXPECT_LT((told - found).cwiseAbs().maxCoeff(), 1e-4 * found.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(
    SeamCurvature,
    CurvedSeams,
    ::testing::Values(Hole{"Triangle", LayoutKind::Star, [] { return polygonOn(waves(), 3); }},
                      Hole{"Pentagon", LayoutKind::Star, [] { return polygonOn(waves(), 5); }},
                      Hole{"Octant", LayoutKind::Star, [] { return sphereOctant(1.0); }},
                      Hole{"Circle", LayoutKind::OGrid, [] { return circleOn(waves(), 1.0); }}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(SeamCurvature, GoesTogetherWithEveryEnergy) {
  FillOptions options;
  options.inner = Continuity::G2;
  for (const EnergyKind energy : {EnergyKind::ThinPlate, EnergyKind::MinimumVariation}) {
    options.energy = energy;
    const auto fill = fillHole(finished(sphereOctant(1.0)), options);
    ASSERT_TRUE(fill.has_value());
    EXPECT_EQ(fill->layout, LayoutKind::Star);
    EXPECT_TRUE(fill->report.withinTolerance);
    EXPECT_LE(fill->report.largestSeamJump, 0.01);
  }
}

TEST(SeamCurvature, GoesTogetherWithCurvedSides) {
  FillOptions options;
  options.inner = Continuity::G2;
  const auto fill = fillHole(finished(asking(polygonOn(waves(), 3), Continuity::G2)), options);
  ASSERT_TRUE(fill.has_value());
  EXPECT_EQ(fill->layout, LayoutKind::Star);
  EXPECT_TRUE(fill->report.withinTolerance);
  EXPECT_LE(fill->report.largestCurvature, 0.01);
  EXPECT_LE(fill->report.largestSeamJump, 0.01);
}

TEST(SeamCurvature, IsNotAskedUnlessWished) {
  const auto fill = fillHole(finished(polygonOn(waves(), 5)), {});
  ASSERT_TRUE(fill.has_value());
  EXPECT_EQ(fill->report.largestSeamJump, 0.0);
}

TEST(SeamCurvature, RefusesPatchesThatOnlyTouch) {
  FillOptions options;
  options.inner = Continuity::G0;
  EXPECT_EQ(validate(options)->code, ErrorCode::UnknownChoice);
}

}  // namespace
}  // namespace fairing::constraint
