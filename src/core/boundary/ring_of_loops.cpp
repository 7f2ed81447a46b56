// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/ring_of_loops.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/spline/quadrature.h"

namespace fairing::boundary {
namespace {

using Eigen::Vector3d;

constexpr int kPoints = 16;  // of a Gauss-Legendre rule a side

// Whether a loop runs counter-clockwise seen from the gap. What leads into it: the faces beside the
// loop, and, where these lie round a hole, the way to the others.
bool runsRound(const LoopShape& loop, const Vector3d& middle) {
  const Vector3d way = (middle - loop.centre).normalized();
  return loop.area.dot(loop.into + 0.5 * way) > 0.0;
}

// Three loops have but one order; more are passed in the order of their directions from the middle
// in the plane that they keep closest to.
std::vector<std::size_t> orderOf(const std::vector<LoopShape>& loops, const Vector3d& middle) {
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (loops.size() == 3) return order;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const LoopShape& loop : loops)
    for (const double step : {0.0, -loop.radius}) {
      const Vector3d p = loop.centre + step * loop.into - middle;
      scatter += p * p.transpose();
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  const Vector3d x = axes.eigenvectors().col(2), y = axes.eigenvectors().col(1);
  const auto direction = [&](std::size_t k) {
    const Vector3d way = loops[k].centre - middle;
    const double angle = std::atan2(way.dot(y), way.dot(x));
    const Vector3d first = loops[0].centre - middle;
    const double turn = angle - std::atan2(first.dot(y), first.dot(x));
    return turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn;
  };
  std::sort(order.begin() + 1, order.end(), [&](std::size_t a, std::size_t b) {
    return direction(a) < direction(b);
  });
  return order;
}

}  // namespace

LoopShape shapeOf(const std::vector<BoundarySide>& sides) {
  LoopShape shape{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  double length = 0.0;
  const Vector3d origin = sides.front().ribbon.curve(0.0).point;
  for (const BoundarySide& side : sides)
    for (const auto& q : spline::gaussLegendre(kPoints, 0.0, 1.0)) {
      const CurveSample at = side.ribbon.curve(q.parameter);
      const double share = q.weight * at.derivative.norm();
      shape.centre += share * at.point;
      shape.area += 0.5 * q.weight * (at.point - origin).cross(at.derivative);
      if (side.ribbon.hasSupport())
        shape.into += q.weight * side.ribbon.support(q.parameter).normal.cross(at.derivative);
      length += share;
    }
  shape.centre /= length;
  shape.into /= length;
  shape.radius = 0.5 * length / std::numbers::pi;
  return shape;
}

Result<BoundaryLoop> ringOfLoops(const std::vector<SideChain>& chains) {
  std::vector<LoopShape> shapes;
  Vector3d middle = Vector3d::Zero();
  for (const SideChain& chain : chains) {
    if (!chain.closed)
      return fail({.code = ErrorCode::ChainsUnlike, .edge = chain.sides.front().edge});
    shapes.push_back(shapeOf(chain.sides));
    middle += shapes.back().centre / static_cast<double>(chains.size());
  }
  const bool round = runsRound(shapes.front(), middle);
  std::vector<BoundarySide> sides;
  std::vector<std::size_t> further;
  for (const std::size_t k : orderOf(shapes, middle)) {
    const SideChain chain = runsRound(shapes[k], middle) == round ? chains[k] : reversed(chains[k]);
    if (!sides.empty()) further.push_back(sides.size());
    sides.insert(sides.end(), chain.sides.begin(), chain.sides.end());
  }
  auto loop = makeLoop(std::move(sides), std::move(further));
  if (!loop) return loop;
  for (std::size_t k = 0; k < loop->corners.size(); ++k)
    if (const auto turns = chainTurns(loop->sides[k], loop->corners[k])) return fail(*turns);
  return loop;
}

}  // namespace fairing::boundary
