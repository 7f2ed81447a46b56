// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_shape_energy.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/spline/bspline_basis.h"
#include "core/spline/quadrature.h"

namespace fairing::assembly {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using shape_energy::Jet;
using shape_energy::ShapeEnergy;
using spline::BasisRow;
using spline::BsplineSurface;

// A quadrature point of one direction with its basis functions, evaluated once for the whole grid.
struct GridPoint {
  double weight;
  BasisRow basis;
};

std::vector<GridPoint> gridPoints(const spline::KnotVector& knots, int points) {
  std::vector<GridPoint> line;
  for (const auto& q : spline::gaussLegendre(points, knots))
    line.push_back({q.weight, spline::basisRow(knots, q.parameter, 3)});
  return line;
}

// One direction's quadrature points, `perSpan` of every span one after the other.
struct GridLine {
  GridLine(const spline::KnotVector& knots, int asked)
      : perSpan(static_cast<std::size_t>(asked > 0 ? asked : knots.degree())),
        points(gridPoints(knots, static_cast<int>(perSpan))) {}

  std::size_t perSpan;
  std::vector<GridPoint> points;
};

// Derivatives (a, b) along (u, v) in the order of a jet's columns.
constexpr int kOrders[9][2] = {
    {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};

// Row k: the derivative that is the jet's column k, of each control point's basis function.
using JetBasis = Eigen::Matrix<double, 9, Eigen::Dynamic>;

void setJetBasis(const BasisRow& bu, const BasisRow& bv, JetBasis& basis) {
  Index column = 0;
  for (Index i = 0; i < bu.values.cols(); ++i)
    for (Index j = 0; j < bv.values.cols(); ++j, ++column)
      for (int k = 0; k < 9; ++k)
        basis(k, column) = bu.values(kOrders[k][0], i) * bv.values(kOrders[k][1], j);
}

// One span: gathers the weighted residuals of its quadrature points and their derivatives with
// respect to its control points.
class SpanModel {
 public:
  SpanModel(const BsplineSurface& patch, const BasisRow& bu, const BasisRow& bv) {
    const Index ku = bu.values.cols(), kv = bv.values.cols();
    poles_.resize(3, ku * kv);
    basis_.resize(9, ku * kv);
    for (Index i = 0; i < ku; ++i)
      for (Index j = 0; j < kv; ++j) {
        const int pole =
            patch.index(bu.first + static_cast<int>(i), bv.first + static_cast<int>(j));
        indices_.push_back(pole);
        poles_.col(i * kv + j) = patch.poles.row(pole).transpose();
      }
  }

  void add(const GridPoint& qu, const GridPoint& qv, const ShapeEnergy& energy, Index pointsLeft) {
    setJetBasis(qu.basis, qv.basis, basis_);
    const Jet jet = poles_.lazyProduct(basis_.transpose());
    const shape_energy::ResidualsWithDerivatives r = energy.linearised(jet);
    const Index count = r.values.size(), rows = filled_ + count * pointsLeft;
    if (jacobian_.rows() < rows) {
      jacobian_.conservativeResize(rows, 3 * poles_.cols());
      residuals_.conservativeResize(rows);
    }
    const double scale = std::sqrt(qu.weight * qv.weight);
    for (Index k = 0; k < count; ++k, ++filled_) {
      const Jet slopes = scale * Eigen::Map<const Jet>(r.derivatives.row(k).data());
      Eigen::Map<Eigen::Matrix3Xd>(jacobian_.row(filled_).data(), 3, poles_.cols()) =
          slopes.lazyProduct(basis_);
      residuals_[filled_] = scale * r.values[k];
    }
  }

  [[nodiscard]] ShapeElement finish(const std::vector<int>& numbers) const {
    ShapeElement element;
    for (const int pole : indices_)
      element.points.push_back(numbers[static_cast<std::size_t>(pole)]);
    element.value = residuals_.squaredNorm();
    element.gradient = 2.0 * (jacobian_.transpose() * residuals_);
    MatrixXd& hessian = element.hessian;
    hessian.setZero(jacobian_.cols(), jacobian_.cols());
    hessian.selfadjointView<Eigen::Lower>().rankUpdate(jacobian_.transpose(), 2.0);
    hessian.triangularView<Eigen::StrictlyUpper>() = hessian.transpose();
    return element;
  }

 private:
  std::vector<int> indices_;
  Eigen::Matrix3Xd poles_;
  JetBasis basis_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian_;
  Eigen::VectorXd residuals_;
  Index filled_ = 0;
};

void appendElements(const BsplineSurface& patch,
                    const std::vector<int>& numbers,
                    const ShapeEnergy& energy,
                    int points,
                    std::vector<ShapeElement>& elements) {
  const GridLine u(patch.u, points), v(patch.v, points);
  for (std::size_t su = 0; su < u.points.size(); su += u.perSpan)
    for (std::size_t sv = 0; sv < v.points.size(); sv += v.perSpan) {
      SpanModel model(patch, u.points[su].basis, v.points[sv].basis);
      std::size_t left = u.perSpan * v.perSpan;
      for (std::size_t i = su; i < su + u.perSpan; ++i)
        for (std::size_t j = sv; j < sv + v.perSpan; ++j, --left)
          model.add(u.points[i], v.points[j], energy, static_cast<Index>(left));
      elements.push_back(model.finish(numbers));
    }
}

}  // namespace

std::vector<ShapeElement> assembleShapeEnergy(const layout::PatchLayout& layout,
                                              const std::vector<BsplineSurface>& patches,
                                              const ShapeEnergy& energy,
                                              int points) {
  FAIRING_ASSERT(patches.size() == layout.patches.size());
  std::vector<ShapeElement> elements;
  for (std::size_t p = 0; p < patches.size(); ++p)
    appendElements(patches[p], layout.patches[p].points, energy, points, elements);
  return elements;
}

double shapeEnergyOf(const std::vector<BsplineSurface>& patches,
                     const ShapeEnergy& energy,
                     int points) {
  double sum = 0.0;
  for (const BsplineSurface& patch : patches) {
    const GridLine u(patch.u, points), v(patch.v, points);
    for (const GridPoint& qu : u.points)
      for (const GridPoint& qv : v.points) {
        const Jet jet = spline::thirdOrderJet(patch.derivatives(qu.basis, qv.basis, 3));
        sum += qu.weight * qv.weight * energy.residuals(jet).squaredNorm();
      }
  }
  return sum;
}

}  // namespace fairing::assembly
