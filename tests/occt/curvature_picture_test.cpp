// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/curvature_picture.h"

#include <gmock/gmock.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <cmath>

#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
using analysis::CurvaturePicture;

constexpr int kMean = 0, kGauss = 1, kK1 = 2, kK2 = 3, kGradient = 4;

CurvaturePicture pictureOf(const TopoDS_Shape& shape, const std::vector<int>& faces = {}) {
  auto picture = curvaturePicture(ShapeIndex(shape), faces, 40);
  EXPECT_TRUE(picture.has_value());
  return std::move(*picture);
}

double areaOf(const CurvaturePicture& picture) {
  const analysis::Mesh mesh = picture.mesh();
  double sum = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](Eigen::Index k) {
      return Eigen::Vector3d(mesh.points.row(mesh.triangles(t, k)).transpose().cast<double>());
    };
    sum += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  return sum;
}

TEST(CurvaturePictureOfFaces, ACylinderFaceBendsAwayFromItsOutwardNormal) {
  const double radius = 8.0;
  const auto picture = pictureOf(BRepPrimAPI_MakeCylinder(radius, 30.0).Shape(), {1});
  const auto values = picture.values();
  ASSERT_GT(values.rows(), 500);
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    EXPECT_NEAR(values(k, kMean), -0.5 / radius, 1e-12);
    EXPECT_NEAR(values(k, kK1), 0.0, 1e-12);
    EXPECT_NEAR(values(k, kK2), -1.0 / radius, 1e-12);
    EXPECT_NEAR(values(k, kGradient), 0.0, 1e-12);
  }
  EXPECT_NEAR(areaOf(picture), 2.0 * M_PI * radius * 30.0, 2e-3 * areaOf(picture));
}

TEST(CurvaturePictureOfFaces, TheWallOfAHoleBendsTowardsItsNormal) {
  const TopoDS_Shape drilled = drilledBox(40, 20, 5);
  const auto picture = pictureOf(drilled);
  const auto values = picture.values();
  EXPECT_NEAR(values.col(kMean).maxCoeff(), 0.1, 1e-12);
  EXPECT_NEAR(values.col(kMean).minCoeff(), 0.0, 1e-12);
}

TEST(CurvaturePictureOfFaces, SpheresHaveNormalsAndCurvatureAtTheirPoles) {
  const double radius = 7.0;
  const auto picture = pictureOf(BRepPrimAPI_MakeSphere(radius).Shape());
  const analysis::Mesh mesh = picture.mesh();
  const auto values = picture.values();
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    const Eigen::Vector3f outwards = mesh.points.row(k).transpose().normalized();
    EXPECT_GT(mesh.normals.row(k).dot(outwards), 0.999F);
    EXPECT_NEAR(values(k, kMean), -1.0 / radius, 1e-6);
  }
}

TEST(CurvaturePictureOfFaces, ATorusHasTheGradientOfItsFormula) {
  const double ring = 20.0, tube = 6.0;
  const auto picture = pictureOf(BRepPrimAPI_MakeTorus(ring, tube).Shape());
  const analysis::Mesh mesh = picture.mesh();
  const auto values = picture.values();
  for (Eigen::Index k = 0; k < values.rows(); k += 7) {
    const double x = mesh.points(k, 0), y = mesh.points(k, 1);
    const double c = (std::hypot(x, y) - ring) / tube, s = mesh.points(k, 2) / tube;
    const double w = ring + tube * c;
    EXPECT_NEAR(values(k, kMean), -0.5 * (1.0 / tube + c / w), 1e-6);
    // dH/dv over the tube's radius; d(cos / w)/dv = -sin ring / w^2.
    EXPECT_NEAR(values(k, kGradient), std::abs(0.5 * s * ring / (w * w)) / tube, 1e-6);
  }
}

TEST(CurvaturePictureOfFaces, ATrimmedFaceIsDrawnWithinItsTrim) {
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(wavedSheet(), 1e-6).Shape();
  const gp_Ax2 axis(gp_Pnt(15, 14, -20), gp_Dir(0, 0, 1));
  const TopoDS_Shape holed =
      BRepAlgoAPI_Cut(face, BRepPrimAPI_MakeCylinder(axis, 6.0, 40.0).Shape()).Shape();
  const auto picture = pictureOf(holed);
  EXPECT_NEAR(areaOf(picture), area(holed), 2e-3 * area(holed));
  const analysis::Mesh mesh = picture.mesh();
  for (Eigen::Index k = 0; k < mesh.points.rows(); ++k)
    EXPECT_GT(std::hypot(mesh.points(k, 0) - 15.0F, mesh.points(k, 1) - 14.0F), 5.9F);
  const auto values = picture.values();
  EXPECT_TRUE(values.allFinite());
  EXPECT_GT(values.col(kGauss).maxCoeff() - values.col(kGauss).minCoeff(), 1e-6);
}

TEST(CurvaturePictureOfFaces, LeavesTheShapeWithoutTrianglesOfItsOwn) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(3.0, 5.0).Shape();
  const ShapeIndex index(shape);
  ASSERT_TRUE(curvaturePicture(index, {1}, 20).has_value());
  TopLoc_Location location;
  EXPECT_TRUE(BRep_Tool::Triangulation(index.face(1), location).IsNull());
}

TEST(CurvaturePictureOfFaces, NamesFacesThatAreNotThere) {
  const ShapeIndex index(box(1, 2, 3));
  const auto picture = curvaturePicture(index, {2, 9}, 20);
  ASSERT_FALSE(picture.has_value());
  EXPECT_EQ(picture.error().code, ErrorCode::FaceOutOfRange);
  EXPECT_EQ(picture.error().face, 9);
  EXPECT_EQ(pictureOf(compound({})).triangleCount(), 0);
}

}  // namespace
}  // namespace fairing::occt
