// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/layouts.h"

#include <algorithm>
#include <cmath>

#include "core/layout/build_layout.h"
#include "core/layout/loop_corners.h"
#include "core/layout/o_grid.h"
#include "core/layout/quad.h"
#include "core/layout/side_curves.h"
#include "core/layout/star.h"
#include "core/layout/strip.h"

namespace fairing::layout {
namespace {

using spline::KnotVector;

constexpr double kMostCoarseSpans = 6.0;
// Round a closed strip: a circle of twelve quintic spans is round to 1e-7. Across a strip: its
// sides take up to six rows of control points, the shape needs some, too.
constexpr double kLeastSpansRound = 12.0, kMostSpansRound = 16.0;
constexpr double kLeastSpansAcross = 4.0;
// A patch of a junction takes a quarter of a rim; with one span |grad H|^2 stays ten times as
// large.
constexpr double kLeastOfJunction = 2.0;
// Fewer control points along a strip than this are not asked for, however many the patches have.
constexpr int kLeastAlong = 8;
// Knots of one strip closer than this are one.
constexpr double kSameKnot = 1e-7;

// The sides that run along every strip, in its direction.
std::vector<std::vector<DirectedSide>> sidesAlongStrips(const LayoutPlan& plan,
                                                        const Strips& strips) {
  std::vector<std::vector<DirectedSide>> along(static_cast<std::size_t>(strips.count));
  for (std::size_t q = 0; q < plan.mesh.quads.size(); ++q)
    for (std::size_t k = 0; k < 4; ++k) {
      const int side = plan.mesh.quads[q].sides[k];
      if (side < 0) continue;
      const StripUse use = strips.uses[q][k % 2];
      along[static_cast<std::size_t>(use.strip)].push_back(
          {&plan.cut.loop.sides[static_cast<std::size_t>(side)],
           falls(kPatchEdges[k]) != use.reversed});
    }
  return along;
}

// Whether polynomial sides are taken over whatever their knots: those of a quad, and what the ends
// of a strip follow.
bool takesOver(const LayoutPlan& plan, const Strips& strips, std::size_t strip) {
  if (plan.kind == LayoutKind::Quad) return true;
  return plan.kind == LayoutKind::Strip &&
         strip == static_cast<std::size_t>(strips.uses[0][1].strip) && followsAtEnds(plan.mesh);
}

bool isRound(const LayoutPlan& plan, std::size_t direction) {
  return plan.closed && direction == 0;
}

// Spans that patches have at least, along u (0) or v (1).
double leastSpans(const LayoutPlan& plan, std::size_t direction) {
  if (isRound(plan, direction)) return kLeastSpansRound;
  if (plan.kind == LayoutKind::Strip && direction == 1) return kLeastSpansAcross;
  return plan.kind == LayoutKind::Junction ? kLeastOfJunction : 1.0;
}

bool byPoles(const KnotVector& a, const KnotVector& b) {
  return a.poleCount() < b.poleCount();
}

}  // namespace

std::optional<Error> tooManySides(const boundary::BoundaryLoop& loop) {
  constexpr std::size_t kMostSides = 64;
  if (loop.sides.size() <= kMostSides) return std::nullopt;
  return Error{.code = ErrorCode::TooManySides, .value = static_cast<double>(loop.sides.size())};
}

bool isTiny(const boundary::BoundarySide& side, double diagonal) {
  constexpr double kTinyShare = 5e-3;
  return side.length < kTinyShare * diagonal;
}

std::vector<LayoutKind> suitableKinds(const boundary::BoundaryLoop& loop) {
  const auto roles = cornerRoles(loop);
  const auto corners = std::count(roles.begin(), roles.end(), CornerRole::Corner);
  const auto splits = std::count(roles.begin(), roles.end(), CornerRole::Split);
  const bool hasTiny = std::any_of(loop.sides.begin(), loop.sides.end(), [&](const auto& side) {
    return isTiny(side, loop.diagonal);
  });
  if (corners == 4 && splits == 0 && !hasTiny) return {LayoutKind::Quad};
  if (hasTiny) return {LayoutKind::Trimmed, corners >= 3 ? LayoutKind::Star : LayoutKind::OGrid};
  if (corners >= 3) return {LayoutKind::Star, LayoutKind::Trimmed};
  if (corners + splits == 0 && bendsSharply(loop)) return {LayoutKind::Trimmed, LayoutKind::OGrid};
  return {LayoutKind::OGrid, LayoutKind::Trimmed};
}

Result<LayoutPlan> planLayout(const boundary::BoundaryLoop& loop, LayoutKind kind) {
  if (const auto tooMany = tooManySides(loop)) return fail(*tooMany);
  const auto roles = cornerRoles(loop);
  switch (kind) {
    case LayoutKind::Auto: {
      const auto kinds = suitableKinds(loop);
      return planLayout(loop, kinds.front() == LayoutKind::Trimmed ? kinds.back() : kinds.front());
    }
    case LayoutKind::Quad:
      return quadPlan(loop, roles);
    case LayoutKind::Star:
      return starPlan(loop, roles);
    case LayoutKind::OGrid:
      return oGridPlan(loop, roles);
    case LayoutKind::Trimmed:
      return fail({.code = ErrorCode::LayoutUnfit, .detail = "trimmed"});
    case LayoutKind::Strip:
      return fail({.code = ErrorCode::LayoutUnfit, .detail = "strip"});
    case LayoutKind::Junction:
      break;
  }
  return fail({.code = ErrorCode::LayoutUnfit, .detail = "junction"});
}

PatchLayout makeLayout(const LayoutPlan& plan, const LayoutOptions& options) {
  const Strips strips = stripsOf(plan.mesh);
  const auto sides = sidesAlongStrips(plan, strips);
  int most = std::max(kLeastAlong, options.maxPoles / kLeastAlong);
  while (true) {
    std::vector<KnotVector> knots;
    for (std::size_t s = 0; s < sides.size(); ++s)
      knots.push_back((takesOver(plan, strips, s) ? chooseKnots : fittingKnots)(
          sides[s], options.degree, options.fitTolerance, most));
    const int longest = std::max_element(knots.begin(), knots.end(), byPoles)->poleCount();
    PatchLayout layout = buildLayout(plan, std::move(knots));
    if (layout.pointCount <= options.maxPoles || most == kLeastAlong) return layout;
    most = std::max(kLeastAlong, static_cast<int>(0.8 * std::min(longest, most)));
  }
}

PatchLayout coarseLayout(const LayoutPlan& plan,
                         const PatchLayout& layout,
                         const CoarseOptions& options) {
  std::vector<KnotVector> knots(layout.stripKnots.size());
  for (std::size_t q = 0; q < layout.patches.size(); ++q)
    for (std::size_t d = 0; d < 2; ++d) {
      const KnotVector& own = d == 0 ? layout.patches[q].u : layout.patches[q].v;
      const double wish = std::ceil(options.density * (own.last() - own.first()) - 0.25);
      const double most = isRound(plan, d) ? kMostSpansRound : kMostCoarseSpans;
      const int spans = static_cast<int>(std::clamp(wish, leastSpans(plan, d), most));
      std::vector<double> breaks;
      for (int k = 0; k <= spans; ++k) breaks.push_back(static_cast<double>(k) / spans);
      knots[static_cast<std::size_t>(layout.strips.uses[q][d].strip)] =
          KnotVector::fromBreaks(own.degree(), breaks);
    }
  const auto sides = sidesAlongStrips(plan, layout.strips);
  for (std::size_t s = 0; s < knots.size(); ++s)
    knots[s] = refinedToFit(sides[s], knots[s], options.fitTolerance, options.mostPolesAlong);
  return buildLayout(plan, std::move(knots));
}

PatchLayout withKnotsOf(const LayoutPlan& plan,
                        const PatchLayout& layout,
                        const PatchLayout& other) {
  std::vector<KnotVector> knots = layout.stripKnots;
  for (std::size_t s = 0; s < knots.size(); ++s) {
    const KnotVector& own = other.stripKnots[s];
    const int p = std::max(knots[s].degree(), own.degree());
    knots[s] =
        merged(own.raised(p - own.degree()), knots[s].raised(p - knots[s].degree()), kSameKnot);
  }
  return buildLayout(plan, std::move(knots));
}

PatchLayout refineLayout(const LayoutPlan& plan,
                         const PatchLayout& layout,
                         const std::vector<KnotWish>& wishes) {
  std::vector<KnotVector> knots = layout.stripKnots;
  for (std::size_t q = 0; q < wishes.size(); ++q)
    for (std::size_t d = 0; d < 2; ++d) {
      const StripUse use = layout.strips.uses[q][d];
      const KnotVector& own = d == 0 ? layout.patches[q].u : layout.patches[q].v;
      KnotVector& strip = knots[static_cast<std::size_t>(use.strip)];
      for (const double wish : d == 0 ? wishes[q].u : wishes[q].v) {
        const double t = (wish - own.first()) / (own.last() - own.first());
        const double place = use.reversed ? 1.0 - t : t;
        const auto& all = strip.knots();
        const bool isKnot = std::any_of(
            all.begin(), all.end(), [&](double k) { return std::abs(k - place) < kSameKnot; });
        if (!isKnot) strip = strip.withKnot(place);
      }
    }
  return buildLayout(plan, std::move(knots));
}

}  // namespace fairing::layout
