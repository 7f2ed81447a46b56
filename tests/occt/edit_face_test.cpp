// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/edit_face.h"

#include <gmock/gmock.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax2.hxx>

#include "occt/check_shape.h"
#include "occt/edge_curve.h"
#include "occt/reference.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using Eigen::Vector3d;

TopoDS_Shape wholeSheet() {
  return BRepBuilderAPI_MakeFace(wavedSheet(), Precision::Confusion()).Face();
}

TopoDS_Shape holedPlane() {
  const TopoDS_Shape cylinder =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 15, -5), gp_Dir(0, 0, 1)), 4.0, 20.0).Shape();
  return BRepAlgoAPI_Cut(box(30, 30, 10), cylinder).Shape();
}

Vector3d pointOn(const TopoDS_Edge& edge, double t) {
  return EdgeCurve(edge, Direction::Forward).point(t);
}

/// The number of the face at a height, z, on average.
int faceAt(const ShapeIndex& index, double z) {
  for (int k = 1; k <= index.faceCount(); ++k) {
    const ShapeIndex face(index.face(k));
    bool all = true;
    for (int e = 1; e <= face.edgeCount(); ++e)
      all = all && std::abs(pointOn(face.edge(e), 0.3).z() - z) < 1e-6;
    if (all) return k;
  }
  return 0;
}

/// Largest distance between the edges of two faces, in their order.
double edgesApart(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  const ShapeIndex one(a), two(b);
  EXPECT_EQ(one.edgeCount(), two.edgeCount());
  double apart = 0.0;
  for (int e = 1; e <= one.edgeCount(); ++e)
    for (int i = 0; i <= 10; ++i)
      apart =
          std::max(apart, (pointOn(one.edge(e), i / 10.0) - pointOn(two.edge(e), i / 10.0)).norm());
  return apart;
}

EditOptions pulledUp(double height, double gamma) {
  EditOptions options;
  options.guidance.gamma = gamma;
  options.guidance.reference = [height](const Vector3d& near) {
    return energy::GuidanceSample{
        Vector3d::UnitZ(), {near.x(), near.y(), near.z() + height}, 0.0, 1.0};
  };
  return options;
}

TEST(EditFace, MovesABsplineFaceWithinItsBorder) {
  const ShapeIndex index(wholeSheet());
  const auto edited = editFace(index, 1, pulledUp(2.0, 1e4));
  ASSERT_TRUE(edited.has_value());
  const EditReport& report = edited->edit.report;
  EXPECT_LE(report.borderMove, 1e-12 * report.diagonal);
  EXPECT_LE(report.borderTurn, 1e-9);
  EXPECT_GT(report.largestMove, 1.0);
  EXPECT_TRUE(report.notes.empty());
  EXPECT_FALSE(checkShape(edited->shape).has_value());
  EXPECT_LT(edgesApart(index.shape(), edited->shape), 1e-12);
  EXPECT_LE(largestTolerance(edited->shape), 1e-7);
}

TEST(EditFace, ATrimmedFaceKeepsItsTrim) {
  const ShapeIndex index(holedPlane());
  const int top = faceAt(index, 10.0);
  ASSERT_GT(top, 0);
  EditOptions options = pulledUp(1.0, 1e5);
  options.degree = 3;
  const auto coarse = editFace(index, top, options);
  ASSERT_FALSE(coarse.has_value());
  EXPECT_EQ(coarse.error().code, ErrorCode::NothingToMove);
  EXPECT_EQ(coarse.error().face, top);
  options.spans = 24;
  const auto edited = editFace(index, top, options);
  ASSERT_TRUE(edited.has_value()) << int(edited.error().code);
  const EditReport& report = edited->edit.report;
  EXPECT_LE(report.borderMove, 1e-12 * report.diagonal);
  EXPECT_LE(report.borderTurn, 1e-9);
  EXPECT_GT(report.largestMove, 0.3);
  EXPECT_TRUE(report.notes.empty());  // a plane is taken over exactly
  EXPECT_LT(edgesApart(index.face(top), edited->shape), 1e-12);
  EXPECT_GT(area(edited->shape), area(index.face(top)));
}

