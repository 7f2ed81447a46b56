// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/guide_arrows.h"

#include "core/energy/lay_field.h"
#include "core/energy/normal_feet.h"

namespace fairing::energy {
namespace {

using Eigen::Vector3d;
using spline::BsplineSurface;

class Arrows {
 public:
  void add(const Vector3d& point, const Vector3d& normal, double weight) {
    if (weight > 0.0 && normal.norm() > 0.0) all.push_back({point, normal.normalized(), weight});
  }
  std::vector<GuideArrow> all;
};

void addGrid(const DiscreteGuidance& grid, const BsplineSurface& patch, Arrows& arrows) {
  for (int i = 0; i <= grid.n; ++i)
    for (int j = 0; j <= grid.m; ++j) {
      const Eigen::Index k = Eigen::Index(i) * (grid.m + 1) + j;
      const double u = patch.u.at(double(i) / grid.n), v = patch.v.at(double(j) / grid.m);
      arrows.add(patch.evaluate(u, v), grid.normals.row(k), grid.lambda[k]);
    }
}

Vector3d splineNormal(const BsplineSurface& normals, double u, double v) {
  return normals.evaluate(normals.u.at(u), normals.v.at(v));
}

}  // namespace

std::vector<GuideArrow> guideArrows(const Guidance& guidance,
                                    const std::vector<BsplineSurface>& patches,
                                    int count) {
  const NormalFeet feet(guidance, patches);
  Arrows arrows;
  for (const BsplineSurface& patch : patches) {
    const Guidance field = guidance.hasField() ? laidOn(guidance, patch) : Guidance{};
    if (field.discrete) addGrid(*field.discrete, patch, arrows);
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        const double u = (i + 0.5) / count, v = (j + 0.5) / count;
        const Vector3d here = patch.evaluate(patch.u.at(u), patch.v.at(v));
        const auto add = [&](const GuidanceSample& s) { arrows.add(here, s.normal, s.lambda); };
        if (field.continuous) arrows.add(here, splineNormal(field.continuous->normals, u, v), 1.0);
        if (guidance.parametric) add(guidance.parametric(u, v));
        if (guidance.hasNormals()) add(feet.at(here));
        if (guidance.reference) add(guidance.reference(here));
      }
  }
  return std::move(arrows.all);
}

}  // namespace fairing::energy
