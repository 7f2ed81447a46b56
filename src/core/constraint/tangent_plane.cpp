// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/tangent_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

// Nothing where the side asks for no normal or its support has none.
std::optional<CornerNormal> cornerNormal(const ConstrainedEdge& edge, bool atStart) {
  if (!edge.isTangentAt(atStart ? 0.0 : 1.0)) return std::nullopt;
  const auto& ribbon = edge.side->ribbon;
  const CornerNormal n{constraintNormal(ribbon, atStart ? 0.0 : 1.0),
                       boundary::constraintNormalDerivativeAtEnd(ribbon, atStart) * edge.rate()};
  if (!n.normal.allFinite() || !n.derivative.allFinite()) return std::nullopt;
  return n;
}

Error singularAt(const ConstrainedEdge& edge, double s) {
  const double t = edge.sideParameter(s);
  return {ErrorCode::SupportNormalSingular,
          edge.side->edge,
          edge.side->face,
          edge.side->ribbon.curve(t).point};
}

// The direction in the tangent plane that R_v must not have a share of, for it to leave as asked.
std::optional<Vector3d> forbiddenDirection(const ConstrainedEdge& edge,
                                           double s,
                                           const Vector3d& normal) {
  const auto& ribbon = edge.side->ribbon;
  const double t = edge.sideParameter(s);
  switch (edge.side->departure) {
    case boundary::Departure::Perpendicular:
      return ribbon.curve(t).derivative.normalized();
    case boundary::Departure::Iso:
      return normal.cross(ribbon.support(t).iso).normalized();
    case boundary::Departure::Free:
      break;
  }
  return std::nullopt;
}

// The same at a corner, and its derivative along the edge.
std::optional<CornerNormal> cornerDeparture(const ConstrainedEdge& edge, bool atStart) {
  constexpr double kStep = 1e-4;  // of the edge
  if (edge.side->departure == boundary::Departure::Free || !edge.isTangentAt(atStart ? 0.0 : 1.0))
    return std::nullopt;
  const double h = (atStart ? kStep : -kStep) / edge.rate();
  const double s = atStart ? edge.knots.first() : edge.knots.last();
  const auto at = [&](double place) -> Vector3d {
    const Vector3d normal = constraintNormal(edge.side->ribbon, edge.sideParameter(place));
    return *forbiddenDirection(edge, place, normal);
  };
  const CornerNormal n{at(s), (-3.0 * at(s) + 4.0 * at(s + h) - at(s + 2.0 * h)) / (2.0 * h)};
  if (!n.normal.allFinite() || !n.derivative.allFinite()) return std::nullopt;
  return n;
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

// Normals that agree but for noise are set to their mean. Whether they do.
bool meanOfAgreeing(CornerNormal& a, CornerNormal& b) {
  if (a.normal.dot(b.normal) < 0.0) b = {-b.normal, -b.derivative};
  if (a.normal.cross(b.normal).norm() >= kSeparateNormals) return false;
  a.normal = b.normal = (a.normal + b.normal).normalized();
  return true;
}

// The derivative of R_v . n along an edge at its start or end: with the edge's poles known,
//   sum_i (B_i' n + B_i n') . (inner_i - outer_i) = 0.
solver::LinearRow derivativeRow(const ConstrainedEdge& edge, const CornerNormal& n, bool atStart) {
  const spline::BasisRow basis =
      spline::basisRow(edge.knots, atStart ? edge.knots.first() : edge.knots.last(), 1);
  solver::LinearRow row;
  for (int k = 0; k <= edge.knots.degree(); ++k) {
    const int i = basis.first + k;
    const Vector3d weight = basis.values(1, k) * n.normal + basis.values(0, k) * n.derivative;
    if (weight.isZero(0.0)) continue;
    row.points.push_back(edge.inner[static_cast<std::size_t>(i)]);
    row.weights.push_back(weight);
    row.right += weight.dot(edge.use->curve.poles.row(i));
  }
  return row;
}

// The periodic spline has the inner knots and one at its seam. The poles beyond are tied to the
// first ones (tieClosing).
std::vector<Collocation> periodicCollocation(const spline::KnotVector& knots) {
  const auto p = static_cast<std::size_t>(knots.degree());
  const std::vector<double>& all = knots.knots();
  const std::vector<double> round(all.begin() + static_cast<std::ptrdiff_t>(p),
                                  all.end() - static_cast<std::ptrdiff_t>(p) - 1);
  const double period = knots.last() - knots.first();
  std::vector<Collocation> places;
  for (std::size_t i = 0; i < round.size(); ++i) {
    double mean = 0.0;
    for (std::size_t k = i + 1; k <= i + p; ++k)
      mean += (round[k % round.size()] + static_cast<double>(k / round.size()) * period) /
              static_cast<double>(p);
    const double turns = std::floor((mean - knots.first()) / period);
    places.push_back({static_cast<int>(i), mean - turns * period});
  }
  return places;
}

// R_v . direction = 0 at a parameter of the patch.
solver::LinearRow perpendicularRow(const ConstrainedEdge& edge,
                                   double s,
                                   const Vector3d& direction) {
  const spline::BasisRow basis = spline::basisRow(edge.knots, s);
  solver::LinearRow row;
  for (int k = 0; k <= edge.knots.degree(); ++k) {
    const double b = basis.values(0, k);
    row.points.push_back(edge.inner[static_cast<std::size_t>(basis.first + k)]);
    row.weights.push_back(b * direction);
    row.right += b * edge.use->curve.poles.row(basis.first + k).dot(direction);
  }
  return row;
}

// Rows of unit size, lest the rank depend on the knots.
solver::LinearRow scaled(solver::LinearRow row) {
  double largest = 0.0;
  for (const Vector3d& w : row.weights) largest = std::max(largest, w.norm());
  for (Vector3d& w : row.weights) w /= largest;
  row.right /= largest;
  return row;
}

}  // namespace

