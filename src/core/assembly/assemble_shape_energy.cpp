// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_shape_energy.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <span>

#include "core/assembly/span_newton.h"
#include "core/base/assert.h"
#include "core/base/parallel_for.h"
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
using spline::QuadratureRule;

// One direction's points of the quadrature.
GridLine gridLine(const spline::KnotVector& knots, const QuadratureRule& rule) {
  return {knots, rule.orPoints(knots.degree())};
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
  SpanModel(const BasisRow& bu, const BasisRow& bv, std::size_t points) {
    const Index count = bu.values.cols() * bv.values.cols();
    basis_.resize(9, count);
    values_.resize(static_cast<Index>(points), count);
    projections_.resize(9, values_.rows());
  }

  void add(const GridPoint& qu, const GridPoint& qv, const Jet& jet, const ShapeEnergy& energy) {
    addTangential(qu, qv, jet);
    setJetBasis(qu.basis, qv.basis, basis_);
    const shape_energy::ResidualsWithDerivatives r = energy.linearised(jet);
    const Index count = r.values.size();
    if (filled_ == 0) {
      jacobian_.resize(count * values_.rows(), 3 * basis_.cols());
      residuals_.resize(jacobian_.rows());
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
  void addTangential(const GridPoint& qu, const GridPoint& qv, const Jet& jet) {
    const Index k = placed_++, kv = qv.basis.values.cols();
    for (Index i = 0; i < qu.basis.values.cols(); ++i)
      values_.row(k).segment(i * kv, kv) = qu.basis.values(0, i) * qv.basis.values.row(0);
    const Eigen::Vector3d normal = jet.col(0).cross(jet.col(1)).normalized();
    Eigen::Map<Eigen::Matrix3d>(projections_.col(k).data()) =
        qu.weight * qv.weight * (Eigen::Matrix3d::Identity() - normal * normal.transpose());
  }

  [[nodiscard]] ShapeElement tangential() const {
    ShapeElement element;
    element.hessian.setZero(3 * values_.cols(), 3 * values_.cols());
    pin(1.0, element.hessian);
    return element;
  }

  [[nodiscard]] ShapeElement finish(double pinning) const {
    ShapeElement element;
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

  MatrixXd values_;                                       // point, basis function
  Eigen::Matrix<double, 9, Eigen::Dynamic> projections_;  // a 3 x 3 matrix a point
  JetBasis basis_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian_;
  Eigen::VectorXd residuals_;
  Index placed_ = 0, filled_ = 0;  // points, residuals
};

// A patch and its span, counted along u and v.
struct Span {
  std::size_t patch, u, v;
};

std::vector<Span> spansOf(const layout::PatchLayout& layout) {
  std::vector<Span> spans;
  for (std::size_t p = 0; p < layout.patches.size(); ++p) {
    const std::size_t countU = layout.patches[p].u.breaks().size() - 1;
    const std::size_t countV = layout.patches[p].v.breaks().size() - 1;
    for (std::size_t u = 0; u < countU; ++u)
      for (std::size_t v = 0; v < countV; ++v) spans.push_back({p, u, v});
  }
  return spans;
}

// The points whose basis functions do not vanish on a span, in the order of SpanModel.
std::vector<int> pointsOf(const layout::LayoutPatch& patch, const BasisRow& u, const BasisRow& v) {
  std::vector<int> points;
  for (Index i = 0; i < u.values.cols(); ++i)
    for (Index j = 0; j < v.values.cols(); ++j)
      points.push_back(
          patch
              .points[static_cast<std::size_t>((u.first + i) * patch.v.poleCount() + v.first + j)]);
  return points;
}

// The points of the quadrature on one patch and the jets there.
struct PatchGrid {
  PatchGrid(const BsplineSurface& patch, const QuadratureRule& rule)
      : u(gridLine(patch.u, rule)), v(gridLine(patch.v, rule)), jets(gridJets(patch, u, v)) {}
  [[nodiscard]] const Jet& jet(std::size_t i, std::size_t j) const {
    return jets[i * v.points.size() + j];
  }

  GridLine u, v;
  std::vector<Jet> jets;
};

std::vector<PatchGrid> gridsOf(const std::vector<BsplineSurface>& patches,
                               const QuadratureRule& rule) {
  std::vector<std::optional<PatchGrid>> made(patches.size());
  inParallel(patches.size(), [&](std::size_t p) { made[p].emplace(patches[p], rule); });
  std::vector<PatchGrid> grids;
  for (std::optional<PatchGrid>& grid : made) grids.push_back(std::move(*grid));
  return grids;
}

// The points of the quadrature in one span of a patch.
struct SpanPoints {
  std::span<const GridPoint> u, v;
  std::span<const Jet> jets;  // from the first one on
  std::size_t stride;

  [[nodiscard]] const Jet& jet(std::size_t i, std::size_t j) const { return jets[i * stride + j]; }
  [[nodiscard]] double weight(std::size_t i, std::size_t j) const {
    return u[i].weight * v[j].weight;
  }
};

// One element a span, make(points of the quadrature), whatever the number of threads.
template <class Make>
std::vector<ShapeElement> elementsOf(const layout::PatchLayout& layout,
                                     const std::vector<BsplineSurface>& patches,
                                     const QuadratureRule& rule,
                                     const Make& make) {
  FAIRING_ASSERT(patches.size() == layout.patches.size());
  const std::vector<PatchGrid> grids = gridsOf(patches, rule);
  const std::vector<Span> spans = spansOf(layout);
  std::vector<ShapeElement> elements(spans.size());
  inParallel(spans.size(), [&](std::size_t k) {
    const auto& [p, spanU, spanV] = spans[k];
    const GridLine &u = grids[p].u, &v = grids[p].v;
    const std::size_t su = spanU * u.perSpan, sv = spanV * v.perSpan, stride = v.points.size();
    const SpanPoints at{std::span(u.points).subspan(su, u.perSpan),
                        std::span(v.points).subspan(sv, v.perSpan),
                        std::span(grids[p].jets).subspan(su * stride + sv),
                        stride};
    elements[k] = make(at);
    elements[k].points = pointsOf(layout.patches[p], at.u[0].basis, at.v[0].basis);
  });
  return elements;
}

SpanModel modelOf(const SpanPoints& at) {
  return {at.u[0].basis, at.v[0].basis, at.u.size() * at.v.size()};
}

ShapeElement linearisationOf(const SpanPoints& at, const ShapeEnergy& energy, double pinning) {
  SpanModel model = modelOf(at);
  for (std::size_t i = 0; i < at.u.size(); ++i)
    for (std::size_t j = 0; j < at.v.size(); ++j) model.add(at.u[i], at.v[j], at.jet(i, j), energy);
  return model.finish(pinning);
}

ShapeElement tangentialOf(const SpanPoints& at) {
  SpanModel model = modelOf(at);
  for (std::size_t i = 0; i < at.u.size(); ++i)
    for (std::size_t j = 0; j < at.v.size(); ++j)
      model.addTangential(at.u[i], at.v[j], at.jet(i, j));
  return model.tangential();
}

// With all second derivatives.
ShapeElement expansionOf(const SpanPoints& at, const ShapeEnergy& energy) {
  ShapeElement element;
  const Index count = at.u[0].basis.values.cols() * at.v[0].basis.values.cols();
  JetBasis basis(9, count);
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, count);
  std::vector<shape_energy::DensityHessian> hessians;
  for (std::size_t i = 0; i < at.u.size(); ++i)
    for (std::size_t j = 0; j < at.v.size(); ++j) {
      const shape_energy::DensityExpansion density = energy.expanded(at.jet(i, j));
      const double weight = at.weight(i, j);
      setJetBasis(at.u[i].basis, at.v[j].basis, basis);
      element.value += weight * density.value;
      gradient += (weight * density.gradient) * basis;
      hessians.push_back(weight * density.hessian);
    }
  element.gradient = Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size());
  element.hessian = SpanNewton(at.u, at.v).hessian(hessians);
  return element;
}

}  // namespace

