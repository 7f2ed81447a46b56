// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/known_surface.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace fairing::testing {

Eigen::Vector3d normalOf(const spline::SurfaceJet& jet) {
  return jet.normalVector().normalized();
}

Eigen::Matrix3d secondFormOf(const spline::SurfaceJet& jet) {
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << jet.u, jet.v;
  const Eigen::Vector3d n = normalOf(jet);
  Eigen::Matrix2d second;
  second << n.dot(jet.uu), n.dot(jet.uv), n.dot(jet.uv), n.dot(jet.vv);
  // The dual basis turns a tangent vector into its components along u and v.
  const Eigen::Matrix<double, 3, 2> dual = tangents * (tangents.transpose() * tangents).inverse();
  return dual * second * dual.transpose();
}

KnownSurface plane() {
  return surfaceOf([](const Jet2& u, const Jet2& v) { return JetPoint{u, v, 0.0}; });
}

KnownSurface sphere(double radius) {
  return surfaceOf([radius](const Jet2& u, const Jet2& v) {
    const Jet2 r(radius);
    return JetPoint{r * cos(v) * cos(u), r * cos(v) * sin(u), r * sin(v)};
  });
}

KnownSurface cylinder(double radius) {
  return surfaceOf([radius](const Jet2& u, const Jet2& v) {
    const Jet2 r(radius);
    return JetPoint{r * cos(u), r * sin(u), v};
  });
}

KnownSurface torus(double radius, double tube) {
  return surfaceOf([radius, tube](const Jet2& u, const Jet2& v) {
    const Jet2 ring = Jet2(radius) + Jet2(tube) * cos(v);
    return JetPoint{ring * cos(u), ring * sin(u), Jet2(tube) * sin(v)};
  });
}

KnownSurface saddle(double steepness) {
  return heightField(
      [steepness](const Jet2& x, const Jet2& y) { return Jet2(steepness) * (x * x - y * y); });
}

KnownSurface waves() {
  return heightField([](const Jet2& x, const Jet2& y) {
    return Jet2(0.15) * sin(Jet2(1.7) * x + Jet2(0.3)) * cos(Jet2(1.3) * y) + Jet2(0.1) * x * y;
  });
}

KnownSurface surfaceOf(const spline::BsplineSurface& surface) {
  return [surface](double u, double v) { return surface.jet(u, v); };
}

}  // namespace fairing::testing
