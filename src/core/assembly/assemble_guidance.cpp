// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/assembly/assemble_guidance.h"

#include <algorithm>

#include "core/energy/guidance_samples.h"
#include "core/spline/bspline_basis.h"

namespace fairing::assembly {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Adds one sample: the poles it touches, with values and first derivatives of their basis
// functions.
class Accumulator {
 public:
  Accumulator(const layout::PatchLayout& layout)
      : size_(3 * layout.pointCount), load_(VectorXd::Zero(3 * layout.pointCount)) {}

  void add(const layout::LayoutPatch& patch, const energy::WeightedSample& sample) {
    const spline::BasisRow bu = spline::basisRow(patch.u, sample.u, 1),
                           bv = spline::basisRow(patch.v, sample.v, 1);
    const int nv = patch.v.poleCount();
    const int count = (patch.u.degree() + 1) * (patch.v.degree() + 1);
    VectorXd value(count), du(count), dv(count);
    std::vector<int> points;
    for (int i = 0; i <= patch.u.degree(); ++i)
      for (int j = 0; j <= patch.v.degree(); ++j) {
        const auto k = static_cast<Eigen::Index>(points.size());
        points.push_back(
            patch.points[static_cast<std::size_t>((bu.first + i) * nv + bv.first + j)]);
        value[k] = bu.values(0, i) * bv.values(0, j);
        du[k] = bu.values(1, i) * bv.values(0, j);
        dv[k] = bu.values(0, i) * bv.values(1, j);
      }
    const double lambda = sample.weight * sample.guide.lambda,
                 gamma = sample.weight * sample.guide.gamma;
    const MatrixXd tangential = lambda * (du * du.transpose() + dv * dv.transpose());
    const MatrixXd positional = gamma * (value * value.transpose());
    const Matrix3d nn = sample.guide.normal * sample.guide.normal.transpose();
    for (Eigen::Index a = 0; a < count; ++a) {
      const int pa = points[static_cast<std::size_t>(a)];
      load_.segment<3>(3 * pa) += gamma * value[a] * sample.guide.point;
      for (Eigen::Index b = 0; b < count; ++b)
        addBlock(pa,
                 points[static_cast<std::size_t>(b)],
                 tangential(a, b) * nn + positional(a, b) * Matrix3d::Identity());
    }
    constant_ += 0.5 * gamma * sample.guide.point.squaredNorm();
  }

  [[nodiscard]] GuidanceSystem finish() const {
    GuidanceSystem system{solver::Sparse(size_, size_), load_, constant_};
    system.coupled.setFromTriplets(entries_.begin(), entries_.end());
    return system;
  }

 private:
  void addBlock(int pa, int pb, const Matrix3d& block) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        if (block(r, c) != 0.0) entries_.emplace_back(3 * pa + r, 3 * pb + c, block(r, c));
  }

  Eigen::Index size_;
  std::vector<Eigen::Triplet<double>> entries_;
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
      sum.add(patch, s);
  }
  return sum.finish();
}

}  // namespace fairing::assembly