std::vector<std::vector<int>> spanPoints(const layout::PatchLayout& layout) {
  const auto rowAt = [](const spline::KnotVector& knots, std::size_t span) {
    const std::vector<double> breaks = knots.breaks();
    return spline::basisRow(knots, 0.5 * (breaks[span] + breaks[span + 1]), 0);
  };
  std::vector<std::vector<int>> points;
  for (const Span& span : spansOf(layout)) {
    const layout::LayoutPatch& patch = layout.patches[span.patch];
    points.push_back(pointsOf(patch, rowAt(patch.u, span.u), rowAt(patch.v, span.v)));
  }
  return points;
}

std::vector<ShapeElement> assembleShapeEnergy(const layout::PatchLayout& layout,
                                              const std::vector<BsplineSurface>& patches,
                                              const ShapeEnergy& energy,
                                              const QuadratureRule& rule,
                                              double pinning) {
  return elementsOf(layout, patches, rule, [&](const SpanPoints& at) {
    return linearisationOf(at, energy, pinning);
  });
}

std::vector<ShapeElement> expandShapeEnergy(const layout::PatchLayout& layout,
                                            const std::vector<BsplineSurface>& patches,
                                            const ShapeEnergy& energy,
                                            const QuadratureRule& rule) {
  return elementsOf(
      layout, patches, rule, [&](const SpanPoints& at) { return expansionOf(at, energy); });
}

std::vector<ShapeElement> assembleTangential(const layout::PatchLayout& layout,
                                             const std::vector<BsplineSurface>& patches,
                                             const QuadratureRule& rule) {
  return elementsOf(layout, patches, rule, tangentialOf);
}

// The sum is taken in one order, whatever the number of threads.
double shapeEnergyOf(const std::vector<BsplineSurface>& patches,
                     const ShapeEnergy& energy,
                     const QuadratureRule& rule) {
  struct Line {
    std::size_t patch, u;
  };
  const std::vector<PatchGrid> grids = gridsOf(patches, rule);
  std::vector<Line> lines;
  for (std::size_t p = 0; p < grids.size(); ++p)
    for (std::size_t u = 0; u < grids[p].u.points.size(); ++u) lines.push_back({p, u});
  std::vector<std::vector<double>> shares(lines.size());
  inParallel(lines.size(), [&](std::size_t k) {
    const auto [p, i] = lines[k];
    const PatchGrid& grid = grids[p];
    for (std::size_t j = 0; j < grid.v.points.size(); ++j)
      shares[k].push_back(grid.u.points[i].weight * grid.v.points[j].weight *
                          energy.residuals(grid.jet(i, j)).squaredNorm());
  });
  double sum = 0.0;
  for (const std::vector<double>& line : shares)
    for (const double share : line) sum += share;
  return sum;
}

}  // namespace fairing::assembly