std::optional<solver::ConstraintBlock> cornerTwist(const ConstrainedEdge& before,
                                                   const ConstrainedEdge& after) {
  const CornerFrame f = cornerFrame(before, after);
  const Vector3d u = (f.corner - f.back) / f.hu, v = (f.on - f.corner) / f.hv;
  std::vector<std::pair<Vector3d, double>> asked;  // normal and twist
  if (const auto n = cornerNormal(before, false))
    asked.emplace_back(n->normal, -v.dot(n->derivative));
  if (const auto n = cornerNormal(after, true))
    asked.emplace_back(n->normal, -u.dot(n->derivative));
  if (asked.empty()) return std::nullopt;
  const bool two = asked.size() == 2;
  if (two && asked[0].first.dot(asked[1].first) < 0.0)
    asked[1] = {-asked[1].first, -asked[1].second};
  if (two && asked[0].first.cross(asked[1].first).norm() < kSeparateNormals) {
    const Vector3d normal = (asked[0].first + asked[1].first).normalized();
    asked = {{normal, 0.5 * (asked[0].second + asked[1].second)}};
  }
  if (const auto d = cornerDeparture(before, false))
    asked.emplace_back(d->normal, -v.dot(d->derivative));
  if (const auto d = cornerDeparture(after, true))
    asked.emplace_back(d->normal, -u.dot(d->derivative));
  solver::ConstraintBlock block;
  block.solvedFor = {f.inside};
  for (const auto& [normal, twist] : asked) block.rows.push_back(twistRow(f, normal, twist));
  return block;
}

std::optional<solver::ConstraintBlock> splitTangency(const ConstrainedEdge& before,
                                                     const ConstrainedEdge& after,
                                                     const boundary::Corner& corner) {
  auto a = cornerNormal(before, false), b = cornerNormal(after, true);
  if (!a && !b) return std::nullopt;
  if (a && b && meanOfAgreeing(*a, *b) && corner.isNearlyStraight()) {
    const double speedBefore = before.rate() * before.side->ribbon.curve(1.0).derivative.norm();
    const double speedAfter = after.rate() * after.side->ribbon.curve(0.0).derivative.norm();
    const Vector3d turn = 0.5 * (a->derivative / speedBefore + b->derivative / speedAfter);
    a->derivative = speedBefore * turn;
    b->derivative = speedAfter * turn;
  }
  const std::size_t n = before.inner.size();
  const int spoke = after.inner.front();
  const Vector3d vertex = after.use->curve.poles.row(0);
  solver::ConstraintBlock block;
  block.solvedFor = {spoke, before.inner[n - 2], after.inner[1]};
  const auto leave = [&](const Vector3d& normal) {
    block.rows.push_back({{spoke}, {normal}, vertex.dot(normal)});
  };
  if (a) leave(a->normal);
  if (b && (!a || a->normal != b->normal)) leave(b->normal);
  if (a) block.rows.push_back(scaled(derivativeRow(before, *a, false)));
  if (b) block.rows.push_back(scaled(derivativeRow(after, *b, true)));
  return block;
}

std::vector<Collocation> collocation(const ConstrainedEdge& edge) {
  using End = ConstrainedEdge::End;
  if (edge.start == End::Closed) return periodicCollocation(edge.knots);
  const auto leftOut = [](End end) { return end == End::Free ? 0 : 2; };
  std::vector<Collocation> places;
  for (int i = leftOut(edge.start); i < edge.knots.poleCount() - leftOut(edge.end); ++i)
    places.push_back({i, edge.knots.greville(i)});
  return places;
}

Result<solver::ConstraintBlock> tangentRows(const ConstrainedEdge& edge) {
  solver::ConstraintBlock block;
  int asked = 0;
  for (const auto& [i, s] : collocation(edge)) {
    if (!edge.isTangentAt(edge.sideParameter(s))) continue;
    ++asked;
    const Vector3d normal = constraintNormal(edge.side->ribbon, edge.sideParameter(s));
    if (!normal.allFinite()) continue;
    block.rows.push_back(perpendicularRow(edge, s, normal));
    if (const auto forbidden = forbiddenDirection(edge, s, normal))
      block.rows.push_back(perpendicularRow(edge, s, *forbidden));
    block.solvedFor.push_back(edge.inner[static_cast<std::size_t>(i)]);
  }
  if (asked > 0 && block.rows.empty()) return fail(singularAt(edge, edge.knots.first()));
  return block;
}

}  // namespace fairing::constraint
