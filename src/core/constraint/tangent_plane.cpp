// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/tangent_plane.h"

#include <Eigen/Geometry>

#include "core/boundary/constraint_normal.h"
#include "core/spline/bspline_basis.h"

namespace fairing::constraint {
namespace {

using Eigen::Vector3d;

// Normals of the two sides farther apart than this (about 6 degrees) are two conditions on the
// twist, not one measured twice; closer together the two rows would be nearly dependent and magnify
// the noise.
constexpr double kSeparateNormals = 0.1;

// What one side knows at a corner, in the patch's parameters.
struct CornerNormal {
  Vector3d normal, derivative;
};

CornerNormal cornerNormal(const ConstrainedEdge& edge, bool atStart) {
  const auto& ribbon = edge.side->ribbon;
  const double t = edge.sideParameter(atStart ? edge.knots.first() : edge.knots.last());
  return {constraintNormal(ribbon, t),
          boundary::constraintNormalDerivativeAtEnd(ribbon, atStart) * edge.rate()};
}

Error singularAt(const ConstrainedEdge& edge, double s) {
  const double t = edge.sideParameter(s);
  return {ErrorCode::SupportNormalSingular,
          edge.side->edge,
          edge.side->face,
          edge.side->ribbon.curve(t).point};
}

// The corner's control points, seen along `before` (u, arriving) and `after` (v, leaving):
//   R_u = (corner - back) / hu,   R_v = (on - corner) / hv,   R_uv = (on - corner - inside + back)
//   / (hu hv)
struct CornerFrame {
  Vector3d corner, back, on;
  double hu, hv;
  int inside;
};

CornerFrame cornerFrame(const ConstrainedEdge& before, const ConstrainedEdge& after) {
  const auto& a = before.use->curve;
  const auto& b = after.use->curve;
  const auto na = static_cast<std::size_t>(a.knots.poleCount());
  const auto p = static_cast<std::size_t>(a.knots.degree()),
             q = static_cast<std::size_t>(b.knots.degree());
  CornerFrame frame;
  frame.corner = a.poles.row(a.poles.rows() - 1);
  frame.back = a.poles.row(a.poles.rows() - 2);
  frame.on = b.poles.row(1);
  frame.hu = (a.knots.last() - a.knots.knots()[na - 1]) / static_cast<double>(p);
  frame.hv = (b.knots.knots()[q + 1] - b.knots.first()) / static_cast<double>(q);
  frame.inside = after.inner[1];
  return frame;
}

solver::LinearRow twistRow(const CornerFrame& f, const Vector3d& normal, double twist) {
  return {{f.inside}, {normal}, normal.dot(f.on - f.corner + f.back) - twist * f.hu * f.hv};
}

}  // namespace

Result<std::optional<solver::ConstraintBlock>> cornerTwist(const ConstrainedEdge& before,
                                                           const ConstrainedEdge& after) {
  if (!before.isTangent() && !after.isTangent()) return std::nullopt;
  const CornerFrame f = cornerFrame(before, after);
  const Vector3d u = (f.corner - f.back) / f.hu, v = (f.on - f.corner) / f.hv;
  solver::ConstraintBlock block;
  block.solvedFor = {f.inside};
  std::vector<std::pair<Vector3d, double>> asked;  // normal and twist
  if (before.isTangent()) {
    const CornerNormal n = cornerNormal(before, false);
    if (!n.derivative.allFinite()) return fail(singularAt(before, before.knots.last()));
    asked.emplace_back(n.normal, -v.dot(n.derivative));
  }
  if (after.isTangent()) {
    const CornerNormal n = cornerNormal(after, true);
    if (!n.derivative.allFinite()) return fail(singularAt(after, after.knots.first()));
    asked.emplace_back(n.normal, -u.dot(n.derivative));
  }
  const bool two = asked.size() == 2;
  if (two && asked[0].first.dot(asked[1].first) < 0.0)
    asked[1] = {-asked[1].first, -asked[1].second};
  if (two && asked[0].first.cross(asked[1].first).norm() < kSeparateNormals) {
    const Vector3d normal = (asked[0].first + asked[1].first).normalized();
    asked = {{normal, 0.5 * (asked[0].second + asked[1].second)}};
  }
  for (const auto& [normal, twist] : asked) block.rows.push_back(twistRow(f, normal, twist));
  return block;
}

Result<solver::ConstraintBlock> tangentRows(const ConstrainedEdge& edge) {
  solver::ConstraintBlock block;
  const int n = edge.knots.poleCount();
  const auto pole = [&](int i) { return edge.use->curve.poles.row(i); };
  for (int i = 2; i < n - 2; ++i) {
    const double s = edge.knots.greville(i);
    const Vector3d normal = constraintNormal(edge.side->ribbon, edge.sideParameter(s));
    if (!normal.allFinite()) return fail(singularAt(edge, s));
    const spline::BasisRow basis = spline::basisRow(edge.knots, s);
    solver::LinearRow row;
    for (int k = 0; k <= edge.knots.degree(); ++k) {
      const double b = basis.values(0, k);
      row.points.push_back(edge.inner[static_cast<std::size_t>(basis.first + k)]);
      row.weights.push_back(b * normal);
      row.right += b * pole(basis.first + k).dot(normal);
    }
    block.rows.push_back(std::move(row));
    block.solvedFor.push_back(edge.inner[static_cast<std::size_t>(i)]);
  }
  return block;
}

}  // namespace fairing::constraint
