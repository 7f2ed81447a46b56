// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/constraint/seam_curvature.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/constraint/across.h"
#include "core/constraint/seam_rows.h"
#include "core/spline/bspline_basis.h"

// X = R2_ww - b^2 R1_vv - 2 a b R1_vt - a^2 R_tt  is linear in the control points; f = n . X is
// not, for n turns with R_t and D1. With  X = c D1 + d R_t + f n  where the rows are taken,
//   df = n . (dX - c dD1 - d dR_t),
// and D1, R_t are perpendicular to n there: the row is  n . (X - c D1 - d R_t) = 0.

namespace fairing::constraint {
namespace {

using Eigen::Vector3d;
using layout::PatchLayout;
using layout::Seam;

// The control points beside a seam in one patch, and the derivatives across it with respect to a
// parameter that runs from 0 to 1 over the patch.
struct SeamSide {
  std::array<std::vector<int>, 3> rows;
  Across across;
};

SeamSide sideOf(const layout::LayoutPatch& patch,
                layout::PatchEdge edge,
                std::array<std::vector<int>, 3> rows) {
  const spline::KnotVector& across = layout::directionOf(edge) == 0 ? patch.v : patch.u;
  const double width = across.last() - across.first();
  SeamSide side{std::move(rows), acrossOf(patch, edge)};
  for (double& weight : side.across.first) weight *= width;
  for (double& weight : side.across.second) weight *= width * width;
  return side;
}

// A vector that is linear in the control points, as their weights.
class LinearVector {
 public:
  void add(int point, double weight) {
    points_.push_back(point);
    weights_.push_back(weight);
  }
  void add(double factor, const LinearVector& other) {
    for (std::size_t k = 0; k < other.points_.size(); ++k)
      add(other.points_[k], factor * other.weights_[k]);
  }
  [[nodiscard]] Vector3d at(const solver::Points& points) const {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 0; k < points_.size(); ++k)
      sum += weights_[k] * points.row(points_[k]).transpose();
    return sum;
  }
  /// normal . this = 0, its largest weight 1.
  [[nodiscard]] solver::LinearRow along(const Vector3d& normal) const {
    double largest = 0.0;
    for (const double weight : weights_) largest = std::max(largest, std::abs(weight));
    solver::LinearRow row;
    row.points = points_;
    for (const double weight : weights_) row.weights.push_back(weight / largest * normal);
    return row;
  }

 private:
  std::vector<int> points_;
  std::vector<double> weights_;
};

class CurvedSeam {
 public:
  CurvedSeam(const PatchLayout& layout, const Seam& seam)
      : seam_(seam),
        knots_(layout::edgeKnots(layout.patches[std::size_t(seam.first)], seam.firstEdge)
                   .mapped(0.0, 1.0)),
        first_(sideOf(layout.patches[std::size_t(seam.first)],
                      seam.firstEdge,
                      {rowInFirst(layout, seam, 0),
                       rowInFirst(layout, seam, 1),
                       rowInFirst(layout, seam, 2)})),
        second_(sideOf(layout.patches[std::size_t(seam.second)],
                       seam.secondEdge,
                       {rowInSecond(layout, seam, 0),
                        rowInSecond(layout, seam, 1),
                        rowInSecond(layout, seam, 2)})) {}

  void addTo(solver::ConstraintBlock& block, const solver::Points& about) const {
    const int n = knots_.poleCount();
    if (seam_.inside[0]) block.rows.push_back(rowAt(0.0, about));
    if (seam_.inside[1]) block.rows.push_back(rowAt(1.0, about));
    const int start = seam_.inside[0] ? 1 : 2, end = seam_.inside[1] ? n - 1 : n - 2;
    for (int i = start; i < end; ++i) block.rows.push_back(rowAt(knots_.greville(i), about));
    for (int i = 0; i < n; ++i)
      for (const SeamSide* side : {&first_, &second_})
        for (const std::vector<int>& row : {side->rows[0], side->rows[2]})
          block.solvedFor.push_back(row[std::size_t(i)]);
  }

 private:
  [[nodiscard]] LinearVector derivative(const SeamSide& side,
                                        const spline::BasisRow& basis,
                                        int orderAlong,
                                        const std::array<double, 3>& across) const {
    LinearVector result;
    for (int k = 0; k <= knots_.degree(); ++k)
      for (std::size_t r = 0; r < 3; ++r)
        result.add(side.rows[r][std::size_t(basis.first + k)],
                   basis.values(orderAlong, k) * across[r]);
    return result;
  }

  [[nodiscard]] solver::LinearRow rowAt(double t, const solver::Points& about) const {
    constexpr std::array<double, 3> kOn{1.0, 0.0, 0.0};
    const spline::BasisRow basis = spline::basisRow(knots_, t, 2);
    const layout::SeamFrame frame = seam_.frame(t);
    const double b = -frame.first / frame.second, a = frame.along / frame.second;
    const LinearVector along = derivative(first_, basis, 1, kOn);
    const LinearVector across = derivative(first_, basis, 0, first_.across.first);
    LinearVector jump = derivative(second_, basis, 0, second_.across.second);
    jump.add(-b * b, derivative(first_, basis, 0, first_.across.second));
    jump.add(-2.0 * a * b, derivative(first_, basis, 1, first_.across.first));
    jump.add(-a * a, derivative(first_, basis, 2, kOn));
    const Vector3d rt = along.at(about), d1 = across.at(about);
    Eigen::Matrix3d axes;
    axes << d1, rt, d1.cross(rt);
    const Vector3d shares = axes.partialPivLu().solve(jump.at(about));
    jump.add(-shares[0], across);
    jump.add(-shares[1], along);
    return jump.along(axes.col(2).normalized());
  }

  const Seam& seam_;
  spline::KnotVector knots_;
  SeamSide first_, second_;
};

}  // namespace

std::optional<solver::ConstraintBlock> seamCurvatureRows(const PatchLayout& layout,
                                                         const solver::Points& about) {
  solver::ConstraintBlock block;
  for (const Seam& seam : layout.seams)
    if (!seam.crease && seam.continuity == Continuity::G2)
      CurvedSeam(layout, seam).addTo(block, about);
  if (block.rows.empty()) return std::nullopt;
  return block;
}

}  // namespace fairing::constraint
