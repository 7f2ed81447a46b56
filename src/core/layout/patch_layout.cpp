// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/patch_layout.h"

#include <algorithm>

namespace fairing::layout {

namespace {

// From 0 to 1, level where a seam ends inside, with its derivative.
struct Share {
  double value, derivative;
};
Share shareAt(const std::array<char, 2>& level, double t) {
  const double s = 1.0 - t;
  if (level[0] && level[1]) return {t * t * (3.0 - 2.0 * t), 6.0 * t * s};
  if (level[0]) return {t * t, 2.0 * t};
  if (level[1]) return {1.0 - s * s, 2.0 * s};
  return {t, 1.0};
}

}  // namespace

SeamFrame Seam::frame(double t) const {
  const SeamFrame &a = frames[0], &b = frames[1];
  const double s = 1.0 - t, share = shareAt(inside, t).value;
  return {a.first + share * (b.first - a.first),
          a.second + share * (b.second - a.second),
          s * s * a.along + t * t * b.along};
}

SeamFrame Seam::frameDerivative(double t) const {
  const SeamFrame &a = frames[0], &b = frames[1];
  const double rate = shareAt(inside, t).derivative;
  return {rate * (b.first - a.first),
          rate * (b.second - a.second),
          2.0 * (t * b.along - (1.0 - t) * a.along)};
}

std::vector<std::size_t> edgePlaces(const LayoutPatch& patch, PatchEdge edge, int row) {
  const int nu = patch.u.poleCount(), nv = patch.v.poleCount();
  const bool alongU = directionOf(edge) == 0;
  const bool farSide = edge == PatchEdge::East || edge == PatchEdge::North;
  const int across = farSide ? (alongU ? nv : nu) - 1 - row : row;
  std::vector<std::size_t> places;
  for (int k = 0; k < (alongU ? nu : nv); ++k) {
    const int i = alongU ? k : across, j = alongU ? across : k;
    places.push_back(static_cast<std::size_t>(i * nv + j));
  }
  if (falls(edge)) std::reverse(places.begin(), places.end());
  return places;
}

std::vector<int> edgePoints(const LayoutPatch& patch, PatchEdge edge, int row) {
  std::vector<int> points;
  for (const std::size_t place : edgePlaces(patch, edge, row))
    points.push_back(patch.points[place]);
  return points;
}

spline::KnotVector edgeKnots(const LayoutPatch& patch, PatchEdge edge) {
  switch (edge) {
    case PatchEdge::South:
      return patch.u;
    case PatchEdge::East:
      return patch.v;
    case PatchEdge::North:
      return patch.u.reversed();
    case PatchEdge::West:
      break;
  }
  return patch.v.reversed();
}

double crossStep(const LayoutPatch& patch, PatchEdge edge) {
  const spline::KnotVector& knots = directionOf(edge) == 0 ? patch.v : patch.u;
  const auto& t = knots.knots();
  const auto p = static_cast<std::size_t>(knots.degree());
  const bool farSide = edge == PatchEdge::East || edge == PatchEdge::North;
  const double span = farSide ? t.back() - t[t.size() - p - 2] : t[p + 1] - t.front();
  return span / (knots.last() - knots.first()) / knots.degree();
}

}  // namespace fairing::layout
