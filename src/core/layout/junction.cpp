// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/junction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/bisect.h"
#include "core/boundary/ring_of_loops.h"
#include "core/layout/loop_corners.h"
#include "core/layout/ring_star.h"

namespace fairing::layout {
namespace {

using boundary::BoundaryLoop;
using boundary::ChainRing;
using boundary::LoopPlace;
using boundary::RingCut;
using Eigen::Vector3d;

constexpr int kSamples = 64;
constexpr int kHalvings = 48;
// What every half of a chain has of its length at least.
constexpr double kLeastHalf = 0.05;

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
  return bisect((best - 1) * step, (best + 1) * step, kHalvings, [&](double length) {
    return direction.dot(at(length).derivative) > 0.0;
  });
}

// Where the cuts leave a chain: to the previous one and to the next one, by length.
struct ChainCuts {
  std::optional<double> start, end;
};

std::vector<LoopLength> lengthsOf(const BoundaryLoop& loop) {
  std::vector<LoopLength> lengths;
  for (const auto& [first, end] : loop.chains()) lengths.emplace_back(loop, first, end);
  return lengths;
}

// The cuts that are set, by chain.
Result<std::vector<ChainCuts>> cutsThatAreSet(const ChainRing& ring,
                                              const std::vector<LoopLength>& lengths) {
  const auto chains = ring.sides.chains();
  const std::size_t n = chains.size();
  const auto chainOf = [&](const LoopPlace& place) {
    std::size_t chain = 0;
    while (place.side >= chains[chain].second) ++chain;
    return chain;
  };
  std::vector<ChainCuts> set(n);
  for (const RingCut& cut : ring.cuts) {
    LoopPlace from = cut.first, to = cut.second;
    if (chainOf(from) == (chainOf(to) + 1) % n) std::swap(from, to);
    const std::size_t a = chainOf(from), b = chainOf(to);
    if (b != (a + 1) % n || set[a].end)
      return fail({.code = ErrorCode::CutUnfit, .edge = cut.edge});
    set[a].end = lengths[a].upTo(from);
    set[b].start = lengths[b].upTo(to);
  }
  return set;
}

// Of every chain: s, f, e, g (the middle of the back half).
Result<std::vector<LoopPlace>> cutsOf(const ChainRing& ring) {
  const std::vector<Vector3d> centres = centresOf(ring.sides);
  const std::vector<LoopLength> lengths = lengthsOf(ring.sides);
  const auto set = cutsThatAreSet(ring, lengths);
  if (!set) return fail(set.error());
  const std::size_t n = lengths.size();
  std::vector<LoopPlace> cuts;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d next = (centres[(i + 1) % n] - centres[i]).normalized();
    const Vector3d previous = (centres[(i + n - 1) % n] - centres[i]).normalized();
    const auto [setStart, setEnd] = (*set)[i];
    const double whole = lengths[i].whole();
    const double start = setStart.value_or(farthest(ring.sides, lengths[i], previous - next));
    double end = setEnd.value_or(farthest(ring.sides, lengths[i], next - previous));
    end -= whole * std::floor((end - start) / whole);
    if (std::min(end - start, whole - (end - start)) < kLeastHalf * whole)
      return fail({.code = ErrorCode::CutsTooClose,
                   .edge = ring.sides.sides[lengths[i].placeAt(start).side].edge,
                   .where = pointAt(ring.sides, lengths[i].placeAt(start))});
    for (const double length : {start, 0.5 * (start + end), end, 0.5 * (end + start + whole)})
      cuts.push_back(lengths[i].placeAt(length));
  }
  return cuts;
}

// Vertices: s, f, e, g of every chain, the middles of the cuts, the two centres.
class Mesher {
 public:
  explicit Mesher(const BoundaryLoop& loop) : n_(static_cast<int>(loop.chains().size())) {
    for (const boundary::BoundarySide& side : loop.sides)
      points_.push_back(side.ribbon.curve(0.0).point);
    for (int i = 0; i < n_; ++i)
      points_.push_back(middleOfWay(loop.sides[static_cast<std::size_t>(end(i))],
                                    0.0,
                                    loop.sides[static_cast<std::size_t>(start(i + 1))]));
    for (const bool isFront : {true, false}) {
      Vector3d sum = Vector3d::Zero();
      for (int i = 0; i < n_; ++i) sum += at(half(i, isFront)) + at(middle(i));
      points_.push_back(sum / (2.0 * n_));
    }
  }

  [[nodiscard]] QuadMesh make() const {
    RingMesh mesh(points_, 4 * n_);
    mesh.addStar(front(), 5 * n_);
    mesh.addStar(back(), 5 * n_ + 1);
    for (int i = 0; i < n_; ++i)
      mesh.showCrossing(middle(i), end(i), start(i + 1), {5 * n_}, {5 * n_ + 1});
    return mesh.take();
  }

 private:
  [[nodiscard]] int start(int i) const { return 4 * (i % n_); }
  [[nodiscard]] int end(int i) const { return 4 * i + 2; }
  [[nodiscard]] int half(int i, bool isFront) const { return 4 * i + (isFront ? 1 : 3); }
  [[nodiscard]] int middle(int i) const { return 4 * n_ + (i + n_) % n_; }
  [[nodiscard]] const Vector3d& at(int vertex) const {
    return points_[static_cast<std::size_t>(vertex)];
  }
  // Side k of the cut loop starts at vertex k.
  [[nodiscard]] StarBorder front() const {
    StarBorder border;
    for (int i = 0; i < n_; ++i) {
      border.add(middle(i - 1));
      border.add(start(i), start(i));
      border.add(half(i, true), half(i, true));
      border.add(end(i));
    }
    return border;
  }
  [[nodiscard]] StarBorder back() const {
    StarBorder border;
    for (int i = n_; i-- > 0;) {
      border.add(middle(i));
      border.add(end(i), end(i));
      border.add(half(i, false), half(i, false));
      border.add(start(i));
    }
    return border;
  }

  int n_;
  std::vector<Vector3d> points_;
};

}  // namespace

Result<LayoutPlan> junctionPlan(const ChainRing& ring) {
  const auto cuts = cutsOf(ring);
  if (!cuts) return fail(cuts.error());
  auto cut = boundary::cutLoop(ring.sides, *cuts, kMostPolesOfSeveral);
  if (!cut) return fail(cut.error());
  QuadMesh mesh = Mesher(cut->loop).make();
  return LayoutPlan{LayoutKind::Junction, std::move(*cut), std::move(mesh)};
}

}  // namespace fairing::layout
