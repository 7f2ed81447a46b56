// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/analysis/measure_fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/analysis/curvature.h"
#include "core/base/assert.h"
#include "core/spline/closest_point.h"

namespace fairing::analysis {
namespace {

// Stretches of a side meet up to rounding: a place between two of them is on the nearer one.
constexpr double kBetween = 1e-9;

const SideTrace& traceOf(const std::vector<SideTrace>& traces, std::size_t side, double t) {
  const SideTrace* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SideTrace& trace : traces) {
    const double beyond = std::max({trace.from - t, t - trace.to, 0.0});
    if (trace.side != static_cast<int>(side) || beyond >= least) continue;
    nearest = &trace;
    least = beyond;
  }
  FAIRING_ASSERT(least < kBetween && "every stretch of a side runs on a patch");
  return *nearest;
}

// Left of a trace in the patch's parameters is left of the side seen against u x v.
double sideOf(const SideTrace& trace, const spline::BsplineSurface& patch) {
  const Eigen::Vector2d along = trace.end - trace.start;
  const Eigen::Vector2d centre(0.5 * (patch.u.first() + patch.u.last()),
                               0.5 * (patch.v.first() + patch.v.last()));
  const Eigen::Vector2d inside = centre - trace.start;
  return along.x() * inside.y() - along.y() * inside.x() < 0.0 ? -1.0 : 1.0;
}

// Traces run along an edge of the patch.
Eigen::Vector3d acrossOf(const SideTrace& trace, const spline::SurfaceJet& jet) {
  const Eigen::Vector2d along = (trace.end - trace.start).cwiseAbs();
  return (along.x() > along.y() ? jet.v : jet.u).normalized();
}

}  // namespace

FillReport measureFill(const boundary::BoundaryLoop& loop,
                       const LoopProbe& probe,
                       const std::vector<spline::BsplineSurface>& patches,
                       const std::vector<SideTrace>& traces,
                       const Tolerance& tolerance) {
  return measureLoop(loop, probe, tolerance, [&](std::size_t side, const ProbePoint& p) {
    const SideTrace& trace = traceOf(traces, side, p.t);
    const Eigen::Vector2d guess = trace.at(p.t);
    const spline::BsplineSurface& patch = patches[static_cast<std::size_t>(trace.patch)];
    const spline::SurfaceFoot foot = spline::closestPoint(patch, p.point, guess[0], guess[1]);
    const Eigen::Vector3d normal = foot.jet.normalVector().normalized();
    return MeasuredFoot{foot.distance,
                        normal,
                        normalCurvature(foot.jet, normal.cross(p.tangent)),
                        sideOf(trace, patch),
                        acrossOf(trace, foot.jet)};
  });
}

}  // namespace fairing::analysis
