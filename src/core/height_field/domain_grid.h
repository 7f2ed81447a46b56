// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>
#include <vector>

#include "core/height_field/height_jet.h"
#include "core/height_field/projected_loop.h"

namespace fairing::height_field {

/// Quadrature over the cells of two knot vectors, apart for what lies inside the loop and outside:
/// Gauss-Legendre on whole cells. In a cell that the loop cuts, on the stretches into which it cuts
/// lines across the cell, between which nothing happens but that they grow and shrink smoothly.
/// Good to the loop's polygon.
class DomainGrid {
 public:
  DomainGrid(const spline::KnotVector& u,
             const spline::KnotVector& v,
             const ProjectedLoop& loop,
             int pointsPerSpan);

  struct Place {
    double u, v;
    double weight;  ///< of the integral over the plane
    bool inside;    ///< the loop
    const spline::BasisRow &basisU, &basisV;
  };
  using AtPlace = std::function<void(const Place&)>;
  /// Calls `atPlace` for every point, cell by cell, and `afterCell` after each cell.
  void visit(const AtPlace& atPlace, const std::function<void()>& afterCell) const;

 private:
  struct Line {
    double parameter, weight;
    spline::BasisRow basis;
  };
  /// A cell that is cut is integrated along v where the loop runs rather along u, and vice versa.
  enum class Cell : char { Outside, Inside, CutAlongU, CutAlongV };
  /// One direction.
  struct Axis {
    spline::KnotVector knots;
    std::vector<double> breaks;
    std::vector<Line> lines;  ///< where it is constant, a few a span
    /// Corners of the loop, and where it turns back in this direction.
    std::vector<Eigen::Vector2d> turns;
  };
  [[nodiscard]] Axis axisOf(const spline::KnotVector& knots, int axis) const;
  void classify();
  [[nodiscard]] std::vector<double> stretches(const Eigen::AlignedBox2d& cell, int axis) const;
  void visitWhole(std::size_t i, std::size_t j, bool inside, const AtPlace& atPlace) const;
  void visitCut(std::size_t i, std::size_t j, bool alongU, const AtPlace& atPlace) const;

  const ProjectedLoop& loop_;
  std::size_t points_;
  Axis u_, v_;
  std::vector<Cell> cells_;  // v fastest
};

}  // namespace fairing::height_field
