// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/domain_grid.h"

#include <algorithm>

#include "core/spline/quadrature.h"

namespace fairing::height_field {
namespace {

using Eigen::Vector2d;

// The spans [first, last] that an interval touches.
std::pair<std::size_t, std::size_t> spansOf(const std::vector<double>& breaks,
                                            double low,
                                            double high) {
  const auto span = [&](double t) {
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
    return static_cast<std::size_t>(above - breaks.begin()) - 1;
  };
  return {span(low), span(high)};
}

// Where the loop crosses a line on which coordinate `axis` is constant, ascending in the other:
// inside lies between the first and the second, the third and the fourth, ...
std::vector<double> crossingsAt(const ProjectedLoop& loop, int axis, double at) {
  std::vector<double> crossings;
  for (std::size_t k = 0; k < loop.points.size(); ++k) {
    const Vector2d &a = loop.points[k], &b = loop.points[(k + 1) % loop.points.size()];
    if ((a[axis] > at) == (b[axis] > at)) continue;
    const double share = (at - a[axis]) / (b[axis] - a[axis]);
    crossings.push_back(a[1 - axis] + share * (b[1 - axis] - a[1 - axis]));
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

// Corners, and points next to which the loop runs back along `axis`.
std::vector<Vector2d> turnsOf(const ProjectedLoop& loop, int axis) {
  const std::size_t n = loop.points.size();
  std::vector<Vector2d> turns;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector2d &at = loop.points[k], &before = loop.points[(k + n - 1) % n],
                   &after = loop.points[(k + 1) % n];
    const bool isCorner = loop.sides[k] != loop.sides[(k + n - 1) % n];
    if (isCorner || (at[axis] - before[axis]) * (after[axis] - at[axis]) <= 0.0)
      turns.push_back(at);
  }
  return turns;
}

}  // namespace

DomainGrid::Axis DomainGrid::axisOf(const spline::KnotVector& knots, int axis) const {
  Axis result{knots, knots.breaks(), {}, turnsOf(loop_, axis)};
  for (const auto& q : spline::gaussLegendre(static_cast<int>(points_), knots))
    result.lines.push_back({q.parameter, q.weight, spline::basisRow(knots, q.parameter, 3)});
  return result;
}

DomainGrid::DomainGrid(const spline::KnotVector& u,
                       const spline::KnotVector& v,
                       const ProjectedLoop& loop,
                       int pointsPerSpan)
    : loop_(loop),
      points_(static_cast<std::size_t>(pointsPerSpan)),
      u_(axisOf(u, 0)),
      v_(axisOf(v, 1)) {
  classify();
}

void DomainGrid::classify() {
  const ProjectedLoop& loop = loop_;
  const std::size_t nu = u_.breaks.size() - 1, nv = v_.breaks.size() - 1, n = loop.points.size();
  // How far the loop runs along either direction within every cell.
  std::vector<Vector2d> runs(nu * nv, Vector2d::Zero());
  for (std::size_t k = 0; k < n; ++k) {
    Eigen::AlignedBox2d chord(loop.points[k]);
    chord.extend(loop.points[(k + 1) % n]);
    const auto [u0, u1] = spansOf(u_.breaks, chord.min()[0], chord.max()[0]);
    const auto [v0, v1] = spansOf(v_.breaks, chord.min()[1], chord.max()[1]);
    for (std::size_t i = u0; i <= u1; ++i)
      for (std::size_t j = v0; j <= v1; ++j) runs[i * nv + j] += chord.sizes();
  }
  cells_.assign(nu * nv, Cell::Outside);
  for (std::size_t i = 0; i < nu; ++i)
    for (std::size_t j = 0; j < nv; ++j) {
      const Vector2d middle(0.5 * (u_.breaks[i] + u_.breaks[i + 1]),
                            0.5 * (v_.breaks[j] + v_.breaks[j + 1]));
      const Vector2d& run = runs[i * nv + j];
      if (!run.isZero())
        cells_[i * nv + j] = run[0] >= run[1] ? Cell::CutAlongU : Cell::CutAlongV;
      else if (loop.contains(middle))
        cells_[i * nv + j] = Cell::Inside;
    }
}

void DomainGrid::visitWhole(std::size_t i,
                            std::size_t j,
                            bool inside,
                            const AtPlace& atPlace) const {
  for (std::size_t k = i * points_; k < (i + 1) * points_; ++k)
    for (std::size_t l = j * points_; l < (j + 1) * points_; ++l) {
      const Line &a = u_.lines[k], &b = v_.lines[l];
      atPlace({a.parameter, b.parameter, a.weight * b.weight, inside, a.basis, b.basis});
    }
}

// Where lines of constant `axis` begin to cross the loop in a cell, cease to, or cross a corner.
std::vector<double> DomainGrid::stretches(const Eigen::AlignedBox2d& cell, int axis) const {
  const double low = cell.min()[axis], high = cell.max()[axis];
  std::vector<double> ends{low, high};
  for (const double side : {cell.min()[1 - axis], cell.max()[1 - axis]})
    for (const double at : crossingsAt(loop_, 1 - axis, side))
      if (at > low && at < high) ends.push_back(at);
  for (const Vector2d& turn : axis == 0 ? u_.turns : v_.turns)
    if (cell.contains(turn)) ends.push_back(turn[axis]);
  std::sort(ends.begin(), ends.end());
  return ends;
}

void DomainGrid::visitCut(std::size_t i, std::size_t j, bool alongU, const AtPlace& atPlace) const {
  const Eigen::AlignedBox2d cell(Vector2d(u_.breaks[i], v_.breaks[j]),
                                 Vector2d(u_.breaks[i + 1], v_.breaks[j + 1]));
  const int axis = alongU ? 0 : 1;
  const spline::KnotVector &on = alongU ? u_.knots : v_.knots,
                           &across = alongU ? v_.knots : u_.knots;
  const double low = cell.min()[1 - axis], high = cell.max()[1 - axis];
  const auto gauss = [&](double from, double to) {
    return spline::gaussLegendre(static_cast<int>(points_), from, to);
  };
  const auto visitLine = [&](const spline::QuadraturePoint& line) {
    const spline::BasisRow lineBasis = spline::basisRow(on, line.parameter, 3);
    std::vector<double> ends{low};
    for (const double at : crossingsAt(loop_, axis, line.parameter))
      ends.push_back(std::clamp(at, low, high));
    ends.push_back(high);
    for (std::size_t l = 0; l + 1 < ends.size(); ++l) {
      if (ends[l + 1] <= ends[l]) continue;
      const bool inside = l % 2 == 1;
      for (const auto& q : gauss(ends[l], ends[l + 1])) {
        const spline::BasisRow basis = spline::basisRow(across, q.parameter, 3);
        const double weight = line.weight * q.weight;
        if (alongU)
          atPlace({line.parameter, q.parameter, weight, inside, lineBasis, basis});
        else
          atPlace({q.parameter, line.parameter, weight, inside, basis, lineBasis});
      }
    }
  };
  const std::vector<double> pieces = stretches(cell, axis);
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k)
    if (pieces[k + 1] > pieces[k])
      for (const auto& line : gauss(pieces[k], pieces[k + 1])) visitLine(line);
}

void DomainGrid::visit(const AtPlace& atPlace, const std::function<void()>& afterCell) const {
  const std::size_t nv = v_.breaks.size() - 1;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const std::size_t i = cell / nv, j = cell % nv;
    const Cell kind = cells_[cell];
    if (kind == Cell::CutAlongU || kind == Cell::CutAlongV)
      visitCut(i, j, kind == Cell::CutAlongU, atPlace);
    else
      visitWhole(i, j, kind == Cell::Inside, atPlace);
    afterCell();
  }
}

}  // namespace fairing::height_field
