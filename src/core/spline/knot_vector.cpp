// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/spline/knot_vector.h"

#include <algorithm>
#include <numeric>

#include "core/base/assert.h"

namespace fairing::spline {

KnotVector::KnotVector(int degree, std::vector<double> knots)
    : degree_(degree), knots_(std::move(knots)) {
  FAIRING_ASSERT(degree_ >= 1 && static_cast<int>(knots_.size()) >= 2 * (degree_ + 1));
  FAIRING_ASSERT(std::is_sorted(knots_.begin(), knots_.end()));
}

KnotVector KnotVector::bezier(int degree, double first, double last) {
  return fromBreaks(degree, {first, last});
}

KnotVector KnotVector::fromBreaks(int degree, const std::vector<double>& breaks, int multiplicity) {
  const auto ends = static_cast<std::size_t>(degree) + 1;
  std::vector<double> knots(ends, breaks.front());
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i)
    knots.insert(knots.end(), static_cast<std::size_t>(multiplicity), breaks[i]);
  knots.insert(knots.end(), ends, breaks.back());
  return {degree, std::move(knots)};
}

std::vector<double> KnotVector::breaks() const {
  std::vector<double> result = knots_;
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<int> KnotVector::multiplicities() const {
  std::vector<int> result;
  for (const double b : breaks())
    result.push_back(static_cast<int>(std::count(knots_.begin(), knots_.end(), b)));
  return result;
}

int KnotVector::span(double t) const {
  const auto begin = knots_.begin() + degree_;
  const auto end = knots_.end() - degree_ - 1;
  const auto above = std::upper_bound(begin, end, t);
  int s = static_cast<int>(above - knots_.begin()) - 1;
  while (s > degree_ &&
         knots_[static_cast<std::size_t>(s)] == knots_[static_cast<std::size_t>(s) + 1])
    --s;  // t = last(): step back to the last span that is not empty
  return std::max(s, degree_);
}

double KnotVector::greville(int i) const {
  const auto begin = knots_.begin() + i + 1;
  return std::accumulate(begin, begin + degree_, 0.0) / degree_;
}

std::vector<double> KnotVector::grevilleAbscissae() const {
  std::vector<double> result;
  for (int i = 0; i < poleCount(); ++i) result.push_back(greville(i));
  return result;
}

KnotVector KnotVector::reversed() const {
  std::vector<double> knots(knots_.rbegin(), knots_.rend());
  for (double& k : knots) k = first() + last() - k;
  knots.front() = first();  // the ends exactly, whatever the rounding
  for (int i = 0; i <= degree_; ++i) {
    knots[static_cast<std::size_t>(i)] = first();
    knots[knots.size() - 1 - static_cast<std::size_t>(i)] = last();
  }
  return {degree_, std::move(knots)};
}

KnotVector KnotVector::mapped(double newFirst, double newLast) const {
  std::vector<double> knots = knots_;
  const double scale = (newLast - newFirst) / (last() - first());
  for (double& k : knots) {
    if (k == first())
      k = newFirst;
    else if (k == last())
      k = newLast;
    else
      k = newFirst + (k - first()) * scale;
  }
  return {degree_, std::move(knots)};
}

KnotVector KnotVector::withKnot(double t) const {
  std::vector<double> knots = knots_;
  knots.insert(std::upper_bound(knots.begin(), knots.end(), t), t);
  return {degree_, std::move(knots)};
}

KnotVector KnotVector::raised(int times) const {
  std::vector<double> knots;
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    knots.push_back(knots_[i]);
    const bool lastOfItsBreak = i + 1 == knots_.size() || knots_[i + 1] != knots_[i];
    if (lastOfItsBreak) knots.insert(knots.end(), static_cast<std::size_t>(times), knots_[i]);
  }
  return {degree_ + times, std::move(knots)};
}

KnotVector merged(const KnotVector& a, const KnotVector& b, double resolution) {
  FAIRING_ASSERT(a.degree() == b.degree());
  const double close = resolution * (a.last() - a.first());
  std::vector<double> knots;
  // The copies of a repeated knot that only one of the two has take the value of the others.
  const auto add = [&](double knot) {
    const bool again = !knots.empty() && std::abs(knot - knots.back()) <= close;
    knots.push_back(again ? knots.back() : knot);
  };
  std::size_t i = 0, j = 0;
  const auto& ka = a.knots();
  const auto& kb = b.knots();
  while (i < ka.size() || j < kb.size()) {
    const bool bothLeft = i < ka.size() && j < kb.size();
    if (bothLeft && std::abs(ka[i] - kb[j]) <= close) {
      add(ka[i++]);
      ++j;
    } else if (j == kb.size() || (bothLeft && ka[i] < kb[j])) {
      add(ka[i++]);
    } else {
      add(kb[j++]);
    }
  }
  return {a.degree(), std::move(knots)};
}

}  // namespace fairing::spline
