// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/loop_crossing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace fairing::occt {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCoincide = 1e-6;   // of the diagonal
constexpr double kNeighbour = 0.02;  // of the diagonal, along the loop
constexpr int kMostSegments = 2048;  // of all sides
constexpr int kNewtonSteps = 12;
// A piece of a curve stays within this share of its chord's length of the chord's middle, hairpins
// aside.
constexpr double kReach = 0.8;
// Pieces that follow each other meet at their common end alone, unless the second turns back: the
// cosine between their chords.
constexpr double kTurningBack = -0.5;

/// A chord of a side.
struct Segment {
  std::size_t side = 0;
  double from = 0.0, to = 0.0;  ///< side parameters
  Vector3d start = Vector3d::Zero(), end = Vector3d::Zero();
  double length = 0.0;
  double arc = 0.0;  ///< along the loop, up to the segment's start

  [[nodiscard]] Vector3d middle() const { return 0.5 * (start + end); }
  [[nodiscard]] double arcAt(double t) const { return arc + length * (t - from) / (to - from); }
};

class Crossings {
 public:
  explicit Crossings(const boundary::BoundaryLoop& loop) : loop_(loop) {
    const int sides = int(loop.sides.size());
    const int parts = std::clamp(kMostSegments / sides, 8, 32);
    for (std::size_t k = 0; k < loop.sides.size(); ++k) {
      Vector3d start = point(k, 0.0);
      for (int i = 0; i < parts; ++i) {
        const Vector3d end = point(k, (i + 1.0) / parts);
        const double length = (end - start).norm();
        segments_.push_back({k, double(i) / parts, (i + 1.0) / parts, start, end, length, around_});
        around_ += length;
        start = end;
      }
    }
  }

  [[nodiscard]] std::optional<Error> find() const {
    for (std::size_t a = 0; a < segments_.size(); ++a) {
      for (std::size_t b = a + 1; b < segments_.size(); ++b) {
        const Segment& one = segments_[a];
        const Segment& other = segments_[b];
        if (areApart(one, other) || (follows(a, b) && goesOn(one, other)) ||
            (follows(b, a) && goesOn(other, one)))
          continue;
        if (const auto where = coincide(one, other)) {
          return Error{.code = ErrorCode::LoopCrossesItself,
                       .edge = loop_.sides[one.side].edge,
                       .where = where};
        }
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Vector3d point(std::size_t side, double t) const {
    return loop_.sides[side].ribbon.curve(t).point;
  }

  [[nodiscard]] static bool areApart(const Segment& one, const Segment& other) {
    return (one.middle() - other.middle()).norm() > kReach * (one.length + other.length);
  }
  [[nodiscard]] bool follows(std::size_t a, std::size_t b) const {
    return (a + 1) % segments_.size() == b;
  }
  [[nodiscard]] static bool goesOn(const Segment& one, const Segment& next) {
    return (one.end - one.start).dot(next.end - next.start) >
           kTurningBack * one.length * next.length;
  }

  /// Gauss-Newton on the distance of two points, one on either side, from the middles of the
  /// segments; where they coincide.
  [[nodiscard]] std::optional<Vector3d> coincide(const Segment& one, const Segment& other) const {
    double s = 0.5 * (one.from + one.to);
    double t = 0.5 * (other.from + other.to);
    for (int step = 0; step < kNewtonSteps; ++step) {
      const auto a = loop_.sides[one.side].ribbon.curve(s);
      const auto b = loop_.sides[other.side].ribbon.curve(t);
      Eigen::Matrix<double, 3, 2> jacobian;
      jacobian << a.derivative, -b.derivative;
      const Vector3d apart = a.point - b.point;
      if (!apart.allFinite()) break;
      if (apart.norm() <= kCoincide * loop_.diagonal) {
        return areNeighbours(one, s, other, t) ? std::nullopt : std::optional(a.point);
      }
      const Vector2d move = jacobian.colPivHouseholderQr().solve(apart);
      s = std::clamp(s - move[0], one.from, one.to);
      t = std::clamp(t - move[1], other.from, other.to);
    }
    return std::nullopt;
  }

  [[nodiscard]] bool areNeighbours(const Segment& one,
                                   double s,
                                   const Segment& other,
                                   double t) const {
    const double along = std::abs(one.arcAt(s) - other.arcAt(t));
    return std::min(along, around_ - along) <= kNeighbour * loop_.diagonal;
  }

  const boundary::BoundaryLoop& loop_;
  std::vector<Segment> segments_;
  double around_ = 0.0;  // length of the loop
};

}  // namespace

std::optional<Error> findCrossing(const boundary::BoundaryLoop& loop) {
  return Crossings(loop).find();
}

}  // namespace fairing::occt
