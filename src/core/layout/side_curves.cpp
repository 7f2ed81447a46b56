// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/side_curves.h"

#include <algorithm>
#include <optional>

#include "core/spline/fit_curve.h"

namespace fairing::layout {
namespace {

using spline::BsplineCurve;
using spline::KnotVector;

constexpr int kPreferredDegree = 5;
// Raising the degree of a curve with many spans multiplies its poles by up to three, and those of
// the patch by nine: above this number of poles a side keeps its own degree.
constexpr int kMostPolesToRaise = 16;
constexpr int kLeastDegree = 3;
// Two knots that should be one (the same CAD knot seen from either side) differ by rounding, not by
// more.
constexpr double kSameKnot = 1e-7;

// The side's ribbon in the patch's direction.
boundary::Ribbon ribbonOf(const DirectedSide& s) {
  return s.reversed ? boundary::reversed(s.side->ribbon) : s.side->ribbon;
}

std::optional<BsplineCurve> exactCurve(const DirectedSide& s) {
  return ribbonOf(s).polynomial;
}

spline::CurveFunction curveFunction(const DirectedSide& s) {
  return ribbonOf(s).curve;
}

// The curve with its knots moved onto those of `knots` they stand for: refinedTo() needs them equal
// to the last bit.
BsplineCurve snapped(const BsplineCurve& curve, const KnotVector& knots) {
  std::vector<double> moved = curve.knots.knots();
  const auto& targets = knots.knots();
  for (double& t : moved) {
    const auto above = std::lower_bound(targets.begin(), targets.end(), t);
    if (above != targets.end() && *above - t <= kSameKnot)
      t = *above;
    else if (above != targets.begin() && t - *(above - 1) <= kSameKnot)
      t = *(above - 1);
  }
  return {KnotVector(curve.knots.degree(), std::move(moved)), curve.poles};
}

int chooseDegree(const std::vector<BsplineCurve>& exact, int wish) {
  int own = kLeastDegree;
  for (const BsplineCurve& c : exact) own = std::max(own, c.knots.degree());
  if (wish > 0) return std::max(own, wish);
  if (own >= kPreferredDegree) return own;
  for (const BsplineCurve& c : exact)
    if (c.knots.raised(kPreferredDegree - c.knots.degree()).poleCount() > kMostPolesToRaise)
      return own;
  return kPreferredDegree;
}

// The knots a fit needs from the start: a spline of degree p is C^k at a knot of multiplicity p -
// k. At least C1, since a patch must not be creased along an isoline.
KnotVector breakKnots(const DirectedSide& s, int degree) {
  KnotVector knots = KnotVector::bezier(degree);
  for (const boundary::CurveBreak& b : ribbonOf(s).breaks)
    for (int k = std::max(1, b.continuity); k < degree; ++k) knots = knots.withKnot(b.t);
  return knots;
}

// Whether a curve can be taken over at degree p without multiplying the patch's poles.
bool isCheap(const BsplineCurve& curve, int p) {
  return curve.knots.degree() <= p &&
         curve.knots.raised(p - curve.knots.degree()).poleCount() <= kMostPolesToRaise;
}

// Whether every knot of `coarse` is one of `fine`, as often.
bool holds(const KnotVector& fine, const KnotVector& coarse) {
  return std::includes(
      fine.knots().begin(), fine.knots().end(), coarse.knots().begin(), coarse.knots().end());
}

}  // namespace

KnotVector chooseKnots(const std::vector<DirectedSide>& sides,
                       int degree,
                       double fitTolerance,
                       int maxPoles) {
  std::vector<BsplineCurve> exact;
  std::vector<DirectedSide> others;
  for (const DirectedSide& s : sides) {
    if (auto curve = exactCurve(s))
      exact.push_back(std::move(*curve));
    else
      others.push_back(s);
  }
  const int p = chooseDegree(exact, degree);
  KnotVector knots = KnotVector::bezier(p);
  for (const BsplineCurve& c : exact)
    knots = merged(knots, c.knots.raised(p - c.knots.degree()), kSameKnot);
  std::vector<spline::CurveFunction> given;
  for (const DirectedSide& s : others) {
    knots = merged(knots, breakKnots(s, p), kSameKnot);
    given.push_back(curveFunction(s));
  }
  return spline::knotsThatFit(given, knots, fitTolerance, maxPoles);
}

KnotVector fittingKnots(const std::vector<DirectedSide>& sides,
                        int degree,
                        double fitTolerance,
                        int maxPoles) {
  int p = std::max(kPreferredDegree, degree);
  for (const DirectedSide& s : sides)
    if (const auto exact = exactCurve(s); exact && isCheap(*exact, exact->knots.degree()))
      p = std::max(p, exact->knots.degree());
  KnotVector knots = KnotVector::bezier(p);
  std::vector<spline::CurveFunction> given;
  for (const DirectedSide& s : sides) {
    const auto exact = exactCurve(s);
    if (exact && isCheap(*exact, p)) {
      knots = merged(knots, exact->knots.raised(p - exact->knots.degree()), kSameKnot);
      continue;
    }
    if (!exact) knots = merged(knots, breakKnots(s, p), kSameKnot);
    given.push_back(curveFunction(s));
  }
  return spline::knotsThatFit(given, knots, fitTolerance, maxPoles);
}

KnotVector refinedToFit(const std::vector<DirectedSide>& sides,
                        const KnotVector& knots,
                        double tolerance,
                        int maxPoles) {
  std::vector<spline::CurveFunction> given;
  for (const DirectedSide& s : sides) given.push_back(curveFunction(s));
  return spline::knotsThatFit(given, knots, tolerance, maxPoles);
}

SideCurve curveOnKnots(const DirectedSide& side, const KnotVector& knots) {
  const auto exact = exactCurve(side);
  if (exact && knots.degree() >= exact->knots.degree()) {
    const BsplineCurve raised =
        snapped(raiseDegree(*exact, knots.degree() - exact->knots.degree()), knots);
    if (holds(knots, raised.knots)) return {refinedTo(raised, knots), 0.0};
  }
  const spline::CurveFit fit = spline::fitCurve(curveFunction(side), knots);
  return {fit.curve, fit.error()};
}

}  // namespace fairing::layout
