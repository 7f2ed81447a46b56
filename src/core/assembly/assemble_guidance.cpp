// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_guidance.h"

#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "core/energy/guidance_samples.h"
#include "core/spline/bspline_basis.h"

// A sample adds squares of linear forms in the coordinates of the points that its span touches:
//   w lambda (R_u . N)^2 + w lambda (R_v . N)^2 + w gamma |R|^2 - ...
// The forms of a span are gathered as columns of a matrix A, and A A' is added by the dozen.

namespace fairing::assembly {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kGathered = 64;

// The sum of a a' over many columns a.
class Squares {
 public:
  explicit Squares(Index size) : sum_(MatrixXd::Zero(size, size)) {}

  // A new column, to be filled before the next one is asked for.
  Eigen::Ref<VectorXd> column() {
    if (gathered_.size() == 0) gathered_.resize(sum_.rows(), kGathered);
    if (count_ == kGathered) flush();
    return gathered_.col(count_++);
  }
  // Its lower triangle.
  const MatrixXd& sum() {
    flush();
    return sum_;
  }

 private:
  void flush() {
    if (count_ > 0) sum_.selfadjointView<Eigen::Lower>().rankUpdate(gathered_.leftCols(count_));
    count_ = 0;
  }

  MatrixXd sum_, gathered_;
  Index count_ = 0;
};

// What the samples of one span of one patch add up to.
struct SpanSum {
  std::vector<int> points;
  Squares normals{0}, positions{0};
};

// Adds samples, span by span: there may be far more of them than spans.
class Accumulator {
 public:
  explicit Accumulator(const layout::PatchLayout& layout)
      : count_(layout.pointCount), load_(VectorXd::Zero(3 * layout.pointCount)) {}

  void add(std::size_t number, const layout::LayoutPatch& patch, const energy::WeightedSample& s) {
    const double lambda = s.weight * s.guide.lambda, gamma = s.weight * s.guide.gamma;
    if (lambda == 0.0 && gamma == 0.0) return;
    const spline::BasisRow bu = spline::basisRow(patch.u, s.u, 1),
                           bv = spline::basisRow(patch.v, s.v, 1);
    SpanSum& span = spanAt(number, patch, bu.first, bv.first);
    if (lambda > 0.0) {
      const Eigen::Vector3d normal = std::sqrt(lambda) * s.guide.normal;
      fill(span.normals.column(), bu.values.row(1), bv.values.row(0), normal);
      fill(span.normals.column(), bu.values.row(0), bv.values.row(1), normal);
    }
    if (gamma > 0.0) {
      auto column = span.positions.column();
      fill(column, bu.values.row(0), bv.values.row(0), Eigen::Matrix<double, 1, 1>::Ones());
      for (Index k = 0; k < column.size(); ++k)
        load_.segment<3>(3 * span.points[static_cast<std::size_t>(k)]) +=
            gamma * column[k] * s.guide.point;
      column *= std::sqrt(gamma);
      constant_ += 0.5 * gamma * s.guide.point.squaredNorm();
    }
  }

  [[nodiscard]] GuidanceSystem finish() {
    std::vector<Eigen::Triplet<double>> normals, positions;
    for (auto& [place, span] : spans_) {
      spread<3>(span.points, span.normals.sum(), normals);
      spread<1>(span.points, span.positions.sum(), positions);
    }
    GuidanceSystem system{solver::Sparse(3 * count_, 3 * count_),
                          solver::Sparse(count_, count_),
                          std::move(load_),
                          constant_};
    system.normals.setFromTriplets(normals.begin(), normals.end());
    system.points.setFromTriplets(positions.begin(), positions.end());
    return system;
  }

 private:
  // The tensor product of two rows of a basis and a vector.
  template <class Vector>
  static void fill(Eigen::Ref<VectorXd> column,
                   const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& alongU,
                   const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& alongV,
                   const Vector& vector) {
    Index at = 0;
    for (Index i = 0; i < alongU.size(); ++i)
      for (Index j = 0; j < alongV.size(); ++j, at += vector.size())
        column.segment<Vector::RowsAtCompileTime>(at) = alongU[i] * alongV[j] * vector;
  }

  // Both triangles of the sum of a span.
  template <int width>
  static void spread(const std::vector<int>& points,
                     const MatrixXd& lower,
                     std::vector<Eigen::Triplet<double>>& entries) {
    const auto place = [&](Index k) {
      return width * points[static_cast<std::size_t>(k / width)] + static_cast<int>(k % width);
    };
    for (Index c = 0; c < lower.cols(); ++c)
      for (Index r = c; r < lower.rows(); ++r) {
        if (lower(r, c) == 0.0) continue;
        entries.emplace_back(place(r), place(c), lower(r, c));
        if (r != c) entries.emplace_back(place(c), place(r), lower(r, c));
      }
  }

  SpanSum& spanAt(std::size_t number, const layout::LayoutPatch& patch, int firstU, int firstV) {
    const auto [found, isNew] = spans_.try_emplace({number, firstU, firstV});
    SpanSum& span = found->second;
    if (!isNew) return span;
    for (int i = 0; i <= patch.u.degree(); ++i)
      for (int j = 0; j <= patch.v.degree(); ++j)
        span.points.push_back(
            patch
                .points[static_cast<std::size_t>((firstU + i) * patch.v.poleCount() + firstV + j)]);
    const auto size = static_cast<Index>(span.points.size());
    span.normals = Squares(3 * size);
    span.positions = Squares(size);
    return span;
  }

  Index count_;
  std::map<std::tuple<std::size_t, int, int>, SpanSum> spans_;
  VectorXd load_;
  double constant_ = 0.0;
};

}  // namespace

solver::Sparse GuidanceSystem::coupled() const {
  return normals + solver::threefold(points);
}

GuidanceSystem assembleGuidance(const layout::PatchLayout& layout,
                                const energy::Guidance& guidance,
                                const std::vector<spline::BsplineSurface>& current) {
  const energy::NormalFeet feet(guidance, current);
  Accumulator sum(layout);
  for (std::size_t p = 0; p < layout.patches.size(); ++p) {
    const layout::LayoutPatch& patch = layout.patches[p];
    for (const energy::WeightedSample& s :
         energy::guidanceSamples(guidance, feet, patch.u, patch.v, current[p]))
      sum.add(p, patch, s);
  }
  return sum.finish();
}

}  // namespace fairing::assembly
