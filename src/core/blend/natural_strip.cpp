// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blend/natural_strip.h"

#include <cmath>
#include <utility>

#include "core/blend/departure_check.h"
#include "core/blend/inner_rows.h"
#include "core/layout/layouts.h"
#include "core/layout/strip.h"

namespace fairing {

namespace {

// Spans on which sides and ends stay within tolerance, curvature included, when the reach fades.
constexpr double kSpansToFade = 16.0;

// Knots that divide the spans evenly until there are as many.
std::vector<double> knotsToFade(const spline::KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  const double parts = std::ceil(kSpansToFade / static_cast<double>(breaks.size() - 1));
  std::vector<double> more;
  for (std::size_t k = 1; k < breaks.size(); ++k)
    for (double part = 1.0; part < parts; ++part)
      more.push_back(breaks[k - 1] + part / parts * (breaks[k] - breaks[k - 1]));
  return more;
}

// Reach fades towards an end that follows something, and that gives way along itself: both need
// the knots for it.
Patches fineEnough(const layout::LayoutPlan& plan, const Patches& patches) {
  if (!layout::followsAtEnds(plan.mesh)) return patches;
  std::vector<layout::KnotWish> wishes;
  for (const spline::BsplineSurface& patch : patches)
    wishes.push_back({knotsToFade(patch.u), knotsToFade(patch.v)});
  const auto finer = layout::refineLayout(plan, layoutOf(plan, patches), wishes);
  return makePatches(finer, pointsOn(finer, patches));
}

}  // namespace

Result<NaturalStrip> NaturalStrip::make(const boundary::ChainPair& pair,
                                        const BlendOptions& options,
                                        Progress* progress) {
  if (const auto wrong = checkDepartures(pair, options)) return fail(*wrong);
  boundary::ChainPair asked = pair;
  for (std::size_t k = 0; k < asked.sides.sides.size(); ++k) {
    if (pair.isEnd(k)) continue;
    const std::size_t chain = pair.chainOf(k);
    asked.sides.sides[k].departure = options.departure[chain];
    asked.sides.sides[k].leaving = options.leaving[chain];
  }
  auto made = makeSpan(asked.sides, options.fill, [&](const boundary::BoundaryLoop& target) {
    boundary::ChainPair pairOfTarget = asked;
    pairOfTarget.sides = target;
    return layout::stripPlan(pairOfTarget);
  });
  if (!made) return fail(made.error());
  const auto span = std::make_shared<const Span>(std::move(*made));
  auto result = spanPlan(*span, options.fill, progress);
  if (!result) return fail(result.error());
  result->matches = span->plan.matches;
  NaturalStrip strip(span, options.fill, std::move(*result));
  if (const auto error = strip.turn()) return fail(*error);
  return strip;
}

std::optional<Error> NaturalStrip::turn() {
  const auto layout = layoutOf(span_->plan, result_.patches);
  const StripRows rows{span_->plan.cut.loop, layout, result_.patches};
  const std::array<bool, 2> amiss = leavesAmiss(rows);
  if (!amiss[0] && !amiss[1]) return std::nullopt;
  const auto held = turnedRows(rows, amiss);
  if (!held) return held.error();
  auto turned = spanAgain(*span_, result_.unguided, *held, options_);
  if (!turned) return turned.error();
  turned->matches = result_.matches;
  turned->span = span_;
  result_ = std::move(*turned);
  return std::nullopt;
}

Result<FillResult> NaturalStrip::reaching(const Reach& reach) const {
  if (reach.isNatural()) return result_;
  const Patches patches = fineEnough(span_->plan, result_.patches);
  const auto layout = layoutOf(span_->plan, patches);
  const auto held = scaledRows({span_->plan.cut.loop, layout, patches}, reach);
  auto result = spanAgain(*span_, fineEnough(span_->plan, result_.unguided), held, options_);
  if (result) result->matches = result_.matches;
  return result;
}

}  // namespace fairing
