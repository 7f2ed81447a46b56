// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/strip_match.h"

#include <cmath>

#include "core/boundary/arc_length.h"
#include "core/boundary/edge_chain.h"

namespace fairing::boundary {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 64;
// Distances that vary by less than this share of their mean are the same all round.
constexpr double kSameDistance = 1e-6;

// Sides one after the other, by the share of their length that is behind.
class Walk {
 public:
  Walk(const std::vector<BoundarySide>& sides, std::size_t first, std::size_t count)
      : first_(first) {
    for (std::size_t k = first; k < first + count; ++k) {
      curves_.push_back(sides[k].ribbon.curve);
      arcs_.emplace_back(sides[k].ribbon, 0.0, 1.0);
      length_ += arcs_.back().length();
    }
  }
  // Shares beyond [0, 1] go round.
  [[nodiscard]] LoopPlace placeAt(double share) const {
    double rest = (share - std::floor(share)) * length_;
    std::size_t k = 0;
    while (k + 1 < arcs_.size() && rest >= arcs_[k].length()) rest -= arcs_[k++].length();
    return {first_ + k, arcs_[k].parameterAt(std::min(rest, arcs_[k].length()))};
  }
  [[nodiscard]] Vector3d at(double share) const {
    const LoopPlace place = placeAt(share);
    return curves_[place.side - first_](place.t).point;
  }

 private:
  std::size_t first_;
  std::vector<std::function<CurveSample(double)>> curves_;
  std::vector<ArcLength> arcs_;
  double length_ = 0.0;
};

std::vector<Vector3d> pointsOf(const Walk& walk) {
  std::vector<Vector3d> points;
  for (int k = 0; k < kSamples; ++k) points.push_back(walk.at(static_cast<double>(k) / kSamples));
  return points;
}

// The minimum of a function within `width` of x, by golden sections.
template <class Function>
double minimumNear(const Function& f, double x, double width) {
  constexpr double kGolden = 0.6180339887498949;
  double low = x - width, high = x + width;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double fa = f(a), fb = f(b);
  while (high - low > 1e-9) {
    if (fa <= fb) {
      high = b;
      b = a, fb = fa;
      a = high - kGolden * (high - low), fa = f(a);
    } else {
      low = a;
      a = b, fa = fb;
      b = low + kGolden * (high - low), fb = f(b);
    }
  }
  return 0.5 * (low + high);
}

// Sum of the squared distances when sample i of `a` meets sample shift + way * i of `b`.
double apart(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b, int shift, int way) {
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i)
    sum += (a[static_cast<std::size_t>(i)] -
            b[static_cast<std::size_t>((shift + way * i + 2 * kSamples) % kSamples)])
               .squaredNorm();
  return sum;
}

int bestShift(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b, int way) {
  int best = 0;
  for (int shift = 1; shift < kSamples; ++shift)
    if (apart(a, b, shift, way) < apart(a, b, best, way)) best = shift;
  return best;
}

Walk walkOf(const SideChain& chain) {
  return {chain.sides, 0, chain.sides.size()};
}

// A chain from a place round to it again; from its start to its end where it is open.
std::vector<Stretch> stretchesFrom(std::size_t first, std::size_t count, LoopPlace start) {
  constexpr double kAtEnd = 1e-9;
  const bool atEnd = 1.0 - start.t <= kAtEnd;
  const std::size_t from = atEnd ? first + (start.side - first + 1) % count : start.side;
  const double t = atEnd || start.t <= kAtEnd ? 0.0 : start.t;
  std::vector<Stretch> result{{from, t, 1.0}};
  for (std::size_t k = 1; k < count; ++k)
    result.push_back({first + (from - first + k) % count, 0.0, 1.0});
  if (t > 0.0) result.push_back({from, 0.0, t});
  return result;
}

// Points of closed chains belong together by arc length.
EdgeChain chainFrom(
    const ChainPair& pair, std::size_t first, std::size_t count, LoopPlace start, int mostPoles) {
  const std::vector<Stretch> stretches = stretchesFrom(first, count, start);
  return pair.closed ? chainEdges(pair.sides, stretches)
                     : sideOfStretches(pair.sides, stretches, mostPoles);
}

}  // namespace

bool runsAlong(const SideChain& first, const SideChain& second) {
  const std::vector<Vector3d> a = pointsOf(walkOf(first)), b = pointsOf(walkOf(second));
  if (first.closed)
    return apart(a, b, bestShift(a, b, 1), 1) < apart(a, b, bestShift(a, b, -1), -1);
  const Vector3d a0 = a.front(), b0 = b.front();
  const Vector3d a1 = first.sides.back().ribbon.curve(1.0).point;
  const Vector3d b1 = second.sides.back().ribbon.curve(1.0).point;
  return (a0 - b0).norm() + (a1 - b1).norm() < (a0 - b1).norm() + (a1 - b0).norm();
}

StripStarts matchClosed(const ChainPair& pair) {
  const auto& sides = pair.sides.sides;
  const Walk a(sides, 0, pair.firstCount);
  const Walk b(sides, pair.firstCount, sides.size() - pair.firstCount);
  const std::vector<Vector3d> points = pointsOf(a);
  const double step = 1.0 / kSamples;
  const auto distanceAll = [&](double shift) {
    double sum = 0.0;
    for (int i = 0; i < kSamples; ++i)
      sum += (points[static_cast<std::size_t>(i)] - b.at(shift - i * step)).squaredNorm();
    return sum;
  };
  const double shift = minimumNear(distanceAll, bestShift(points, pointsOf(b), -1) * step, step);
  const auto distanceAt = [&](double share) { return (a.at(share) - b.at(shift - share)).norm(); };
  double nearest = 0.0, least = distanceAt(0.0), most = least;
  for (int i = 1; i < kSamples; ++i) {
    const double distance = distanceAt(i * step);
    most = std::max(most, distance);
    if (distance < least) least = distance, nearest = i * step;
  }
  if (most - least <= kSameDistance * most) return {a.placeAt(0.0), b.placeAt(shift)};
  const double start = minimumNear(distanceAt, nearest, step);
  return {a.placeAt(start), b.placeAt(shift - start)};
}

Result<CutLoop> cutPair(const ChainPair& pair, int mostPoles) {
  const std::size_t n = pair.firstCount, all = pair.sides.sides.size();
  const StripStarts starts = pair.closed ? matchClosed(pair) : StripStarts{{0, 0.0}, {n, 0.0}};
  EdgeChain first = chainFrom(pair, 0, n, starts.first, mostPoles);
  EdgeChain second = chainFrom(pair, n, all - n, starts.second, mostPoles);
  auto loop = measureSides({std::move(first.side), std::move(second.side)});
  if (!loop) return fail(loop.error());
  loop->diagonal = pair.sides.diagonal;
  loop->corners = {pair.sides.corners[n - 1], pair.sides.corners[all - 1]};
  return CutLoop{std::move(*loop), {std::move(first.stretches), std::move(second.stretches)}};
}

}  // namespace fairing::boundary
