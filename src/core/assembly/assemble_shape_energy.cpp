// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_shape_energy.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.h"
#include "core/spline/surface_grid.h"

namespace fairing::assembly {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using shape_energy::Jet;
using shape_energy::ShapeEnergy;
using spline::BasisRow;
using spline::BsplineSurface;
using spline::GridLine;
using spline::GridPoint;

// One direction's points of the quadrature.
GridLine gridLine(const spline::KnotVector& knots, int asked) {
  return {knots, asked > 0 ? asked : knots.degree()};
}

// Row k: the derivative that is the jet's column k, of each control point's basis function.
using JetBasis = Eigen::Matrix<double, 9, Eigen::Dynamic>;

void setJetBasis(const BasisRow& bu, const BasisRow& bv, JetBasis& basis) {
  Index column = 0;
  for (Index i = 0; i < bu.values.cols(); ++i)
    for (Index j = 0; j < bv.values.cols(); ++j, ++column)
      for (int k = 0; k < 9; ++k)
        basis(k, column) =
            bu.values(spline::kJetOrders[k][0], i) * bv.values(spline::kJetOrders[k][1], j);
}

// One span: gathers the weighted residuals of its quadrature points and their derivatives with
// respect to its control points.
class SpanModel {
 public:
  SpanModel(const BsplineSurface& patch, const BasisRow& bu, const BasisRow& bv) {
    const int ku = static_cast<int>(bu.values.cols()), kv = static_cast<int>(bv.values.cols());
    basis_.resize(9, ku * kv);
    values_.resize(0, ku * kv);
    for (int i = 0; i < ku; ++i)
      for (int j = 0; j < kv; ++j) indices_.push_back(patch.index(bu.first + i, bv.first + j));
  }

  void add(const GridPoint& qu,
           const GridPoint& qv,
           const Jet& jet,
           const ShapeEnergy& energy,
           Index pointsLeft) {
    addTangential(qu, qv, jet, pointsLeft);
    setJetBasis(qu.basis, qv.basis, basis_);
    const shape_energy::ResidualsWithDerivatives r = energy.linearised(jet);
    const Index count = r.values.size(), rows = filled_ + count * pointsLeft;
    if (jacobian_.rows() < rows) {
      jacobian_.conservativeResize(rows, 3 * basis_.cols());
      residuals_.conservativeResize(rows);
    }
    const double scale = std::sqrt(qu.weight * qv.weight);
    for (Index k = 0; k < count; ++k, ++filled_) {
      const Jet slopes = scale * Eigen::Map<const Jet>(r.derivatives.row(k).data());
      Eigen::Map<Eigen::Matrix3Xd>(jacobian_.row(filled_).data(), 3, basis_.cols()) =
          slopes.lazyProduct(basis_);
      residuals_[filled_] = scale * r.values[k];
    }
  }

  // Basis functions, and the weighted projection onto the tangent plane.
  void addTangential(const GridPoint& qu, const GridPoint& qv, const Jet& jet, Index pointsLeft) {
    if (values_.rows() == 0) {
      values_.resize(pointsLeft, values_.cols());
      projections_.resize(9, pointsLeft);
    }
    const Index k = values_.rows() - pointsLeft, kv = qv.basis.values.cols();
    for (Index i = 0; i < qu.basis.values.cols(); ++i)
      values_.row(k).segment(i * kv, kv) = qu.basis.values(0, i) * qv.basis.values.row(0);
    const Eigen::Vector3d normal = jet.col(0).cross(jet.col(1)).normalized();
    Eigen::Map<Eigen::Matrix3d>(projections_.col(k).data()) =
        qu.weight * qv.weight * (Eigen::Matrix3d::Identity() - normal * normal.transpose());
  }

  [[nodiscard]] ShapeElement tangential(const std::vector<int>& numbers) const {
    ShapeElement element = empty(numbers);
    element.hessian.setZero(3 * values_.cols(), 3 * values_.cols());
    pin(1.0, element.hessian);
    return element;
  }

  [[nodiscard]] ShapeElement finish(const std::vector<int>& numbers, double pinning) const {
    ShapeElement element = empty(numbers);
    element.value = residuals_.squaredNorm();
    element.gradient = 2.0 * (jacobian_.transpose() * residuals_);
    MatrixXd& hessian = element.hessian;
    hessian.setZero(jacobian_.cols(), jacobian_.cols());
    hessian.selfadjointView<Eigen::Lower>().rankUpdate(jacobian_.transpose(), 2.0);
    hessian.triangularView<Eigen::StrictlyUpper>() = hessian.transpose();
    if (pinning > 0.0) pin(pinning, hessian);
    return element;
  }

