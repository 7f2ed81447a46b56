// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bspline_surface.h"

#include <Eigen/Geometry>

#include "core/spline/bspline_basis.h"

namespace fairing::spline {
namespace {

// Applies a change of curve to every column of control points (fixed j), which runs along u.
template <class Change>
BsplineSurface changedAlongU(const BsplineSurface& surface, const Change& change) {
  const int columns = surface.v.poleCount();
  BsplineSurface result;
  result.v = surface.v;
  for (int j = 0; j < columns; ++j) {
    BsplineCurve column{surface.u, Poles(surface.u.poleCount(), 3)};
    for (int i = 0; i < surface.u.poleCount(); ++i)
      column.poles.row(i) = surface.pole(i, j).transpose();
    const BsplineCurve changed = change(column);
    if (j == 0) {
      result.u = changed.knots;
      result.poles.resize(changed.knots.poleCount() * columns, 3);
    }
    for (int i = 0; i < changed.knots.poleCount(); ++i)
      result.poles.row(result.index(i, j)) = changed.poles.row(i);
  }
  return result;
}

}  // namespace

Eigen::Vector3d SurfaceJet::normalVector() const {
  return u.cross(v);
}

Eigen::Vector3d BsplineSurface::evaluate(double s, double t, int a, int b) const {
  const BasisRow bu = basisRow(u, s, a);
  const BasisRow bv = basisRow(v, t, b);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i <= u.degree(); ++i) {
    const auto rows = poles.middleRows(index(bu.first + i, bv.first), v.degree() + 1);
    sum += bu.values(a, i) * (bv.values.row(b) * rows).transpose();
  }
  return sum;
}

SurfaceJet BsplineSurface::jet(double s, double t) const {
  const BasisRow bu = basisRow(u, s, 2);
  const BasisRow bv = basisRow(v, t, 2);
  Eigen::Matrix3d sums[3];  // sums[a].row(b): derivative a along u, b along v
  for (auto& m : sums) m.setZero();
  for (int i = 0; i <= u.degree(); ++i) {
    const auto rows = poles.middleRows(index(bu.first + i, bv.first), v.degree() + 1);
    const Eigen::Matrix3d along = bv.values.topRows<3>() * rows;
    for (int a = 0; a < 3; ++a) sums[a] += bu.values(a, i) * along;
  }
  return {sums[0].row(0),
          sums[1].row(0),
          sums[0].row(1),
          sums[2].row(0),
          sums[1].row(1),
          sums[0].row(2)};
}

Partials BsplineSurface::derivatives(double s, double t, int order) const {
  const BasisRow bu = basisRow(u, s, order), bv = basisRow(v, t, order);
  const int n = order + 1;
  Partials result = Partials::Zero(3, n * n);
  for (int i = 0; i <= u.degree(); ++i) {
    const auto rows = poles.middleRows(index(bu.first + i, bv.first), v.degree() + 1);
    const Partials along = (bv.values.topRows(n) * rows).transpose();
    for (int a = 0; a < n; ++a) result.middleCols(a * n, n) += bu.values(a, i) * along;
  }
  return result;
}

BsplineSurface transposed(const BsplineSurface& surface) {
  BsplineSurface result{surface.v, surface.u, Poles(surface.poles.rows(), 3)};
  for (int i = 0; i < surface.u.poleCount(); ++i)
    for (int j = 0; j < surface.v.poleCount(); ++j)
      result.poles.row(result.index(j, i)) = surface.poles.row(surface.index(i, j));
  return result;
}

BsplineSurface refinedTo(const BsplineSurface& surface, const KnotVector& u, const KnotVector& v) {
  const auto along = [](const KnotVector& knots) {
    return [&knots](const BsplineCurve& c) { return refinedTo(c, knots); };
  };
  return transposed(changedAlongU(transposed(changedAlongU(surface, along(u))), along(v)));
}

BsplineSurface raiseDegree(const BsplineSurface& surface, int timesU, int timesV) {
  const auto by = [](int times) {
    return [times](const BsplineCurve& c) { return raiseDegree(c, times); };
  };
  return transposed(changedAlongU(transposed(changedAlongU(surface, by(timesU))), by(timesV)));
}

}  // namespace fairing::spline
