// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/height_knots.h"

#include <algorithm>
#include <cmath>

namespace fairing::height_field {
namespace {

using spline::KnotVector;

constexpr double kMargin = 0.04;  // of the box, on either side
constexpr int kFirstCells = 12;   // along the side of a square box
// Spans below this share of the domain resolve nothing any more.
constexpr double kShortestSpan = 1.0 / 4096.0;

KnotVector evenly(int degree, double first, double last, int spans) {
  std::vector<double> breaks;
  for (int k = 0; k <= spans; ++k) breaks.push_back(first + (last - first) * k / spans);
  return KnotVector::fromBreaks(degree, breaks);
}

// A span, and how far rows next to it are off.
struct Wish {
  bool alongU;
  double middle;
  double residual;
};

// Largest residual of the rows in every span.
std::vector<Wish> wishes(const KnotVector& knots,
                         bool alongU,
                         const std::vector<std::pair<double, double>>& residuals) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<Wish> all;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    all.push_back({alongU, 0.5 * (breaks[k] + breaks[k + 1]), 0.0});
  for (const auto& [at, residual] : residuals) {
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
    Wish& wish = all[static_cast<std::size_t>(above - breaks.begin()) - 1];
    wish.residual = std::max(wish.residual, residual);
  }
  const double shortest = kShortestSpan * (breaks.back() - breaks.front());
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    if (breaks[k + 1] - breaks[k] < shortest) all[k].residual = 0.0;
  return all;
}

}  // namespace

HeightKnots coarseKnots(const ProjectedLoop& loop, int degree) {
  const Eigen::Vector2d size = loop.box.sizes(), margin = kMargin * size;
  const double cell = std::sqrt(size[0] * size[1]) / kFirstCells;
  const auto spans = [&](double length) {
    return std::clamp(static_cast<int>(std::lround(length / cell)), 3, 4 * kFirstCells);
  };
  const Eigen::Vector2d low = loop.box.min() - margin, high = loop.box.max() + margin;
  return {evenly(degree, low[0], high[0], spans(size[0])),
          evenly(degree, low[1], high[1], spans(size[1]))};
}

std::optional<HeightKnots> finerKnots(const HeightKnots& knots,
                                      const Heights& heights,
                                      const std::vector<HeightRow>& rows,
                                      double aim,
                                      int maxPoles) {
  std::vector<std::pair<double, double>> alongU, alongV;
  for (const HeightRow& row : rows) {
    const double residual = std::abs(row.residual(heights));
    alongU.emplace_back(row.u, residual);
    alongV.emplace_back(row.v, residual);
  }
  std::vector<Wish> all = wishes(knots.u, true, alongU), more = wishes(knots.v, false, alongV);
  all.insert(all.end(), more.begin(), more.end());
  std::stable_sort(
      all.begin(), all.end(), [](const Wish& a, const Wish& b) { return a.residual > b.residual; });
  HeightKnots finer = knots;
  for (const Wish& wish : all) {
    if (wish.residual <= aim) break;
    HeightKnots tried = finer;
    KnotVector& changed = wish.alongU ? tried.u : tried.v;
    changed = changed.withKnot(wish.middle);
    if (tried.poleCount() > maxPoles) break;
    finer = std::move(tried);
  }
  if (finer.poleCount() == knots.poleCount()) return std::nullopt;
  return finer;
}

}  // namespace fairing::height_field
