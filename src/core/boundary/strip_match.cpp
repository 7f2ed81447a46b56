// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/strip_match.h"

#include <algorithm>
#include <cmath>

#include "core/boundary/chain_walk.h"

namespace fairing::boundary {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 64;
// Distances that vary by less than this share of their mean are the same all round.
constexpr double kSameDistance = 1e-6;
// Places closer than this share of a chain's length are one.
constexpr double kSamePlace = 1e-8;
// Corners of either chain that lie closer than this share of the length, when matched by length,
// belong together: a patch between them would be a sliver.
constexpr double kNearCorner = 0.02;

std::vector<Vector3d> pointsOf(const ChainWalk& walk) {
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

ChainWalk walkOf(const SideChain& chain) {
  return {chain.sides, 0, chain.sides.size(), chain.closed ? ChainEnds::Closed : ChainEnds::Open};
}

double wrapped(double share) {
  const double rest = share - std::floor(share);
  return rest > 1.0 - kSamePlace ? 0.0 : rest;
}

// Points that belong together: x is the share of the first chain's length, y that of the second
// one's from its end, so that both rise. Of closed chains both may go beyond 1.
struct Match {
  double x = 0.0, y = 0.0;
  const JointPair* pair = nullptr;
};

class Matcher {
 public:
  explicit Matcher(const ChainPair& pair)
      : pair_(pair),
        a_(pair.sides.sides, 0, pair.firstCount, ends()),
        b_(pair.sides.sides, pair.secondStart(), pair.secondEnd() - pair.secondStart(), ends()) {
    for (const double share : cornersOf(0, pair.firstCount, a_)) x_.push_back(share);
    for (const double share : cornersOf(pair.secondStart(), pair.secondEnd(), b_))
      y_.push_back(pair.closed ? wrapped(1.0 - share) : 1.0 - share);
    std::sort(x_.begin(), x_.end());
    std::sort(y_.begin(), y_.end());
  }

  [[nodiscard]] Result<std::vector<StripCut>> cuts() const {
    if (const auto wrong = checkAlignment()) return fail(*wrong);
    if (pair_.match.kind == MatchKind::Corners && x_.size() != y_.size())
      return fail(cornersDiffer());
    const auto anchors = pair_.match.pairs.empty() && pair_.closed ? closedAnchors() : paired();
    if (!anchors) return fail(anchors.error());
    if (anchors->empty()) return byLength();
    auto all = between(*anchors);
    if (!all) return fail(all.error());
    if (pair_.closed && all->size() == 1 && hasCorners()) all->push_back(opposite(all->front()));
    return placesOf(*all);
  }

 private:
  [[nodiscard]] ChainEnds ends() const {
    return pair_.closed ? ChainEnds::Closed : ChainEnds::Open;
  }
  [[nodiscard]] bool hasCorners() const { return !x_.empty() || !y_.empty(); }
  [[nodiscard]] std::vector<double> cornersOf(std::size_t first,
                                              std::size_t end,
                                              const ChainWalk& walk) const {
    std::vector<double> shares;
    for (std::size_t k = first; k < end; ++k)
      if ((pair_.closed || k + 1 < end) && isCut(pair_.sides.corners[k]))
        shares.push_back(wrapped(walk.startOf(k + 1)));
    return shares;
  }
  [[nodiscard]] Error cornersDiffer() const {
    return {.code = ErrorCode::CornersDiffer,
            .edge = static_cast<int>(x_.size()),
            .value = static_cast<double>(y_.size())};
  }
  [[nodiscard]] std::optional<Error> checkAlignment() const {
    const double alignment = pair_.match.alignment;
    if (!(std::abs(alignment) <= 0.5))
      return Error{.code = ErrorCode::AlignmentOutOfRange, .value = alignment};
    if (alignment == 0.0) return std::nullopt;
    if (!pair_.closed) return Error{.code = ErrorCode::AlignmentUnused, .detail = "open"};
    if (!pair_.match.pairs.empty())
      return Error{.code = ErrorCode::AlignmentUnused, .detail = "paired"};
    return std::nullopt;
  }

  // The pairs set, and the ends of open chains, in their order.
  [[nodiscard]] Result<std::vector<Match>> paired() const {
    std::vector<Match> anchors;
    for (const JointPair& joint : pair_.match.pairs) {
      const double x = a_.shareAt(joint.first), y = 1.0 - b_.shareAt(joint.second);
      anchors.push_back({pair_.closed ? wrapped(x) : x, pair_.closed ? wrapped(y) : y, &joint});
    }
    if (!pair_.closed) {
      anchors.push_back({0.0, 0.0});
      anchors.push_back({1.0, 1.0});
    }
    std::stable_sort(
        anchors.begin(), anchors.end(), [](const Match& p, const Match& q) { return p.x < q.x; });
    std::vector<Match> ordered;
    for (Match m : anchors) {
      if (pair_.closed && !ordered.empty() && m.y < ordered.front().y - kSamePlace) m.y += 1.0;
      if (!ordered.empty()) {
        const Match& last = ordered.back();
        const double dx = m.x - last.x, dy = m.y - last.y;
        if (std::abs(dx) <= kSamePlace && std::abs(dy) <= kSamePlace) continue;
        if (dx <= kSamePlace || dy <= kSamePlace) return fail(crossing(m.pair ? m : last));
      }
      ordered.push_back(m);
    }
    return ordered;
  }
  [[nodiscard]] Error crossing(const Match& m) const {
    return {
        .code = ErrorCode::PairsCross,
        .where = a_.at(m.x),
        .detail = std::to_string(m.pair->firstVertex) + "=" + std::to_string(m.pair->secondVertex)};
  }

  // Corner to corner where closed chains have as many and are to be matched so.
  [[nodiscard]] Result<std::vector<Match>> closedAnchors() const {
    std::vector<Match> anchors;
    const std::size_t n = x_.size();
    if (pair_.match.kind == MatchKind::Length || n != y_.size()) return anchors;
    const auto apartAt = [&](std::size_t offset) {
      double sum = 0.0;
      for (std::size_t k = 0; k < n; ++k)
        sum += (a_.at(x_[k]) - b_.at(1.0 - y_[(k + offset) % n])).squaredNorm();
      return sum;
    };
    std::size_t best = 0;
    for (std::size_t k = 1; k < n; ++k)
      if (apartAt(k) < apartAt(best) * (1.0 - kSameDistance)) best = k;
    if (n > 0) best = turned(best);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t j = k + best;
      anchors.push_back({x_[k], y_[j % n] + (j >= n ? 1.0 : 0.0)});
    }
    return anchors;
  }
  // The corner nearest to another one moved by the alignment.
  [[nodiscard]] std::size_t turned(std::size_t corner) const {
    const double aim = y_[corner] - pair_.match.alignment;
    const auto off = [&](std::size_t k) {
      const double d = wrapped(y_[k] - aim);
      return std::min(d, 1.0 - d);
    };
    std::size_t best = corner;
    for (std::size_t k = 0; k < y_.size(); ++k)
      if (off(k) < off(best) - kSamePlace) best = k;
    return best;
  }

  // The anchors, and the corners between them.
  [[nodiscard]] Result<std::vector<Match>> between(const std::vector<Match>& anchors) const {
    std::vector<Match> all;
    for (std::size_t k = 0; k < anchors.size(); ++k) {
      all.push_back(anchors[k]);
      const bool isLast = k + 1 == anchors.size();
      if (isLast && !pair_.closed) break;
      Match next = isLast ? anchors.front() : anchors[k + 1];
      if (isLast) next = {next.x + 1.0, next.y + 1.0};
      const std::vector<double> xs = inside(x_, anchors[k].x, next.x);
      const std::vector<double> ys = inside(y_, anchors[k].y, next.y);
      if (pair_.match.kind != MatchKind::Length && xs.size() == ys.size()) {
        for (std::size_t i = 0; i < xs.size(); ++i) all.push_back({xs[i], ys[i]});
        continue;
      }
      if (pair_.match.kind == MatchKind::Corners) return fail(cornersDiffer());
      for (const Match& m : mapped(anchors[k], next, xs, ys)) all.push_back(m);
    }
    return all;
  }
  // Shares strictly between two, which may go beyond 1.
  [[nodiscard]] std::vector<double> inside(const std::vector<double>& shares,
                                           double from,
                                           double to) const {
    std::vector<double> result;
    for (const double turn : {0.0, 1.0, 2.0})
      for (const double share : shares)
        if (share + turn > from + kSamePlace && share + turn < to - kSamePlace)
          result.push_back(share + turn);
    return result;
  }
  // Corners of either chain as cuts of both, by length.
  [[nodiscard]] static std::vector<Match> mapped(const Match& from,
                                                 const Match& to,
                                                 const std::vector<double>& xs,
                                                 const std::vector<double>& ys) {
    const double rate = (to.y - from.y) / (to.x - from.x);
    std::vector<Match> result;
    std::vector<char> taken(ys.size(), 0);
    for (const double x : xs) {
      Match m{x, from.y + (x - from.x) * rate};
      for (std::size_t j = 0; j < ys.size(); ++j) {
        if (taken[j] || std::abs(ys[j] - m.y) > kNearCorner) continue;
        m.y = ys[j];
        taken[j] = 1;
        break;
      }
      result.push_back(m);
    }
    for (std::size_t j = 0; j < ys.size(); ++j)
      if (!taken[j]) result.push_back({from.x + (ys[j] - from.y) / rate, ys[j]});
    std::sort(
        result.begin(), result.end(), [](const Match& p, const Match& q) { return p.x < q.x; });
    return result;
  }

  // Closed chains where nothing says which points belong together but their length.
  [[nodiscard]] std::vector<StripCut> byLength() const {
    const double twist = leastTwisted();
    const Match start{0.0, 1.0 - twist - pair_.match.alignment};
    const Match end{1.0, start.y + 1.0};
    std::vector<double> ys;
    for (const double y : y_) ys.push_back(start.y + wrapped(y - start.y));
    std::vector<Match> cuts = mapped(start, end, x_, ys);
    if (cuts.empty()) {
      const double x = nearest(twist);
      cuts.push_back({x, start.y + x});
    } else if (cuts.size() == 1) {
      cuts.push_back(opposite(cuts.front()));
    }
    return placesOf(cuts);
  }
  // Points at shares s and shift - s of the two chains' own lengths belong together.
  [[nodiscard]] double leastTwisted() const {
    const std::vector<Vector3d> points = pointsOf(a_);
    const double step = 1.0 / kSamples;
    const auto distanceAll = [&](double shift) {
      double sum = 0.0;
      for (int i = 0; i < kSamples; ++i)
        sum += (points[static_cast<std::size_t>(i)] - b_.at(shift - i * step)).squaredNorm();
      return sum;
    };
    return minimumNear(distanceAll, bestShift(points, pointsOf(b_), -1) * step, step);
  }
  // Where on the first chain the two are nearest to each other.
  [[nodiscard]] double nearest(double shift) const {
    const double step = 1.0 / kSamples;
    const auto distanceAt = [&](double share) {
      return (a_.at(share) - b_.at(shift - share)).norm();
    };
    double nearest = 0.0, least = distanceAt(0.0), most = least;
    for (int i = 1; i < kSamples; ++i) {
      const double distance = distanceAt(i * step);
      most = std::max(most, distance);
      if (distance < least) least = distance, nearest = i * step;
    }
    if (most - least <= kSameDistance * most) return 0.0;
    return minimumNear(distanceAt, nearest, step);
  }

  [[nodiscard]] static Match opposite(const Match& m) { return {m.x + 0.5, m.y + 0.5}; }
  [[nodiscard]] std::vector<StripCut> placesOf(const std::vector<Match>& matches) const {
    std::vector<StripCut> cuts;
    for (const Match& m : matches) cuts.push_back({a_.placeAt(m.x), b_.placeAt(1.0 - m.y)});
    return cuts;
  }

  const ChainPair& pair_;
  ChainWalk a_, b_;
  std::vector<double> x_, y_;  // corners, ascending
};

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

Result<std::vector<StripCut>> matchChains(const ChainPair& pair) {
  return Matcher(pair).cuts();
}

}  // namespace fairing::boundary