TEST(EditFace, ConvertsOtherFacesAndTellsHowClosely) {
  const ShapeIndex index(BRepPrimAPI_MakeCylinder(10.0, 20.0, 2.0).Shape());
  int side = 0;
  for (int k = 1; k <= index.faceCount(); ++k)
    if (std::abs(area(index.face(k)) - 400.0) < 1e-6) side = k;  // radius * angle * height
  ASSERT_GT(side, 0);
  EditOptions options;
  options.spans = 4;
  const auto edited = editFace(index, side, options);
  ASSERT_TRUE(edited.has_value()) << int(edited.error().code) << edited.error().detail;
  const EditReport& report = edited->edit.report;
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_EQ(report.notes[0].code, analysis::NoteCode::FaceConverted);
  EXPECT_EQ(report.notes[0].face, side);
  EXPECT_GT(report.notes[0].value, 0.0);
  EXPECT_LT(report.notes[0].value, 1e-5 * 30.0);
  EXPECT_LE(report.borderMove, 1e-12 * report.diagonal);
}

TEST(EditFace, ClosedFacesStayClosed) {
  const ShapeIndex index(BRepPrimAPI_MakeCylinder(10.0, 20.0).Shape());
  for (int k = 1; k <= index.faceCount(); ++k) {
    if (area(index.face(k)) < 1000.0) continue;  // the wall: 2 pi 10 * 20
    EditOptions options;
    options.guidance.gamma = 100.0;
    options.spans = 8;
    const auto edited = editFace(index, k, options);
    ASSERT_TRUE(edited.has_value()) << int(edited.error().code);
    const auto& s = edited->edit.surface;
    for (const double t : {0.1, 0.5, 0.8}) {
      const double v = s.v.first() + t * (s.v.last() - s.v.first());
      EXPECT_LT((s.evaluate(s.u.first(), v) - s.evaluate(s.u.last(), v)).norm(), 1e-4);
    }
  }
}

TEST(EditFace, TakesTheOldFacesPlaceInTheBase) {
  const ShapeIndex index(box(10, 20, 30));
  EditOptions options = pulledUp(1.0, 1e4);
  options.degree = 3;
  options.spans = 8;
  const int top = faceAt(index, 30.0);
  ASSERT_GT(top, 0);
  const auto edited = editFace(index, top, options, ResultMode::Base);
  ASSERT_TRUE(edited.has_value()) << int(edited.error().code) << edited.error().detail;
  EXPECT_FALSE(edited->trimmed);
  EXPECT_EQ(edited->shape.ShapeType(), TopAbs_SOLID);
  EXPECT_EQ(ShapeIndex(edited->shape).faceCount(), 6);
  EXPECT_EQ(ShapeIndex(edited->shape).edgeCount(), 12);
  EXPECT_NEAR(area(edited->shape), area(index.shape()) - 200.0 + area(edited->face), 1e-6);
  EXPECT_GT(area(edited->face), 200.0);
}

TEST(EditFace, NeedsAFaceThatIsThere) {
  const auto edited = editFace(ShapeIndex(box(1, 2, 3)), 7, {});
  ASSERT_FALSE(edited.has_value());
  EXPECT_EQ(edited.error().code, ErrorCode::FaceOutOfRange);
  EXPECT_EQ(edited.error().face, 7);
  EXPECT_EQ(edited.error().value, 6.0);
}

TEST(EditFace, TellsWhatAReferenceLeavesUncovered) {
  // The left half of the sheet, as the reference.
  double u0, u1, v0, v1;
  wavedSheet()->Bounds(u0, u1, v0, v1);
  const auto half = referenceOn(grid(wavedSheet(), {u0, 0.5 * (u0 + u1)}, {v0, v1}, {}));
  ASSERT_TRUE(half.has_value());
  EditOptions options;
  options.guidance.reference = *half;
  options.guidance.gamma = 10.0;
  const auto edited = editFace(ShapeIndex(wholeSheet()), 1, options);
  ASSERT_TRUE(edited.has_value());
  EXPECT_NEAR(edited->edit.report.after.covered, 0.5, 0.05);
}

}  // namespace
}  // namespace fairing::occt
