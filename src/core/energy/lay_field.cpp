// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/energy/lay_field.h"

#include <limits>

namespace fairing::energy {
namespace {

using spline::BsplineSurface;

/// How a field over the unit square becomes one over the patch's: swapped first, then mirrored.
struct Turn {
  bool swapped = false, mirroredU = false, mirroredV = false;
};

/// Where a point of the field lies on the patch's unit square.
Eigen::Vector2d place(const Turn& turn, double u, double v) {
  if (turn.swapped) std::swap(u, v);
  return {turn.mirroredU ? 1.0 - u : u, turn.mirroredV ? 1.0 - v : v};
}

double distance(const Turn& turn, const FieldCorners& corners, const BsplineSurface& patch) {
  const auto at = [&](double u, double v) {
    const Eigen::Vector2d to = place(turn, u, v);
    return patch.evaluate(to[0] < 0.5 ? patch.u.first() : patch.u.last(),
                          to[1] < 0.5 ? patch.v.first() : patch.v.last());
  };
  return (at(0, 0) - corners.origin).squaredNorm() + (at(1, 0) - corners.alongU).squaredNorm() +
         (at(0, 1) - corners.alongV).squaredNorm();
}

Turn turnOnto(const BsplineSurface& patch, const FieldCorners& corners) {
  Turn best;
  double least = std::numeric_limits<double>::infinity();
  for (const bool swapped : {false, true})
    for (const bool u : {false, true})
      for (const bool v : {false, true}) {
        const Turn turn{swapped, u, v};
        const double far = distance(turn, corners, patch);
        if (far < least) best = turn;
        least = std::min(least, far);
      }
  return best;
}

// Row i * nv + j of a grid of nu x nv rows, in its new place.
template <class Rows>
Rows turnedRows(const Rows& rows, int nu, int nv, const Turn& turn) {
  Rows result = rows;
  const int newNu = turn.swapped ? nv : nu, newNv = turn.swapped ? nu : nv;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      int a = turn.swapped ? j : i, b = turn.swapped ? i : j;
      if (turn.mirroredU) a = newNu - 1 - a;
      if (turn.mirroredV) b = newNv - 1 - b;
      result.row(a * newNv + b) = rows.row(i * nv + j);
    }
  return result;
}

BsplineSurface turned(const BsplineSurface& s, const Turn& turn) {
  const auto& u = turn.swapped ? s.v : s.u;
  const auto& v = turn.swapped ? s.u : s.v;
  return {turn.mirroredU ? u.reversed() : u,
          turn.mirroredV ? v.reversed() : v,
          turnedRows(s.poles, s.u.poleCount(), s.v.poleCount(), turn)};
}

DiscreteGuidance turned(const DiscreteGuidance& grid, const Turn& turn) {
  const auto rows = [&](const auto& all) { return turnedRows(all, grid.n + 1, grid.m + 1, turn); };
  return {turn.swapped ? grid.m : grid.n,
          turn.swapped ? grid.n : grid.m,
          rows(grid.normals),
          rows(grid.points),
          rows(grid.lambda),
          rows(grid.gamma)};
}

}  // namespace

Guidance laidOn(const Guidance& guidance, const BsplineSurface& patch) {
  Guidance laid;
  laid.lambda = guidance.lambda;
  laid.gamma = guidance.gamma;
  laid.continuous = guidance.continuous;
  laid.discrete = guidance.discrete;
  if (!guidance.corners) return laid;
  const Turn turn = turnOnto(patch, *guidance.corners);
  if (laid.continuous) {
    laid.continuous->normals = turned(laid.continuous->normals, turn);
    if (laid.continuous->reference)
      laid.continuous->reference = turned(*laid.continuous->reference, turn);
  }
  if (laid.discrete) laid.discrete = turned(*laid.discrete, turn);
  return laid;
}

}  // namespace fairing::energy
