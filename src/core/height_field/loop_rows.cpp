// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/loop_rows.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/spline/quadrature.h"

namespace fairing::height_field {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRadians = std::numbers::pi / 180.0;
// Pieces of a side are halved until they are this share of the cell they lie in.
constexpr double kPieceShare = 0.5;
constexpr int kLeastHalvings = 3, kMostHalvings = 12;
constexpr int kPointsPerPiece = 3;
// Supports steeper than this over the plane are taken for as steep: cos 80 degrees.
constexpr double kSteepest = 0.17;
// Curvatures below this over the frame's unit count as flat when one is compared to them.
constexpr double kFlat = 0.05;

// The length of the span of a knot vector in which t lies.
double spanAt(const spline::KnotVector& knots, double t) {
  const auto span =
      static_cast<std::size_t>(knots.span(std::clamp(t, knots.first(), knots.last())));
  return knots.knots()[span + 1] - knots.knots()[span];
}

// (m, s) perpendicular to the edge's tangent: how long the arm is by which a slope turns the
// surface about the edge.
double arm(const Vector2d& across, double slope, const Vector3d& tangent) {
  const Vector3d way(across[0], across[1], slope);
  return (way - tangent * way.dot(tangent)).norm();
}

}  // namespace

LoopRows::LoopRows(const boundary::BoundaryLoop& loop,
                   const std::vector<InnerConstraint>& through,
                   const PlaneFrame& frame,
                   const Tolerance& tolerance)
    : loop_(loop),
      through_(through),
      frame_(frame),
      gapLimit_(tolerance.gapFor(loop.diagonal) / frame.unit),
      angleLimit_(tolerance.angle * kRadians),
      curvatureLimit_(tolerance.curvature),
      known_(loop.sides.size()) {}

HeightRow LoopRows::position(const Vector3d& point) const {
  const Vector3d at = frame_.coordinates(point);
  HeightRow row{at[0], at[1]};
  row.form[H] = 1.0 / gapLimit_;
  row.right = at[2] / gapLimit_;
  return row;
}

LoopRows::Rows LoopRows::sideRows(std::size_t k, double t) const {
  const boundary::BoundarySide& side = loop_.sides[k];
  const boundary::CurveSample curve = side.ribbon.curve(t);
  Rows rows{position(curve.point)};
  rows.front().side = static_cast<int>(k);
  if (!side.isTangent()) return rows;
  const boundary::SupportSample support = side.ribbon.support(t);
  if (support.singular) return rows;
  const Vector3d tangent = frame_.components(curve.derivative.normalized());
  Vector3d normal = frame_.components(support.normal);
  // A surface through the edge cannot turn its normal into the edge's direction.
  normal = (normal - tangent * tangent.dot(normal)).normalized();
  const double up = std::max(normal[2], kSteepest);
  const Vector2d across = Vector2d(-tangent[1], tangent[0]).normalized();
  const double slope = -across.dot(normal.head<2>()) / up;

  HeightRow row = rows.front();
  const double scale = up / arm(across, slope, tangent) / angleLimit_;
  row.form = JetForm::Zero();
  row.form[Hu] = scale * across[0];
  row.form[Hv] = scale * across[1];
  row.right = scale * slope;
  rows.push_back(row);
  if (side.continuity != Continuity::G2) return rows;

  // II(d, d) = h_dd / W for the lift of a plane direction d, and 1 / W is the normal's height.
  const Vector3d lifted = normal.cross(tangent);
  const Vector3d inSpace = frame_.axes * lifted;
  const double curvature = inSpace.dot(support.secondForm * inSpace) * frame_.unit;
  const double allowed = curvatureLimit_ * (2.0 * std::abs(curvature) + kFlat);
  row.form = JetForm::Zero();
  row.form[Huu] = up * lifted[0] * lifted[0] / allowed;
  row.form[Huv] = up * 2.0 * lifted[0] * lifted[1] / allowed;
  row.form[Hvv] = up * lifted[1] * lifted[1] / allowed;
  row.right = curvature / allowed;
  rows.push_back(row);
  return rows;
}

template <class At, class RowsAt>
void LoopRows::sample(const spline::KnotVector& u,
                      const spline::KnotVector& v,
                      const At& at,
                      const RowsAt& rowsAt,
                      std::vector<HeightRow>& all) const {
  const auto cut = [&](const auto& self, double from, double to, int depth) -> void {
    const Vector3d a = frame_.coordinates(at(from)), b = frame_.coordinates(at(to));
    const Vector2d way = (b - a).head<2>().cwiseAbs();
    const Vector2d cell(std::min(spanAt(u, a[0]), spanAt(u, b[0])),
                        std::min(spanAt(v, a[1]), spanAt(v, b[1])));
    const bool fine = way[0] <= kPieceShare * cell[0] && way[1] <= kPieceShare * cell[1];
    if (depth < kLeastHalvings || (!fine && depth < kMostHalvings)) {
      const double middle = 0.5 * (from + to);
      self(self, from, middle, depth + 1);
      return self(self, middle, to, depth + 1);
    }
    for (const auto& q : spline::gaussLegendre(kPointsPerPiece, from, to))
      for (HeightRow row : rowsAt(q.parameter)) {
        row.weight = way.norm() / kPointsPerPiece;
        all.push_back(row);
      }
  };
  cut(cut, 0.0, 1.0, 0);
}

std::vector<HeightRow> LoopRows::rowsFor(const spline::KnotVector& u, const spline::KnotVector& v) {
  std::vector<HeightRow> all;
  for (std::size_t k = 0; k < loop_.sides.size(); ++k) {
    const auto at = [&](double t) { return loop_.sides[k].ribbon.curve(t).point; };
    const auto rowsAt = [&](double t) -> const Rows& {
      const auto found = known_[k].find(t);
      return found != known_[k].end() ? found->second
                                      : known_[k].emplace(t, sideRows(k, t)).first->second;
    };
    sample(u, v, at, rowsAt, all);
  }
  for (const InnerConstraint& inner : through_) {
    const auto rowsAt = [&](double t) { return Rows{position(inner.at(t))}; };
    if (inner.isPoint)
      all.push_back(position(inner.at(0.0)));
    else
      sample(u, v, inner.at, rowsAt, all);
  }
  return all;
}

}  // namespace fairing::height_field
