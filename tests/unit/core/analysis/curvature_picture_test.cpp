// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/curvature_picture.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

#include "core/analysis/curvature.h"
#include "support/known_jets.h"
#include "support/known_surface.h"
#include "support/numerical_derivative.h"
#include "support/random_splines.h"

namespace fairing::analysis {
namespace {

using namespace ::fairing::testing;  // NOLINT: known surfaces and random splines
using Eigen::Vector2d;
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

constexpr int kMean = 0, kGauss = 1, kK1 = 2, kK2 = 3, kGradient = 4;
constexpr double kClose = 1e-5;

BsplineSurface splineOf(const PointFunction& formula) {
  const KnotVector knots = KnotVector::fromBreaks(9, {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0});
  return interpolated(formula, knots, knots);
}

BsplineSurface splineOf(const KnownSurface& surface) {
  return splineOf([&](double u, double v) { return surface(u, v).point; });
}

// Of vertex (i, j) of a picture of one patch.
CurvatureValues valuesAt(const CurvaturePicture& picture, int cells, int i, int j) {
  return picture.values().row(i * (cells + 1) + j);
}

// A profile swept about the z axis, whose jets are exact.
PictureSurface revolved(const Profile& profile) {
  return {[profile](double u, double v) {
            const Vector2d at = profile(v, 0);
            return PlacedJet{Vector3d(at[0] * std::cos(u), at[0] * std::sin(u), at[1]),
                             revolvedJet(profile, u, v)};
          },
          false,
          7};
}

// Two triangles over a rectangle.
ParameterMesh rectangle(double u0, double u1, double v0, double v1) {
  return {{{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(CurvaturePicture, OfASphereIsOneValueEverywhere) {
  const auto picture = curvaturePicture({splineOf(sphere(2.0))}, {false}, 6);
  const auto values = picture.values();
  ASSERT_EQ(values.rows(), 49);
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    EXPECT_NEAR(values(k, kMean), -0.5, kClose);
    EXPECT_NEAR(values(k, kGauss), 0.25, kClose);
    EXPECT_NEAR(values(k, kK1), -0.5, 1e-2);  // the square root of a difference of equals
    EXPECT_NEAR(values(k, kK2), -0.5, 1e-2);
    EXPECT_NEAR(values(k, kGradient), 0.0, 1e-3);
  }
}

TEST(CurvaturePicture, OfACylinderAndOfItsReverse) {
  const BsplineSurface patch = splineOf(cylinder(4.0));
  const CurvatureValues out = valuesAt(curvaturePicture({patch}, {false}, 4), 4, 2, 1);
  EXPECT_NEAR(out[kMean], -0.125, kClose);
  EXPECT_NEAR(out[kK1], 0.0, kClose);
  EXPECT_NEAR(out[kK2], -0.25, kClose);
  const CurvatureValues in = valuesAt(curvaturePicture({patch}, {true}, 4), 4, 2, 1);
  EXPECT_NEAR(in[kMean], 0.125, kClose);
  EXPECT_NEAR(in[kK1], 0.25, kClose);
  EXPECT_NEAR(in[kK2], 0.0, kClose);
}

TEST(CurvaturePicture, OfATorus) {
  const double ring = 5.0, tube = 2.0;
  const auto meanAt = [&](double v) {
    return -0.5 * (1.0 / tube + std::cos(v) / (ring + tube * std::cos(v)));
  };
  const int cells = 4;
  const auto picture = curvaturePicture({splineOf(torus(ring, tube))}, {false}, cells);
  for (int j = 0; j <= cells; ++j) {
    const double v = double(j) / cells, around = std::cos(v) / (ring + tube * std::cos(v));
    const CurvatureValues values = valuesAt(picture, cells, 2, j);
    EXPECT_NEAR(values[kMean], meanAt(v), kClose);
    EXPECT_NEAR(values[kGauss], around / tube, kClose);
    EXPECT_NEAR(values[kK1], -around, kClose);
    EXPECT_NEAR(values[kK2], -1.0 / tube, kClose);
    EXPECT_NEAR(values[kGradient], std::abs(derivative(meanAt, v)) / tube, 1e-4);
  }
}

TEST(CurvaturePicture, OfASaddle) {
  const CurvatureValues values =
      valuesAt(curvaturePicture({splineOf(saddle(0.7))}, {false}, 5), 5, 0, 0);
  EXPECT_NEAR(values[kMean], 0.0, 1e-9);
  EXPECT_NEAR(values[kGauss], -1.96, 1e-8);
  EXPECT_NEAR(values[kK1], 1.4, 1e-8);
  EXPECT_NEAR(values[kK2], -1.4, 1e-8);
}

TEST(CurvaturePicture, GradientOnAnEllipsoidIsThatOfDifferences) {
  const auto ellipsoid = [](double u, double v) {
    return Vector3d(3.0 * std::cos(u) * std::cos(v), 2.0 * std::sin(u) * std::cos(v), std::sin(v));
  };
  const BsplineSurface patch = splineOf(ellipsoid);
  const int cells = 5;
  const CurvatureValues values = valuesAt(curvaturePicture({patch}, {false}, cells), cells, 2, 3);
  const double u = 0.4, v = 0.6;
  // Along an orthonormal frame: derivatives of H over a step in the parameters each makes.
  const spline::SurfaceJet jet = patch.jet(u, v);
  Eigen::Matrix2d metric;
  metric << jet.u.dot(jet.u), jet.u.dot(jet.v), jet.u.dot(jet.v), jet.v.dot(jet.v);
  const Vector2d slope(
      derivative([&](double x) { return curvatureAt(patch, x, v).mean; }, u, 1e-3),
      derivative([&](double x) { return curvatureAt(patch, u, x).mean; }, v, 1e-3));
  const double expected = std::sqrt(slope.dot(metric.ldlt().solve(slope)));
  EXPECT_NEAR(values[kGradient], expected, 1e-5 * expected);
  EXPECT_GT(expected, 0.1);
}

TEST(CurvaturePicture, RefinesUntilEdgesAreShortAndTurnLittle) {
  CurvaturePicture picture;
  picture.add(revolved(cylinderProfile(10.0)), rectangle(0.0, 1.5, 0.0, 30.0), {4.0, 5.0});
  const Mesh mesh = picture.mesh();
  std::map<std::pair<int, int>, int> uses;
  double area = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](Eigen::Index k) {
      return Vector3d(mesh.points.row(mesh.triangles(t, k % 3)).transpose().cast<double>());
    };
    const Vector3d normal = mesh.normals.row(mesh.triangles(t, 0)).transpose().cast<double>();
    const Vector3d across = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    EXPECT_GT(across.dot(normal), 0.0);
    area += 0.5 * across.norm();
    for (Eigen::Index k = 0; k < 3; ++k) {
      EXPECT_LE((corner(k) - corner(k + 1)).norm(), 4.0 + 1e-5);
      uses[std::minmax(mesh.triangles(t, k), mesh.triangles(t, (k + 1) % 3))]++;
    }
  }
  EXPECT_NEAR(area, 10.0 * 1.5 * 30.0, 1e-3 * area);
  // Every edge is shared by two triangles, but for the rectangle's own.
  for (const auto& [edge, count] : uses) {
    const auto isBorder = [&](int vertex) {
      const Eigen::RowVector3f p = mesh.points.row(vertex);
      const double angle = std::atan2(p[1], p[0]);
      return angle < 1e-4 || angle > 1.5 - 1e-4 || p[2] < 1e-4F || p[2] > 30.0F - 1e-4F;
    };
    if (count == 1) {
      EXPECT_TRUE(isBorder(edge.first) && isBorder(edge.second));
    } else {
      EXPECT_EQ(count, 2);
    }
  }
}

TEST(CurvaturePicture, APoleTakesWhatItsNeighbourhoodHas) {
  CurvaturePicture picture;
  picture.add(revolved(sphereProfile(3.0)), rectangle(0.0, 1.0, 1.0, 0.5 * M_PI));
  const Mesh mesh = picture.mesh();
  for (const int pole : {2, 3}) {
    EXPECT_NEAR(mesh.normals(pole, 2), 1.0, 1e-2);
    EXPECT_NEAR(picture.values()(pole, kMean), -1.0 / 3.0, 1e-6);
  }
}

TEST(CurvaturePicture, TellsTheSurfacesOwnCurvatureInsideATriangle) {
  const double ring = 5.0, tube = 2.0;
  CurvaturePicture picture;
  picture.add(revolved(torusProfile(ring, tube)), rectangle(0.0, 0.6, 0.0, 0.9));
  const CurvaturePlace place = picture.at(0, 0.25, 0.5);  // corners (0, 0), (0.6, 0), (0.6, 0.9)
  const double v = 0.45, around = std::cos(v) / (ring + tube * std::cos(v));
  EXPECT_EQ(place.number, 7);
  EXPECT_NEAR(place.values[kGauss], around / tube, 1e-12);
  EXPECT_NEAR(place.point.z(), tube * std::sin(v), 1e-12);
  EXPECT_NEAR(place.normal.norm(), 1.0, 1e-12);
}

TEST(CurvaturePicture, RangesLeaveOutlyingValuesOut) {
  // |H| grows towards the inner side of the torus; the picture holds a quarter of the tube.
  const auto picture = curvaturePicture({splineOf(torus(5.0, 2.0))}, {false}, 40);
  const auto [low, high] = picture.range(CurvatureQuantity::Mean);
  EXPECT_EQ(low, -high);
  const auto meanAt = [](double v) {
    return 0.5 * (0.5 + std::cos(v) / (5.0 + 2.0 * std::cos(v)));
  };
  EXPECT_GT(high, meanAt(0.2));
  EXPECT_LT(high, meanAt(0.0));
  const auto gradients = picture.range(CurvatureQuantity::MeanGradient);
  EXPECT_EQ(gradients.first, 0.0);
  EXPECT_GT(gradients.second, 0.0);
}

TEST(CurvaturePicture, RoundingHasNoColours) {
  const auto picture = curvaturePicture({splineOf(plane())}, {false}, 10);
  EXPECT_GT(picture.range(CurvatureQuantity::Mean).second, 1e-4);  // a unit square
  EXPECT_GT(picture.range(CurvatureQuantity::MeanGradient).second, 1e-4);
  EXPECT_LT(picture.values().cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace fairing::analysis
