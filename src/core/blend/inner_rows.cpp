// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/inner_rows.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <utility>
#include <vector>

#include "core/boundary/constraint_normal.h"
#include "core/constraint/constraint_set.h"
#include "core/solver/solve.h"
#include "core/spline/bspline_basis.h"

namespace fairing {
namespace {

using boundary::Departure;
using Eigen::Vector3d;
using layout::PatchEdge;

constexpr std::array<PatchEdge, 2> kEdges{PatchEdge::South, PatchEdge::North};
constexpr int kSamples = 64;

// The rows of one patch on a side and next to it, in the side's direction.
struct Row {
  const boundary::BoundarySide* side = nullptr;
  std::size_t chain = 0;  // 0: first, on the South edge; 1: second, on the North edge
  std::size_t patch = 0;
  std::vector<int> outer, inner;
  spline::KnotVector knots;  // over [0, 1]
  std::vector<double> t;     // parameters of the side that belong to the points
  /// The stretch of its chain that the side is, by length.
  double from = 0.0, to = 1.0;
  /// Whether it begins, and ends, where the strip follows something: position and twist of the
  /// corner are fixed by what does, so the first two inner points stay.
  std::array<bool, 2> follows{false, false};

  [[nodiscard]] bool stays(std::size_t i) const {
    return (follows[0] && i < 2) || (follows[1] && i + 2 >= inner.size());
  }
};

// Whether a chain starts, and ends, where patches from one to another follow something.
std::array<bool, 2> followsEnds(const layout::LayoutPatch& first,
                                const layout::LayoutPatch& last,
                                std::size_t chain) {
  const bool west = first.edges[static_cast<std::size_t>(PatchEdge::West)].has_value();
  const bool east = last.edges[static_cast<std::size_t>(PatchEdge::East)].has_value();
  return chain == 0 ? std::array{west, east} : std::array{east, west};
}

std::vector<Row> rowsOf(const StripRows& strip) {
  std::vector<Row> rows;
  std::array<double, 2> length{0.0, 0.0};
  for (std::size_t p = 0; p < strip.layout.patches.size(); ++p)
    for (std::size_t chain = 0; chain < 2; ++chain) {
      const layout::LayoutPatch& patch = strip.layout.patches[p];
      const auto& use = patch.edges[static_cast<std::size_t>(kEdges[chain])];
      if (!use) continue;
      const spline::KnotVector knots = layout::edgeKnots(patch, kEdges[chain]).mapped(0.0, 1.0);
      Row row{&strip.sides.sides[static_cast<std::size_t>(use->side)],
              chain,
              p,
              layout::edgePoints(patch, kEdges[chain], 0),
              layout::edgePoints(patch, kEdges[chain], 1),
              knots,
              {}};
      for (int i = 0; i < knots.poleCount(); ++i) row.t.push_back(knots.greville(i));
      row.follows = followsEnds(patch, patch, chain);
      row.from = length[chain];
      row.to = length[chain] += row.side->length;
      rows.push_back(std::move(row));
    }
  // Patches follow each other along the first chain; the second one runs the other way.
  for (Row& row : rows) {
    row.from /= length[row.chain];
    row.to /= length[row.chain];
    if (row.chain == 1) row.from = 1.0 - std::exchange(row.to, 1.0 - row.from);
  }
  return rows;
}

// Away from the face, in its tangent plane, as the side asks; unit length. Where the support has no
// normal: NaN.
Vector3d askedDirection(const boundary::BoundarySide& side, double t) {
  const Vector3d left = boundary::constraintNormal(side.ribbon, t)
                            .cross(side.ribbon.curve(t).derivative)
                            .normalized();
  Vector3d direction = left;
  if (side.departure == Departure::Iso) {
    direction = side.ribbon.support(t).iso;
    if (direction.dot(left) < 0.0) direction = -direction;
  }
  return side.leaving == boundary::Leaving::Backwards ? -direction : direction;
}

HeldPoints held(const StripRows& strip, const solver::Points& points) {
  HeldPoints result;
  for (const Row& row : rowsOf(strip))
    result.points.insert(result.points.end(), row.inner.begin(), row.inner.end());
  result.values.resize(static_cast<Eigen::Index>(result.points.size()), 3);
  for (std::size_t k = 0; k < result.points.size(); ++k)
    result.values.row(static_cast<Eigen::Index>(k)) = points.row(result.points[k]);
  return result;
}

using Differences = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// The points of R_v along a side, but for a factor.
Differences crossOf(const Row& row, const solver::Points& points) {
  Differences cross(static_cast<Eigen::Index>(row.inner.size()), 3);
  for (std::size_t i = 0; i < row.inner.size(); ++i)
    cross.row(static_cast<Eigen::Index>(i)) = points.row(row.inner[i]) - points.row(row.outer[i]);
  return cross;
}

// Reach fades to 1 towards an end that follows something, level and not bent there: 0 there, 1 at a
// free end and in the middle of two others. `follows`: at the start of the chain, and at its end.
double fade(std::array<bool, 2> follows, double share) {
  const double s = follows[0] ? share : 1.0 - share;
  const double cube = s * s * s, rest = 1.0 - s;
  if (follows[0] && follows[1]) return 64.0 * cube * rest * rest * rest;
  return follows[0] || follows[1] ? cube * (10.0 - 15.0 * s + 6.0 * s * s) : 1.0;
}

// The spline that is `reach` times R_v at the Greville abscissae: where R_v meets what is
// collocated there, so does it.
Differences scaledAtGreville(const Row& row,
                             const Differences& cross,
                             const Reach& reach,
                             std::array<bool, 2> follows) {
  const auto n = static_cast<Eigen::Index>(row.t.size());
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd factors(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = row.t[static_cast<std::size_t>(i)];
    if (row.stays(static_cast<std::size_t>(i))) {
      values(i, i) = factors[i] = 1.0;
      continue;
    }
    const spline::BasisRow basis = spline::basisRow(row.knots, t);
    values.row(i).segment(basis.first, basis.values.cols()) = basis.values.row(0);
    const double share = row.from + t * (row.to - row.from);
    factors[i] = 1.0 + (reach.at(row.chain, share) - 1.0) * fade(follows, share);
  }
  return values.partialPivLu().solve(factors.asDiagonal() * (values * cross));
}

// Minimises the sum over the inner rows of |point - wanted|^2 subject to what the sides ask, all
// other points being where they are.
Result<solver::Points> nearestThatMeet(const StripRows& strip, const solver::Points& wanted) {
  auto constraints = constraint::constrainSides(strip.sides, strip.layout);
  if (!constraints) return fail(constraints.error());
  solver::QuadraticProgram program;
  program.stiffness.resize(wanted.rows(), wanted.rows());
  program.stiffness.setIdentity();
  program.load = Eigen::Map<const Eigen::VectorXd>(wanted.data(), wanted.size());
  program.fixed.assign(static_cast<std::size_t>(wanted.rows()), 1);
  program.values = wanted;
  for (const Row& row : rowsOf(strip))
    for (std::size_t i = 0; i < row.inner.size(); ++i)
      if (!row.stays(i)) program.fixed[static_cast<std::size_t>(row.inner[i])] = 0;
  program.ties = std::move(constraints->ties);
  program.blocks = std::move(constraints->blocks);
  auto solution = solver::solve(program);
  if (!solution) return fail(solution.error());
  return std::move(solution->points);
}

}  // namespace

HeldPoints scaledRows(const StripRows& strip, const Reach& reach) {
  solver::Points points = pointsOf(strip.layout, strip.patches);
  for (const Row& row : rowsOf(strip)) {
    Differences cross = crossOf(row, points);
    const auto& patches = strip.layout.patches;
    const std::array<bool, 2> follows = followsEnds(patches.front(), patches.back(), row.chain);
    if (reach.varies(row.chain) || follows[0] || follows[1])
      cross = scaledAtGreville(row, cross, reach, follows);
    else
      cross *= reach.start[row.chain];
    for (std::size_t i = 0; i < row.inner.size(); ++i)
      points.row(row.inner[i]) = points.row(row.outer[i]) + cross.row(static_cast<Eigen::Index>(i));
  }
  return held(strip, points);
}

std::array<bool, 2> leavesAmiss(const StripRows& strip) {
  std::array<bool, 2> amiss{false, false};
  for (const Row& row : rowsOf(strip)) {
    const boundary::BoundarySide& side = *row.side;
    if (!side.isTangent()) continue;
    const spline::BsplineSurface& patch = strip.patches[row.patch];
    for (int i = 0; i < kSamples; ++i) {
      const double t = (i + 0.5) / kSamples;
      if (side.continuityAt(t) == Continuity::G0) continue;
      const Vector3d direction = askedDirection(side, t);
      if (!direction.allFinite()) continue;
      const double along = patch.u.last() * (row.chain == 0 ? t : 1.0 - t);
      const Vector3d up = patch.jet(along, row.chain == 0 ? patch.v.first() : patch.v.last()).v;
      if ((row.chain == 0 ? up : Vector3d(-up)).dot(direction) <= 0.0) amiss[row.chain] = true;
    }
  }
  return amiss;
}

Result<HeldPoints> turnedRows(const StripRows& strip, std::array<bool, 2> turn) {
  solver::Points points = pointsOf(strip.layout, strip.patches);
  for (const Row& row : rowsOf(strip)) {
    if (!turn[row.chain]) continue;
    double length = 0.0;
    for (std::size_t i = 0; i < row.inner.size(); ++i)
      length += (points.row(row.inner[i]) - points.row(row.outer[i])).norm() /
                static_cast<double>(row.inner.size());
    for (std::size_t i = 0; i < row.inner.size(); ++i) {
      const Vector3d direction = askedDirection(*row.side, row.t[i]);
      if (direction.allFinite() && !row.stays(i))
        points.row(row.inner[i]) = points.row(row.outer[i]) + length * direction.transpose();
    }
  }
  const auto nearest = nearestThatMeet(strip, points);
  if (!nearest) return fail(nearest.error());
  return held(strip, *nearest);
}

}  // namespace fairing
