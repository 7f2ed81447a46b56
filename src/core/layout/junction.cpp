// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/junction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/boundary/ring_of_loops.h"
#include "core/layout/loop_corners.h"
#include "core/layout/loop_picture.h"

namespace fairing::layout {
namespace {

using boundary::BoundaryLoop;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Sides with more control points are not taken over: they would multiply those of several patches.
constexpr int kMostPoles = 12;
constexpr int kSamples = 64;
constexpr int kHalvings = 48;

std::vector<Vector3d> centresOf(const BoundaryLoop& loop) {
  std::vector<Vector3d> centres;
  for (const auto& [first, end] : loop.chains())
    centres.push_back(boundary::shapeOf({loop.sides.begin() + static_cast<std::ptrdiff_t>(first),
                                         loop.sides.begin() + static_cast<std::ptrdiff_t>(end)})
                          .centre);
  return centres;
}

// The length at which a chain reaches farthest along a direction.
double farthest(const BoundaryLoop& loop, const LoopLength& lengths, const Vector3d& direction) {
  const auto at = [&](double length) {
    const boundary::LoopPlace place = lengths.placeAt(length);
    return loop.sides[place.side].ribbon.curve(place.t);
  };
  const double step = lengths.whole() / kSamples;
  int best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < kSamples; ++k) {
    const double reached = direction.dot(at(k * step).point);
    if (reached > most) {
      most = reached;
      best = k;
    }
  }
  double low = (best - 1) * step, high = (best + 1) * step;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (direction.dot(at(middle).derivative) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Of every chain: s, f, e, g (the middle of the back half).
std::vector<boundary::LoopPlace> cutsOf(const BoundaryLoop& loop) {
  const std::vector<Vector3d> centres = centresOf(loop);
  const auto chains = loop.chains();
  const std::size_t n = chains.size();
  std::vector<boundary::LoopPlace> cuts;
  for (std::size_t i = 0; i < n; ++i) {
    const LoopLength lengths(loop, chains[i].first, chains[i].second);
    const Vector3d next = (centres[(i + 1) % n] - centres[i]).normalized();
    const Vector3d previous = (centres[(i + n - 1) % n] - centres[i]).normalized();
    const double whole = lengths.whole();
    const double start = farthest(loop, lengths, previous - next);
    double end = farthest(loop, lengths, next - previous);
    end -= whole * std::floor((end - start) / whole);
    for (const double length : {start, 0.5 * (start + end), end, 0.5 * (end + start + whole)})
      cuts.push_back(lengths.placeAt(length));
  }
  return cuts;
}

// Places of the vertices in space, of those inside as good as guessed: where a cut's cubic has its
// middle, and means of what lies round a centre.
struct Vertices {
  explicit Vertices(const BoundaryLoop& loop) : n(static_cast<int>(loop.chains().size())) {
    for (const boundary::BoundarySide& side : loop.sides)
      points.push_back(side.ribbon.curve(0.0).point);
    for (int i = 0; i < n; ++i) points.push_back(middleOfCut(loop, i));
    for (const bool isFront : {true, false}) {
      Vector3d sum = Vector3d::Zero();
      for (int i = 0; i < n; ++i) sum += at(half(i, isFront)) + at(middle(i));
      points.push_back(sum / (2.0 * n));
    }
  }
  [[nodiscard]] int start(int i) const { return 4 * (i % n); }
  [[nodiscard]] int end(int i) const { return 4 * i + 2; }
  [[nodiscard]] int half(int i, bool front) const { return 4 * (i % n) + (front ? 1 : 3); }
  [[nodiscard]] int middle(int i) const { return 4 * n + (i + n) % n; }
  [[nodiscard]] int centre(bool front) const { return 5 * n + (front ? 0 : 1); }
  [[nodiscard]] const Vector3d& at(int vertex) const {
    return points[static_cast<std::size_t>(vertex)];
  }
  [[nodiscard]] double distance(int a, int b) const { return (at(a) - at(b)).norm(); }

  int n;
  std::vector<Vector3d> points;

 private:
  // The way into the gap at the start of a side.
  static Vector3d departure(const boundary::BoundarySide& side) {
    if (!side.ribbon.hasSupport()) return Vector3d::Zero();
    return side.ribbon.support(0.0).normal.cross(side.ribbon.curve(0.0).derivative).normalized();
  }
  [[nodiscard]] Vector3d middleOfCut(const BoundaryLoop& loop, int i) const {
    const int a = end(i), b = start(i + 1);
    const Vector3d leaving = departure(loop.sides[static_cast<std::size_t>(a)]) +
                             departure(loop.sides[static_cast<std::size_t>(b)]);
    return 0.5 * (at(a) + at(b)) + 0.125 * distance(a, b) * leaving;
  }
};

class Mesher {
 public:
  explicit Mesher(const BoundaryLoop& loop) : v_(loop) {}

  [[nodiscard]] QuadMesh make() {
    mesh_.inside.assign(v_.points.size(), 0);
    std::fill(mesh_.inside.begin() + 4 * v_.n, mesh_.inside.end(), 1);
    for (const bool front : {true, false})
      for (int i = 0; i < v_.n; ++i) addHalf(i, front);
    for (int i = 0; i < v_.n; ++i) showMiddle(i);
    showCentre(true);
    showCentre(false);
    return std::move(mesh_);
  }

 private:
  // The two patches beside one half of a chain, counter-clockwise.
  void addHalf(int i, bool front) {
    const int s = v_.start(i), e = v_.end(i), h = v_.half(i, front), c = v_.centre(front);
    const int before = v_.middle(i - 1), after = v_.middle(i);
    if (front) {
      mesh_.quads.push_back({{before, s, h, c}, {-1, s, -1, -1}});
      mesh_.quads.push_back({{h, e, after, c}, {h, -1, -1, -1}});
    } else {
      mesh_.quads.push_back({{after, e, h, c}, {-1, e, -1, -1}});
      mesh_.quads.push_back({{h, s, before, c}, {h, -1, -1, -1}});
    }
  }
  // A cut goes straight on at its middle, and so does what crosses it there.
  void showMiddle(int i) {
    const int m = v_.middle(i);
    show(m, v_.end(i), -Vector2d::UnitX());
    show(m, v_.start(i + 1), Vector2d::UnitX());
    show(m, v_.centre(true), Vector2d::UnitY());
    show(m, v_.centre(false), -Vector2d::UnitY());
  }
  void showCentre(bool front) {
    const int c = v_.centre(front);
    std::vector<int> around;
    for (int i = 0; i < v_.n; ++i) {
      const int k = front ? i : v_.n - 1 - i;
      around.push_back(front ? v_.half(k, true) : v_.middle(k));
      around.push_back(front ? v_.middle(k) : v_.half(k, false));
    }
    std::vector<Vector3d> points;
    for (const int vertex : around) points.push_back(v_.at(vertex));
    const auto picture = pictureOf(points, v_.at(c));
    for (std::size_t k = 0; k < around.size(); ++k) show(c, around[k], picture[k].normalized());
  }
  // From the far end nothing but the length is asked for where that lies on a chain.
  void show(int from, int to, const Vector2d& direction) {
    mesh_.ways[{from, to}] = v_.distance(from, to) * direction;
    mesh_.ways.try_emplace({to, from}, -v_.distance(from, to) * direction);
  }

  Vertices v_;
  QuadMesh mesh_;
};

}  // namespace

Result<LayoutPlan> junctionPlan(const BoundaryLoop& loop) {
  auto cut = boundary::cutLoop(loop, cutsOf(loop), kMostPoles);
  if (!cut) return fail(cut.error());
  QuadMesh mesh = Mesher(cut->loop).make();
  return LayoutPlan{LayoutKind::Junction, std::move(*cut), std::move(mesh)};
}

}  // namespace fairing::layout
