// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/boundary_loop.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/angle.h"
#include "core/boundary/constraint_normal.h"
#include "core/spline/quadrature.h"

namespace fairing::boundary {
namespace {

constexpr int kSizeSamples = 32;
// A side shorter than this share of the diagonal is a point for every practical purpose.
constexpr double kShortestSide = 1e-7;

double measureLength(const Ribbon& ribbon) {
  double length = 0.0;
  for (const auto& q :
       spline::gaussLegendre(8, spline::KnotVector::fromBreaks(3, {0.0, 0.25, 0.5, 0.75, 1.0})))
    length += q.weight * ribbon.curve(q.parameter).derivative.norm();
  return length;
}

// The largest distance between two points, and not the diagonal of a box along the axes: turning
// the hole must not change it.
double measureDiagonal(const std::vector<BoundarySide>& sides) {
  std::vector<Eigen::Vector3d> points;
  for (const BoundarySide& side : sides)
    for (int k = 0; k <= kSizeSamples; ++k)
      points.push_back(side.ribbon.curve(static_cast<double>(k) / kSizeSamples).point);
  double largest = 0.0;
  for (const Eigen::Vector3d& p : points) {
    if (!p.allFinite()) return std::numeric_limits<double>::quiet_NaN();
    for (const Eigen::Vector3d& q : points) largest = std::max(largest, (p - q).squaredNorm());
  }
  return std::sqrt(largest);
}

// R_uv . n is prescribed by both sides, with u along `before` and v along `after`: -R_v . dn/du and
// -R_u . dn/dv. What they differ by, over the shorter tangent, is the rate of turn that no patch
// can give both.
double twistMismatch(const BoundarySide& before, const BoundarySide& after) {
  if (!before.isTangent() || !after.isTangent()) return 0.0;
  const Eigen::Vector3d u = before.ribbon.curve(1.0).derivative;
  const Eigen::Vector3d v = after.ribbon.curve(0.0).derivative;
  const Eigen::Vector3d nu = constraintNormalDerivativeAtEnd(before.ribbon, false);
  Eigen::Vector3d nv = constraintNormalDerivativeAtEnd(after.ribbon, true);
  const bool opposed =
      constraintNormal(before.ribbon, 1.0).dot(constraintNormal(after.ribbon, 0.0)) < 0.0;
  if (opposed) nv = -nv;
  return std::abs(v.dot(nu) - u.dot(nv)) / std::min(u.norm(), v.norm()) * kDegrees;
}

// The hole lies left of the sides: from the way on, counter-clockwise about the normal, to the way
// back.
double insideAngle(const BoundarySide& before, const BoundarySide& after, double angle) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  if (before.ribbon.hasSupport()) normal += before.ribbon.support(1.0).normal;
  if (after.ribbon.hasSupport()) normal += after.ribbon.support(0.0).normal;
  const Eigen::Vector3d on = after.ribbon.curve(0.0).derivative;
  const Eigen::Vector3d back = -before.ribbon.curve(1.0).derivative;
  return on.cross(back).dot(normal) < 0.0 ? 360.0 - angle : angle;
}

Result<BoundaryLoop> makeChains(std::vector<BoundarySide> sides,
                                std::vector<std::size_t> further,
                                bool areOpen) {
  auto loop = measureSides(std::move(sides));
  if (!loop) return loop;
  loop->further = std::move(further);
  for (std::size_t i = 0; i < loop->sides.size(); ++i) {
    const BoundarySide& before = loop->sides[i];
    const std::size_t next = loop->next(i);
    Corner corner;
    corner.apart = areOpen && next <= i;
    if (!corner.apart) corner = cornerBetween(before, loop->sides[next]);
    if (const auto open = checkMeeting(before, corner, loop->diagonal)) return fail(*open);
    loop->corners.push_back(corner);
  }
  return loop;
}

}  // namespace

std::vector<SideRange> BoundaryLoop::chains() const {
  std::vector<SideRange> result;
  std::size_t first = 0;
  for (const std::size_t start : further) {
    result.emplace_back(first, start);
    first = start;
  }
  result.emplace_back(first, sides.size());
  return result;
}

std::set<int> BoundaryLoop::facesBeside(const SideRange& range) const {
  std::set<int> faces;
  for (std::size_t k = range.first; k < range.second; ++k)
    if (sides[k].face > 0) faces.insert(sides[k].face);
  return faces;
}

std::size_t BoundaryLoop::next(std::size_t side) const {
  for (const auto& [first, end] : chains())
    if (side + 1 == end) return first;
  return side + 1;
}

std::size_t BoundaryLoop::previous(std::size_t side) const {
  for (const auto& [first, end] : chains())
    if (side == first) return end - 1;
  return side - 1;
}

Corner cornerBetween(const BoundarySide& before, const BoundarySide& after) {
  const CurveSample end = before.ribbon.curve(1.0), start = after.ribbon.curve(0.0);
  Corner corner;
  corner.point = 0.5 * (end.point + start.point);
  corner.gap = (end.point - start.point).norm();
  const Eigen::Vector3d back = -end.derivative.normalized(), on = start.derivative.normalized();
  corner.angle = angleBetween(back, on);
  corner.insideAngle = insideAngle(before, after, corner.angle);
  if (before.ribbon.hasSupport() && after.ribbon.hasSupport()) {
    const Eigen::Vector3d a = before.ribbon.support(1.0).normal,
                          b = after.ribbon.support(0.0).normal;
    corner.normalMismatch = lineAngle(a, b);
  }
  corner.twistMismatch = twistMismatch(before, after);
  return corner;
}

std::optional<Error> checkMeeting(const BoundarySide& before,
                                  const Corner& corner,
                                  double diagonal) {
  if (corner.gap <= kLargestCornerGap * diagonal) return std::nullopt;
  return Error{
      ErrorCode::LoopNotClosed, before.edge, 0, before.ribbon.curve(1.0).point, corner.gap};
}

Result<BoundaryLoop> measureSides(std::vector<BoundarySide> sides) {
  if (sides.empty()) return fail({ErrorCode::NothingPicked});
  BoundaryLoop loop;
  loop.diagonal = measureDiagonal(sides);
  if (!std::isfinite(loop.diagonal)) return fail({ErrorCode::NotFinite});
  for (BoundarySide& side : sides) {
    side.length = measureLength(side.ribbon);
    const Eigen::Vector3d start = side.ribbon.curve(0.0).point;
    if (!std::isfinite(side.length)) return fail({ErrorCode::NotFinite, side.edge, 0, start});
    if (side.length <= kShortestSide * loop.diagonal)
      return fail({ErrorCode::EdgeDegenerate, side.edge, 0, start, side.length});
    if (side.continuity != Continuity::G0 && !side.ribbon.hasSupport())
      return fail({ErrorCode::EdgeWithoutFace, side.edge, 0, start});
  }
  loop.sides = std::move(sides);
  return loop;
}

Result<BoundaryLoop> makeLoop(std::vector<BoundarySide> sides, std::vector<std::size_t> further) {
  return makeChains(std::move(sides), std::move(further), false);
}

Result<BoundaryLoop> makeOpenChains(std::vector<BoundarySide> sides,
                                    std::vector<std::size_t> further) {
  return makeChains(std::move(sides), std::move(further), true);
}

}  // namespace fairing::boundary
