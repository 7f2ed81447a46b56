// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/bezier_patch.h"

namespace fairing::spline {
namespace {

Eigen::Vector3d deCasteljau(Poles row, double t) {
  for (Eigen::Index round = row.rows() - 1; round > 0; --round)
    for (Eigen::Index k = 0; k < round; ++k)
      row.row(k) = (1.0 - t) * row.row(k) + t * row.row(k + 1);
  return row.row(0);
}

}  // namespace

Eigen::Vector3d BezierPatch::evaluate(double u, double v) const {
  Poles column(degreeU + 1, 3);
  for (int i = 0; i <= degreeU; ++i)
    column.row(i) = deCasteljau(poles.middleRows(i * (degreeV + 1), degreeV + 1), v).transpose();
  return deCasteljau(std::move(column), u);
}

BsplineSurface toBspline(const BezierPatch& patch) {
  return {KnotVector::bezier(patch.degreeU), KnotVector::bezier(patch.degreeV), patch.poles};
}

std::vector<BezierSpan> bezierSpans(const BsplineSurface& surface) {
  const int p = surface.u.degree(), q = surface.v.degree();
  const std::vector<double> breaksU = surface.u.breaks(), breaksV = surface.v.breaks();
  const BsplineSurface full = refinedTo(
      surface, KnotVector::fromBreaks(p, breaksU, p), KnotVector::fromBreaks(q, breaksV, q));
  std::vector<BezierSpan> spans;
  for (std::size_t a = 0; a + 1 < breaksU.size(); ++a)
    for (std::size_t b = 0; b + 1 < breaksV.size(); ++b) {
      BezierSpan span{{p, q, Poles((p + 1) * (q + 1), 3)},
                      breaksU[a],
                      breaksU[a + 1],
                      breaksV[b],
                      breaksV[b + 1]};
      for (int i = 0; i <= p; ++i)
        for (int j = 0; j <= q; ++j)
          span.patch.poles.row(i * (q + 1) + j) =
              full.pole(static_cast<int>(a) * p + i, static_cast<int>(b) * q + j).transpose();
      spans.push_back(std::move(span));
    }
  return spans;
}

}  // namespace fairing::spline
