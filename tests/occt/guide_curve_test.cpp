// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/guide_curve.h"

#include <gmock/gmock.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Circ.hxx>

#include "occt/shapes.h"
#include "support/matchers.h"

namespace fairing::occt {
namespace {

using namespace ::fairing::testing;  // NOLINT: shapes and matchers
using Eigen::Vector3d;

TopoDS_Shape segment(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(from, to).Edge();
}

TEST(GuideCurve, RunsAlongEdgesInAnyOrder) {
  const auto curve = guideCurve(compound({segment({10, 0, 0}, {20, 0, 0}),
                                          segment({10, 0, 0}, {0, 0, 0}),
                                          segment({20, 0, 0}, {30, 0, 0})}),
                                {},
                                Vector3d(1, 0, 1));
  ASSERT_TRUE(curve.has_value());
  EXPECT_NEAR((curve->points.front() - curve->points.back()).norm(), 30.0, 1e-9);
  for (std::size_t k = 1; k < curve->points.size(); ++k)
    EXPECT_NEAR((curve->points[k] - curve->points[k - 1]).norm(),
                30.0 / double(curve->points.size() - 1),
                1e-6);
  for (const Vector3d& normal : curve->normals)  // turned square to the curve
    EXPECT_THAT(normal, IsNear(Vector3d(Vector3d::UnitZ()), 1e-12));
}

TEST(GuideCurve, TakesTheNormalsOfFaces) {
  const gp_Circ equator(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 10.0);
  const auto curve = guideCurve(BRepBuilderAPI_MakeEdge(equator, 0.3, 1.7).Edge(),
                                BRepPrimAPI_MakeSphere(10.0).Shape(),
                                std::nullopt);
  ASSERT_TRUE(curve.has_value());
  for (std::size_t k = 0; k < curve->points.size(); ++k)
    EXPECT_THAT(curve->normals[k], IsNear(curve->points[k].normalized(), 1e-7));
}

TEST(GuideCurve, TellsWhatIsWrong) {
  const TopoDS_Shape line = segment({0, 0, 0}, {10, 0, 0});
  EXPECT_THAT(guideCurve(compound({line, segment({20, 0, 0}, {30, 0, 0})}), {}, Vector3d(0, 0, 1)),
              FailsWith(ErrorCode::GuideCurveBroken));
  EXPECT_THAT(guideCurve(line, {}, std::nullopt), FailsWith(ErrorCode::GuideCurveBare));
  EXPECT_THAT(guideCurve(line, {}, Vector3d(2, 0, 0)), FailsWith(ErrorCode::GuideCurveAlong));
}

}  // namespace
}  // namespace fairing::occt
