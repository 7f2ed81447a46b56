// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/strip.h"

#include "core/boundary/strip_match.h"

namespace fairing::layout {
namespace {

// Chains with more control points are not taken over.
constexpr int kMostPoles = 48;
constexpr int kSamples = 32;

// Mean distance of the points that belong together.
double meanHeight(const boundary::BoundaryLoop& sides) {
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const double t = (k + 0.5) / kSamples;
    sum +=
        (sides.sides[0].ribbon.curve(t).point - sides.sides[1].ribbon.curve(1.0 - t).point).norm();
  }
  return sum / kSamples;
}

}  // namespace

Result<LayoutPlan> stripPlan(const boundary::ChainPair& pair) {
  auto cut = boundary::cutPair(pair, kMostPoles);
  if (!cut) return fail(cut.error());
  const double width = 0.5 * (cut->loop.sides[0].length + cut->loop.sides[1].length);
  const double height = meanHeight(cut->loop);
  LayoutPlan plan{LayoutKind::Strip, std::move(*cut), {}, pair.closed};
  plan.mesh.quads = {{{0, 1, 2, 3}, {0, -1, 1, -1}}};
  plan.mesh.vertices = {{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}};
  plan.mesh.inside.assign(4, 0);
  return plan;
}

}  // namespace fairing::layout
