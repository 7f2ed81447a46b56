// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/join.h"

#include <gmock/gmock.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include "occt/fill_shape.h"
#include "occt/read_boundary.h"
#include "occt/shapes.h"
#include "text/error_text.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using ::testing::HasSubstr;

/// The top of a box, lifted on the side of x = 10 by 0.5 mm.
JoinPart tiltedLid(const ShapeIndex& box, int top) {
  const auto loop = readBoundary(box, {.faces = {top}, .continuity = Continuity::G0});
  gp_Trsf tilt;
  tilt.SetRotation(gp_Ax1(gp_Pnt(0, 0, 30), gp_Dir(0, -1, 0)), 0.05);
  const TopoDS_Shape lid = BRepBuilderAPI_Transform(box.face(top), tilt, true).Shape();
  return {lid, loop ? *loop : boundary::BoundaryLoop{}, 1e-7};
}

int topOf(const ShapeIndex& box) {
  for (int face = 1; face <= box.faceCount(); ++face) {
    bool onTop = true;
    const auto loop = readBoundary(box, {.faces = {face}, .continuity = Continuity::G0});
    for (const auto& side : loop->sides) onTop = onTop && side.ribbon.curve(0.5).point.z() > 29.9;
    if (onTop) return face;
  }
  return 0;
}

TEST(JoinResult, SaysWhichEdgesStayFreeAndHowFarOffTheyAre) {
  const ShapeIndex index(box(10, 20, 30));
  const int top = topOf(index);
  ASSERT_GT(top, 0);
  const auto joined = joinResult(index, {top}, {tiltedLid(index, top)}, ResultMode::Base);
  ASSERT_FALSE(joined.has_value());
  EXPECT_EQ(joined.error().code, ErrorCode::SewingOpen);
  EXPECT_GE(joined.error().value, 3.0);
  const int raised = edgesNear(index, {{10, 10, 30}})[0];
  EXPECT_THAT(joined.error().detail, HasSubstr("edge " + std::to_string(raised) + ": 0.5 mm"));
  EXPECT_THAT(text::sentence(joined.error()), HasSubstr("edge " + std::to_string(raised)));
}

TEST(JoinResult, KeepsACavityWithinItsSolid) {
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(3, 3, 3));
  const TopoDS_Shape inner = BRepBuilderAPI_Transform(box(4, 4, 4), shift, true).Shape();
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(box(10, 20, 30), inner).Shape();
  const ShapeIndex index(hollow);
  ASSERT_EQ(index.faceCount(), 12);
  for (int face = 1; face <= 12; ++face) {
    const auto filled =
        fillShape(index, {.faces = {face}, .continuity = Continuity::G0}, {}, ResultMode::Base);
    ASSERT_TRUE(filled.has_value());
    EXPECT_EQ(filled->shape.ShapeType(), TopAbs_SOLID) << face;
    EXPECT_TRUE(BRepCheck_Analyzer(filled->shape).IsValid()) << face;
    EXPECT_NEAR(volume(filled->shape), 6000.0 - 64.0, 1e-6) << face;
  }
}

TEST(JoinResult, KeepsSolidsBesideEachOtherApart) {
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(50, 0, 0));
  const TopoDS_Shape two =
      compound({box(10, 20, 30), BRepBuilderAPI_Transform(box(1, 2, 3), shift, true).Shape()});
  const ShapeIndex index(two);
  const auto filled =
      fillShape(index, {.faces = {1}, .continuity = Continuity::G0}, {}, ResultMode::Base);
  ASSERT_TRUE(filled.has_value());
  EXPECT_EQ(filled->shape.ShapeType(), TopAbs_COMPOUND);
  EXPECT_NEAR(volume(filled->shape), 6006.0, 1e-6);
}

}  // namespace
}  // namespace fairing::occt
