// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_guidance.h"

#include <map>
#include <tuple>
#include <vector>

#include "core/energy/guidance_samples.h"
#include "core/spline/bspline_basis.h"

namespace fairing::assembly {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What the samples of one span of one patch add up to, in the coordinates of the poles it touches.
struct SpanSum {
  std::vector<int> points;
  MatrixXd coupled;  // 3 #points x 3 #points
};

// Adds samples, span by span: there may be far more of them than spans.
class Accumulator {
 public:
  Accumulator(const layout::PatchLayout& layout)
      : size_(3 * layout.pointCount), load_(VectorXd::Zero(3 * layout.pointCount)) {}

  void add(std::size_t number, const layout::LayoutPatch& patch, const energy::WeightedSample& s) {
    const spline::BasisRow bu = spline::basisRow(patch.u, s.u, 1),
                           bv = spline::basisRow(patch.v, s.v, 1);
    SpanSum& span = spanAt(number, patch, bu.first, bv.first);
    const auto count = static_cast<Eigen::Index>(span.points.size());
    VectorXd value(count), du(count), dv(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Index i = k / (patch.v.degree() + 1), j = k % (patch.v.degree() + 1);
      value[k] = bu.values(0, i) * bv.values(0, j);
      du[k] = bu.values(1, i) * bv.values(0, j);
      dv[k] = bu.values(0, i) * bv.values(1, j);
    }
    const double lambda = s.weight * s.guide.lambda, gamma = s.weight * s.guide.gamma;
    const MatrixXd tangential = lambda * (du * du.transpose() + dv * dv.transpose());
    const MatrixXd positional = gamma * (value * value.transpose());
    const Matrix3d nn = s.guide.normal * s.guide.normal.transpose();
    for (Eigen::Index a = 0; a < count; ++a) {
      load_.segment<3>(3 * span.points[static_cast<std::size_t>(a)]) +=
          gamma * value[a] * s.guide.point;
      for (Eigen::Index b = 0; b < count; ++b)
        span.coupled.block<3, 3>(3 * a, 3 * b) +=
            tangential(a, b) * nn + positional(a, b) * Matrix3d::Identity();
    }
    constant_ += 0.5 * gamma * s.guide.point.squaredNorm();
  }

  [[nodiscard]] GuidanceSystem finish() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [place, span] : spans_)
      for (Eigen::Index r = 0; r < span.coupled.rows(); ++r)
        for (Eigen::Index c = 0; c < span.coupled.cols(); ++c)
          if (span.coupled(r, c) != 0.0)
            entries.emplace_back(coordinate(span, r), coordinate(span, c), span.coupled(r, c));
    GuidanceSystem system{solver::Sparse(size_, size_), load_, constant_};
    system.coupled.setFromTriplets(entries.begin(), entries.end());
    return system;
  }

 private:
  SpanSum& spanAt(std::size_t number, const layout::LayoutPatch& patch, int firstU, int firstV) {
    const auto [found, isNew] = spans_.try_emplace({number, firstU, firstV});
    SpanSum& span = found->second;
    if (!isNew) return span;
    for (int i = 0; i <= patch.u.degree(); ++i)
      for (int j = 0; j <= patch.v.degree(); ++j)
        span.points.push_back(
            patch
                .points[static_cast<std::size_t>((firstU + i) * patch.v.poleCount() + firstV + j)]);
    const auto size = static_cast<Eigen::Index>(3 * span.points.size());
    span.coupled = MatrixXd::Zero(size, size);
    return span;
  }
  static int coordinate(const SpanSum& span, Eigen::Index row) {
    return 3 * span.points[static_cast<std::size_t>(row / 3)] + static_cast<int>(row % 3);
  }

  Eigen::Index size_;
  std::map<std::tuple<std::size_t, int, int>, SpanSum> spans_;
  VectorXd load_;
  double constant_ = 0.0;
};

}  // namespace

GuidanceSystem assembleGuidance(const layout::PatchLayout& layout,
                                const energy::Guidance& guidance,
                                const std::vector<spline::BsplineSurface>& current) {
  Accumulator sum(layout);
  for (std::size_t p = 0; p < layout.patches.size(); ++p) {
    const layout::LayoutPatch& patch = layout.patches[p];
    for (const energy::WeightedSample& s :
         energy::guidanceSamples(guidance, patch.u, patch.v, current[p]))
      sum.add(p, patch, s);
  }
  return sum.finish();
}

}  // namespace fairing::assembly