 private:
  [[nodiscard]] ShapeElement empty(const std::vector<int>& numbers) const {
    ShapeElement element;
    for (const int pole : indices_)
      element.points.push_back(numbers[static_cast<std::size_t>(pole)]);
    return element;
  }
  void pin(double weight, MatrixXd& hessian) const {
    using Stride = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
    const Index n = values_.cols(), rows = hessian.rows();
    for (Index a = 0; a < 3; ++a)
      for (Index b = 0; b <= a; ++b) {
        const MatrixXd weighted =
            (weight * projections_.row(3 * a + b).transpose()).asDiagonal() * values_;
        const MatrixXd gram = values_.transpose() * weighted;
        const auto block = [&](Index c, Index d) {
          return Eigen::Map<MatrixXd, 0, Stride>(
              hessian.data() + d * rows + c, n, n, Stride(3 * rows, 3));
        };
        block(a, b) += gram;
        if (a != b) block(b, a) += gram;
      }
  }

  std::vector<int> indices_;
  MatrixXd values_;                                       // point, basis function
  Eigen::Matrix<double, 9, Eigen::Dynamic> projections_;  // a 3 x 3 matrix a point
  JetBasis basis_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian_;
  Eigen::VectorXd residuals_;
  Index filled_ = 0;
};

void scatter(const ShapeElement& element, std::vector<Eigen::Triplet<double>>& entries) {
  const Index n = element.hessian.rows();
  const auto place = [&](Index k) {
    return 3 * element.points[static_cast<std::size_t>(k / 3)] + static_cast<int>(k % 3);
  };
  for (Index column = 0; column < n; ++column)
    for (Index row = 0; row < n; ++row)
      entries.emplace_back(place(row), place(column), element.hessian(row, column));
}

// Calls add(model, qu, qv, jet, points left in the span) at every point of the quadrature, then
// finish(model), span by span.
template <class Add, class Finish>
void visitSpans(const BsplineSurface& patch, int points, const Add& add, const Finish& finish) {
  const GridLine u = gridLine(patch.u, points), v = gridLine(patch.v, points);
  const std::vector<Jet> jets = spline::gridJets(patch, u, v);
  for (std::size_t su = 0; su < u.points.size(); su += u.perSpan)
    for (std::size_t sv = 0; sv < v.points.size(); sv += v.perSpan) {
      SpanModel model(patch, u.points[su].basis, v.points[sv].basis);
      std::size_t left = u.perSpan * v.perSpan;
      for (std::size_t i = su; i < su + u.perSpan; ++i)
        for (std::size_t j = sv; j < sv + v.perSpan; ++j, --left)
          add(model,
              u.points[i],
              v.points[j],
              jets[i * v.points.size() + j],
              static_cast<Index>(left));
      finish(model);
    }
}

}  // namespace

std::vector<ShapeElement> assembleShapeEnergy(const layout::PatchLayout& layout,
                                              const std::vector<BsplineSurface>& patches,
                                              const ShapeEnergy& energy,
                                              int points,
                                              double pinning) {
  FAIRING_ASSERT(patches.size() == layout.patches.size());
  std::vector<ShapeElement> elements;
  for (std::size_t p = 0; p < patches.size(); ++p)
    visitSpans(
        patches[p],
        points,
        [&](SpanModel& model, const GridPoint& u, const GridPoint& v, const Jet& jet, Index left) {
          model.add(u, v, jet, energy, left);
        },
        [&](const SpanModel& model) {
          elements.push_back(model.finish(layout.patches[p].points, pinning));
        });
  return elements;
}

Eigen::SparseMatrix<double> assembleTangential(const layout::PatchLayout& layout,
                                               const std::vector<BsplineSurface>& patches,
                                               int points) {
  FAIRING_ASSERT(patches.size() == layout.patches.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t p = 0; p < patches.size(); ++p)
    visitSpans(
        patches[p],
        points,
        [&](SpanModel& model, const GridPoint& u, const GridPoint& v, const Jet& jet, Index left) {
          model.addTangential(u, v, jet, left);
        },
        [&](const SpanModel& model) {
          scatter(model.tangential(layout.patches[p].points), entries);
        });
  Eigen::SparseMatrix<double> matrix(3 * layout.pointCount, 3 * layout.pointCount);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double shapeEnergyOf(const std::vector<BsplineSurface>& patches,
                     const ShapeEnergy& energy,
                     int points) {
  double sum = 0.0;
  for (const BsplineSurface& patch : patches) {
    const GridLine u = gridLine(patch.u, points), v = gridLine(patch.v, points);
    const std::vector<Jet> jets = spline::gridJets(patch, u, v);
    auto jet = jets.begin();
    for (const GridPoint& qu : u.points)
      for (const GridPoint& qv : v.points)
        sum += qu.weight * qv.weight * energy.residuals(*jet++).squaredNorm();
  }
  return sum;
}

}  // namespace fairing::assembly
