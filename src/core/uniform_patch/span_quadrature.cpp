// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/uniform_patch/span_quadrature.h"

#include <algorithm>

#include "core/spline/quadrature.h"
#include "core/spline/surface_grid.h"

namespace fairing::uniform_patch {

Eigen::Matrix4d cubicRows(double t) {
  const double s = 1.0 - t;
  Eigen::Matrix4d rows;
  rows << s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
      (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0, t * t * t / 6.0,             //
      -0.5 * s * s, 1.5 * t * t - 2.0 * t, 2.0 * s - 1.5 * s * s, 0.5 * t * t,  //
      s, 3.0 * t - 2.0, 3.0 * s - 2.0, t,                                       //
      -1.0, 3.0, -3.0, 1.0;
  return rows;
}

SpanPlace::SpanPlace(double t, int spans)
    : span(std::clamp(static_cast<int>(t) - 3, 0, spans - 1)), local(t - 3.0 - span) {}

SpanQuadrature::SpanQuadrature(int pointsPerDirection)
    : n(pointsPerDirection), jets(9 * n * n, 16) {
  for (const spline::QuadraturePoint& point : spline::gaussLegendre(n, 0.0, 1.0)) {
    rows.push_back(cubicRows(point.parameter));
    weights.push_back(point.weight);
  }
  for (int p = 0; p < n; ++p)
    for (int q = 0; q < n; ++q)
      for (int k = 0; k < 9; ++k)
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j)
            jets(9 * index(p, q) + k, 4 * i + j) =
                rows[std::size_t(p)](spline::kJetOrders[k][0], i) *
                rows[std::size_t(q)](spline::kJetOrders[k][1], j);
}

}  // namespace fairing::uniform_patch
