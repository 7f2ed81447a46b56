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

  [[nodiscard]] ShapeElement finish(const std::vector<int>& numbers, double pinning) const {
    ShapeElement element;
    for (const int pole : indices_)
      element.points.push_back(numbers[static_cast<std::size_t>(pole)]);
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

void appendElements(const BsplineSurface& patch,
                    const std::vector<int>& numbers,
                    const ShapeEnergy& energy,
                    int points,
                    double pinning,
                    std::vector<ShapeElement>& elements) {
  const GridLine u = gridLine(patch.u, points), v = gridLine(patch.v, points);
  const std::vector<Jet> jets = spline::gridJets(patch, u, v);
  for (std::size_t su = 0; su < u.points.size(); su += u.perSpan)
    for (std::size_t sv = 0; sv < v.points.size(); sv += v.perSpan) {
      SpanModel model(patch, u.points[su].basis, v.points[sv].basis);
      std::size_t left = u.perSpan * v.perSpan;
      for (std::size_t i = su; i < su + u.perSpan; ++i)
        for (std::size_t j = sv; j < sv + v.perSpan; ++j, --left)
          model.add(u.points[i],
                    v.points[j],
                    jets[i * v.points.size() + j],
                    energy,
                    static_cast<Index>(left));
      elements.push_back(model.finish(numbers, pinning));
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
    appendElements(patches[p], layout.patches[p].points, energy, points, pinning, elements);
  return elements;
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
