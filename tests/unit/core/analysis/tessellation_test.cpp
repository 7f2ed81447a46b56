// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/tessellation.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "support/random_splines.h"

namespace fairing::analysis {
namespace {

using namespace ::fairing::testing;  // NOLINT: random splines
using Eigen::Vector3f;

spline::BsplineSurface somePatch() {
  Random random{0};
  const auto knots = randomKnots(random, 4, 2);
  return randomSurface(random, knots, knots, 0.05);
}

// Every triangle's normal against those of its vertices.
bool facesItsNormals(const Mesh& mesh) {
  for (Eigen::Index k = 0; k < mesh.triangles.rows(); ++k) {
    const Vector3f a = mesh.points.row(mesh.triangles(k, 0)).transpose();
    const Vector3f b = mesh.points.row(mesh.triangles(k, 1)).transpose();
    const Vector3f c = mesh.points.row(mesh.triangles(k, 2)).transpose();
    const Vector3f normal = mesh.normals.row(mesh.triangles(k, 0)).transpose();
    if ((b - a).cross(c - a).dot(normal) <= 0.0F) return false;
  }
  return true;
}

TEST(Tessellate, HasAGridPerPatch) {
  const Mesh mesh = tessellate({somePatch(), somePatch()}, {false, true}, 5);
  EXPECT_EQ(mesh.points.rows(), 2 * 36);
  EXPECT_EQ(mesh.normals.rows(), 2 * 36);
  EXPECT_EQ(mesh.triangles.rows(), 2 * 50);
  EXPECT_EQ(mesh.triangles.minCoeff(), 0);
  EXPECT_EQ(mesh.triangles.maxCoeff(), 2 * 36 - 1);
}

TEST(Tessellate, VerticesLieOnThePatch) {
  const auto patch = somePatch();
  const Mesh mesh = tessellate({patch}, {false}, 4);
  const Eigen::Vector3d expected = patch.evaluate(0.25, 0.75);  // vertex (1, 3)
  EXPECT_LT((mesh.points.row(1 * 5 + 3).transpose().cast<double>() - expected).norm(), 1e-6);
}

TEST(Tessellate, TrianglesRunCounterClockwiseAboutTheNormal) {
  EXPECT_TRUE(facesItsNormals(tessellate({somePatch()}, {false}, 6)));
}

TEST(Tessellate, ReversalTurnsTrianglesAndNormals) {
  const Mesh plain = tessellate({somePatch()}, {false}, 6);
  const Mesh turned = tessellate({somePatch()}, {true}, 6);
  EXPECT_TRUE(facesItsNormals(turned));
  EXPECT_EQ(plain.points, turned.points);
  EXPECT_EQ(plain.normals, -turned.normals);
}

}  // namespace
}  // namespace fairing::analysis
