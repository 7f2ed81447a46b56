// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fairing::spline {

/// A clamped knot vector: the first and the last knot are repeated degree + 1 times, inner knots at
/// most degree times.
class KnotVector {
 public:
  KnotVector() = default;
  /// `knots` is the full, non-decreasing list with repetitions.
  KnotVector(int degree, std::vector<double> knots);
  /// One Bezier span over [first, last].
  [[nodiscard]] static KnotVector bezier(int degree, double first = 0.0, double last = 1.0);
  /// Clamped over the breaks (strictly increasing), each inner one `multiplicity` times.
  [[nodiscard]] static KnotVector fromBreaks(int degree,
                                             const std::vector<double>& breaks,
                                             int multiplicity = 1);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] int poleCount() const { return static_cast<int>(knots_.size()) - degree_ - 1; }
  [[nodiscard]] double first() const { return knots_.front(); }
  [[nodiscard]] double last() const { return knots_.back(); }
  /// The parameter a share of the way from the first to the last.
  [[nodiscard]] double at(double share) const { return first() + (last() - first()) * share; }
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
  /// The distinct knots, ends included.
  [[nodiscard]] std::vector<double> breaks() const;
  [[nodiscard]] std::vector<int> multiplicities() const;
  /// Index s with knots[s] <= t < knots[s+1], the last non-empty span for t = last().
  [[nodiscard]] int span(double t) const;
  /// Greville abscissa of basis function i: mean of knots[i+1 .. i+degree].
  [[nodiscard]] double greville(int i) const;
  [[nodiscard]] std::vector<double> grevilleAbscissae() const;
  /// Knots mirrored about the middle of the domain.
  [[nodiscard]] KnotVector reversed() const;
  /// Knots mapped affinely onto [first, last].
  [[nodiscard]] KnotVector mapped(double first, double last) const;
  /// One more knot at t.
  [[nodiscard]] KnotVector withKnot(double t) const;
  /// Degree raised by `times`: every multiplicity grows by as much, so the continuity stays.
  [[nodiscard]] KnotVector raised(int times) const;

  friend bool operator==(const KnotVector&, const KnotVector&) = default;

 private:
  int degree_ = 0;
  std::vector<double> knots_;
};

/// The coarsest knots that contain both (same degree, same domain): each break with the larger
/// multiplicity. Breaks closer than `resolution` times the domain are one.
[[nodiscard]] KnotVector merged(const KnotVector& a, const KnotVector& b, double resolution = 1e-9);

}  // namespace fairing::spline
