// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/seam_ties.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "core/layout/layouts.h"
#include "core/solver/tie_points.h"
#include "core/span/span_hole.h"
#include "support/many_sided_loops.h"
#include "support/random_splines.h"

namespace fairing::constraint {
namespace {

using namespace ::fairing::testing;  // NOLINT: the whole vocabulary of known loops

struct Hole {
  const char* name;
  LayoutKind kind;
  Sides (*sides)();
};

/// Patches that lie on the sides and obey the ties of their seams, nothing else: near the fill,
/// roughened at random.
class Ties : public ::testing::TestWithParam<Hole> {
 protected:
  void SetUp() override {
    const auto plan = layout::planLayout(finished(GetParam().sides()), GetParam().kind);
    ASSERT_TRUE(plan.has_value());
    layout_ = layout::makeLayout(*plan, {.fitTolerance = 1e-4});
    const auto program = makeProgram(*plan, layout_, EnergyKind::ThinPlate);
    ASSERT_TRUE(program.has_value());
    const auto start = solver::solve(*program);
    ASSERT_TRUE(start.has_value());
    solver::QuadraticProgram bare;
    bare.fixed = program->fixed;
    bare.values = start->points;
    bare.ties = tieSeams(layout_);
    const solver::TiedPoints tied = solver::tiePoints(bare);
    EXPECT_LT(tied.residual, 1e-10);
    Random random{0};
    solver::Points z(tied.basis.cols(), 3);
    for (std::size_t k = 0; k < tied.free.size(); ++k) {
      const auto point = static_cast<std::size_t>(tied.free[k]);
      const double roughness = bare.fixed[point] ? 0.0 : 0.005;
      z.row(static_cast<Eigen::Index>(k)) =
          start->points.row(tied.free[k]) + roughness * randomVector(random).transpose();
    }
    patches_ = makePatches(layout_, tied.basis * z + tied.offset);
  }

  [[nodiscard]] spline::SurfaceJet jet(int patch, layout::PatchEdge edge, double t) const {
    const auto& surface = patches_[static_cast<std::size_t>(patch)];
    const Eigen::Vector2d at = onEdge(surface, edge, t);
    return surface.jet(at.x(), at.y());
  }

  layout::PatchLayout layout_;
  Patches patches_;
};

TEST_P(Ties, MakeTheNormalsAgreeWhereTheyAreAsked) {
  ASSERT_FALSE(layout_.seams.empty());
  for (const layout::Seam& seam : layout_.seams) {
    const auto knots =
        edgeKnots(layout_.patches[static_cast<std::size_t>(seam.first)], seam.firstEdge);
    const std::vector<double> sites = knots.grevilleAbscissae();
    for (std::size_t k = 0; k < sites.size(); ++k) {
      // Next to an end the derivative at the end is asked for in the place of this site.
      if (k == 1 || k + 2 == sites.size()) continue;
      const double t = sites[k] / knots.last();
      const auto first = jet(seam.first, seam.firstEdge, t);
      const auto second = jet(seam.second, seam.secondEdge, 1.0 - t);
      EXPECT_LT((first.point - second.point).norm(), 1e-12);
      const Eigen::Vector3d a = normalOf(first), b = normalOf(second);
      EXPECT_LT(a.cross(b).norm(), 1e-9);
      EXPECT_GT(a.dot(b), 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Seams,
    Ties,
    ::testing::Values(Hole{"Triangle", LayoutKind::Star, [] { return polygonOn(waves(), 3); }},
                      Hole{"Pentagon", LayoutKind::Star, [] { return polygonOn(waves(), 5); }},
                      Hole{"Octant", LayoutKind::Star, [] { return sphereOctant(1.0); }},
                      Hole{"Circle", LayoutKind::OGrid, [] { return circleOn(waves(), 1.0); }}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace fairing::constraint
