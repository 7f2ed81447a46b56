// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/mesh_reference.h"

#include <gmock/gmock.h>

#include <cmath>

#include "occt/reference.h"
#include "occt/shape_bytes.h"
#include "occt/shapes.h"
#include "support/matchers.h"

namespace fairing::occt {
namespace {

using namespace ::fairing::testing;  // NOLINT: shapes and matchers
using Eigen::Vector3d;
using Corners = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

constexpr int kCells = 40;

struct Mesh {
  Corners points;
  Triangles triangles;
};

// A sheet over [0, 10]^2.
Mesh meshOver(double (*height)(double x, double y)) {
  Mesh mesh{Corners((kCells + 1) * (kCells + 1), 3), Triangles(2 * kCells * kCells, 3)};
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kCells; ++j) {
      const double x = 10.0 * i / kCells, y = 10.0 * j / kCells;
      mesh.points.row(i * (kCells + 1) + j) << x, y, height(x, y);
    }
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j) {
      const int a = i * (kCells + 1) + j, b = a + kCells + 1;
      mesh.triangles.row(2 * (i * kCells + j)) << a, b, b + 1;
      mesh.triangles.row(2 * (i * kCells + j) + 1) << a, b + 1, a + 1;
    }
  return mesh;
}

double flat(double, double) {
  return 1.0;
}
double wave(double x, double y) {
  return 0.5 * std::sin(0.6 * x) * std::cos(0.4 * y);
}
Vector3d waveNormal(double x, double y) {
  return Vector3d(-0.3 * std::cos(0.6 * x) * std::cos(0.4 * y),
                  0.2 * std::sin(0.6 * x) * std::sin(0.4 * y),
                  1.0)
      .normalized();
}

TEST(MeshReference, FindsFeetOnAPlane) {
  const Mesh mesh = meshOver(flat);
  const auto reference = referenceOn(*meshFace(mesh.points, mesh.triangles));
  ASSERT_TRUE(reference.has_value());
  for (const Vector3d& p : {Vector3d(3.3, 4.4, 2.0), Vector3d(0.1, 9.9, -5.0)}) {
    const auto sample = (*reference)(p);
    EXPECT_THAT(sample.point, IsNear(Vector3d(p.x(), p.y(), 1.0), 1e-12));
    EXPECT_THAT(sample.normal, IsNear(Vector3d(Vector3d::UnitZ()), 1e-12));
    EXPECT_EQ(sample.lambda, 1.0);
  }
}

TEST(MeshReference, HasSmoothNormals) {
  const Mesh mesh = meshOver(wave);
  const auto reference = referenceOn(*meshFace(mesh.points, mesh.triangles));
  ASSERT_TRUE(reference.has_value());
  for (double x = 1.0; x < 9.0; x += 0.7)
    for (double y = 1.0; y < 9.0; y += 0.7) {
      const Vector3d normal = waveNormal(x, y);
      const auto sample = (*reference)(Vector3d(x, y, wave(x, y)) + 0.3 * normal);
      EXPECT_LT(std::acos(std::min(1.0, sample.normal.dot(normal))), 0.01);
      EXPECT_LT((sample.point - Vector3d(x, y, wave(x, y))).norm(), 0.01);
    }
}

TEST(MeshReference, WeighsNothingBesideItsBorder) {
  const Mesh mesh = meshOver(flat);
  const auto reference = referenceOn(*meshFace(mesh.points, mesh.triangles));
  ASSERT_TRUE(reference.has_value());
  EXPECT_EQ((*reference)({10.0, 5.0, 3.0}).gamma, 1.0);
  EXPECT_EQ((*reference)({12.0, 5.0, 3.0}).gamma, 0.0);
  EXPECT_EQ((*reference)({12.0, 12.0, 1.0}).lambda, 0.0);
}

TEST(MeshReference, GoesBesideFacesInOneShape) {
  const Mesh mesh = meshOver(flat);
  const auto both =
      referenceOn(compound({*meshFace(mesh.points, mesh.triangles),
                            polygon({{20, 0, 0}, {40, 0, 0}, {40, 20, 0}, {20, 20, 0}})}));
  ASSERT_TRUE(both.has_value());
  EXPECT_THAT((*both)({5, 5, 4}).point, IsNear(Vector3d(5, 5, 1), 1e-12));
  EXPECT_THAT((*both)({25, 5, 4}).point, IsNear(Vector3d(25, 5, 0), 1e-9));
}

TEST(MeshReference, IsStoredAsAShape) {
  const Mesh mesh = meshOver(flat);
  const auto bytes = bytesFromShape(*meshFace(mesh.points, mesh.triangles));
  ASSERT_TRUE(bytes.has_value());
  const auto reference = referenceOn(*shapeFromBytes(*bytes));
  ASSERT_TRUE(reference.has_value());
  EXPECT_THAT((*reference)({5, 5, 4}).point, IsNear(Vector3d(5, 5, 1), 1e-9));
}

TEST(MeshReference, RefusesFlippedTriangles) {
  Mesh mesh = meshOver(flat);
  std::swap(mesh.triangles(100, 0), mesh.triangles(100, 1));
  const auto face = meshFace(mesh.points, mesh.triangles);
  ASSERT_THAT(face, FailsWith(ErrorCode::MeshFlipped));
  EXPECT_EQ(face.error().value, 3.0);
}

TEST(MeshReference, RefusesCornersThatAreNotThere) {
  Mesh mesh = meshOver(flat);
  mesh.triangles(0, 0) = 99999;
  EXPECT_THAT(meshFace(mesh.points, mesh.triangles), FailsWith(ErrorCode::MeshInvalid));
  EXPECT_THAT(meshFace(mesh.points, Triangles()), FailsWith(ErrorCode::MeshInvalid));
}

}  // namespace
}  // namespace fairing::occt
