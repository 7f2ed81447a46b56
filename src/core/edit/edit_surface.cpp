// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/edit/edit_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/analysis/measure_guidance.h"
#include "core/assembly/assemble_energy.h"
#include "core/assembly/assemble_guidance.h"
#include "core/base/angle.h"
#include "core/energy/energy.h"
#include "core/solver/solve.h"
#include "core/spline/quadrature.h"

// Minimises  1/2 X'(K + G)X - g.X  over the control points X that do not stay,
//   K  membrane or thin plate,   G, g  guidance: lambda [(R_u.N)^2 + (R_v.N)^2] + gamma (R - S)^2,
// [WuYang2015] eq. 1 and 2 with their eq. 3 and 4 for the gradient. They give the outer one or two
// rows in advance; here they are the old surface's.

namespace fairing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using energy::Guidance;
using spline::BsplineSurface;
using spline::KnotVector;

constexpr int kLeastDegree = 3, kLargestDegree = 9, kMostSpans = 64;
// A domain longer than this in proportion would be all one direction's energy.
constexpr double kLongest = 100.0;
constexpr int kBorderSamples = 201, kMoveSamples = 65;

KnotVector split(const KnotVector& knots, int spans) {
  const std::vector<double> breaks = knots.breaks();
  const int own = static_cast<int>(breaks.size()) - 1;
  const int parts = (std::max(spans, own) + own - 1) / own;
  KnotVector finer = knots;
  for (std::size_t k = 1; k < breaks.size(); ++k)
    for (int i = 1; i < parts; ++i)
      finer = finer.withKnot(breaks[k - 1] + (breaks[k] - breaks[k - 1]) * i / parts);
  return finer;
}

BsplineSurface enriched(const BsplineSurface& old, int degree, int spans) {
  const auto raised = spline::raiseDegree(
      old, std::max(0, degree - old.u.degree()), std::max(0, degree - old.v.degree()));
  return spline::refinedTo(raised, split(raised.u, spans), split(raised.v, spans));
}

BsplineSurface over(BsplineSurface surface, const Vector2d& from, const Vector2d& to) {
  surface.u = surface.u.mapped(from[0], to[0]);
  surface.v = surface.v.mapped(from[1], to[1]);
  return surface;
}

/// Over a domain of the surface's own proportions and an area of 1.
BsplineSurface overItsProportions(const BsplineSurface& surface) {
  double alongU = 0.0, alongV = 0.0;
  for (const auto& qu : spline::gaussLegendre(surface.u.degree(), surface.u))
    for (const auto& qv : spline::gaussLegendre(surface.v.degree(), surface.v)) {
      const spline::SurfaceJet jet = surface.jet(qu.parameter, qv.parameter);
      alongU += qu.weight * qv.weight * jet.u.norm();
      alongV += qu.weight * qv.weight * jet.v.norm();
    }
  alongU *= surface.u.last() - surface.u.first();
  alongV *= surface.v.last() - surface.v.first();
  const double ratio =
      alongU > 0.0 && alongV > 0.0 ? std::clamp(alongU / alongV, 1.0 / kLongest, kLongest) : 1.0;
  return over(surface, Vector2d::Zero(), {std::sqrt(ratio), 1.0 / std::sqrt(ratio)});
}

layout::PatchLayout layoutOf(const BsplineSurface& surface) {
  layout::PatchLayout layout;
  layout.pointCount = static_cast<int>(surface.poles.rows());
  layout::LayoutPatch patch{surface.u, surface.v, {}, {}};
  patch.points.resize(static_cast<std::size_t>(layout.pointCount));
  std::iota(patch.points.begin(), patch.points.end(), 0);
  layout.patches.push_back(std::move(patch));
  return layout;
}

/// What is not given is the old surface.
Guidance completed(const Guidance& given, const BsplineSurface& old) {
  const bool normals = given.hasField() || given.hasNormals() || given.reference;
  const bool points = given.reference || (given.continuous && given.continuous->reference) ||
                      (given.discrete && given.discrete->gamma.any());
  Guidance all = given;
  if (normals && points) return all;
  all.parametric = [unit = over(old, Vector2d::Zero(), Vector2d::Ones()), normals, points](
                       double u, double v) {
    const spline::SurfaceJet jet = unit.jet(u, v);
    const Vector3d normal = jet.normalVector();
    const bool regular = normal.norm() > 0.0;
    return energy::GuidanceSample{regular ? normal.normalized() : Vector3d::Zero(),
                                  jet.point,
                                  normals || !regular ? 0.0 : 1.0,
                                  points ? 0.0 : 1.0};
  };
  return all;
}

std::vector<char> heldPoints(const BsplineSurface& surface, int rows, const EditRegion& region) {
  const int nu = surface.u.poleCount(), nv = surface.v.poleCount();
  const auto knot = [](const KnotVector& knots, int k) {
    return knots.knots()[static_cast<std::size_t>(k)];
  };
  std::vector<char> held;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const bool outer = std::min({i, j, nu - 1 - i, nv - 1 - j}) < rows;
      held.push_back(outer || (region.contains &&
                               !region.contains(knot(surface.u, i),
                                                knot(surface.u, i + surface.u.degree() + 1),
                                                knot(surface.v, j),
                                                knot(surface.v, j + surface.v.degree() + 1))));
    }
  return held;
}

double extendedEnergy(const solver::QuadraticProgram& program,
                      const assembly::GuidanceSystem& guide,
                      const Guidance& guidance,
                      const spline::Poles& poles) {
  const Eigen::Map<const Eigen::VectorXd> x(poles.data(), poles.size());
  const double apart = solver::energy(guide.points, poles) - guide.load.dot(x) + guide.constant;
  return solver::energy(program.stiffness, poles) +
         0.5 * guidance.lambda * x.dot(guide.normals * x) + guidance.gamma * apart;
}

std::vector<Vector2d> wholeBorder(const BsplineSurface& surface) {
  std::vector<Vector2d> places;
  const double u0 = surface.u.first(), u1 = surface.u.last();
  const double v0 = surface.v.first(), v1 = surface.v.last();
  for (int k = 0; k < kBorderSamples; ++k) {
    const double t = k / (kBorderSamples - 1.0);
    const double u = u0 + t * (u1 - u0), v = v0 + t * (v1 - v0);
    for (const Vector2d& place :
         {Vector2d(u, v0), Vector2d(u, v1), Vector2d(u0, v), Vector2d(u1, v)})
      places.push_back(place);
  }
  return places;
}

void measureMoves(const BsplineSurface& old,
                  const BsplineSurface& now,
                  const std::vector<Vector2d>& border,
                  EditReport& report) {
  for (const Vector2d& at : border) {
    const auto before = old.jet(at[0], at[1]), after = now.jet(at[0], at[1]);
    report.borderMove = std::max(report.borderMove, (before.point - after.point).norm());
    const Vector3d a = before.normalVector(), b = after.normalVector();
    if (a.norm() > 0.0 && b.norm() > 0.0)
      report.borderTurn = std::max(report.borderTurn, angleBetween(a, b));
  }
  for (int i = 0; i < kMoveSamples; ++i)
    for (int j = 0; j < kMoveSamples; ++j) {
      const double u = old.u.at(i / (kMoveSamples - 1.0)), v = old.v.at(j / (kMoveSamples - 1.0));
      report.largestMove =
          std::max(report.largestMove, (old.evaluate(u, v) - now.evaluate(u, v)).norm());
    }
}

Continuity keptOf(const EditOptions& options) {
  const bool membrane = options.energy == EnergyKind::Membrane;
  return options.keep.value_or(membrane ? Continuity::G0 : Continuity::G1);
}

const char* nameOf(Continuity kept) {
  return kept == Continuity::G0 ? "G0" : kept == Continuity::G1 ? "G1" : "G2";
}

int rowsOf(Continuity kept) {
  return kept == Continuity::G0 ? 1 : kept == Continuity::G1 ? 2 : 3;
}

/// A place of the scaled domain in the old one.
analysis::OnFace onFace(const BsplineSurface& scaled,
                        const BsplineSurface& old,
                        const EditRegion& region) {
  if (!region.contains) return {};
  const auto back = [](double t, const KnotVector& from, const KnotVector& to) {
    return to.at((t - from.first()) / (from.last() - from.first()));
  };
  return [&, back](std::size_t, double u, double v) {
    const double s = back(u, scaled.u, old.u), t = back(v, scaled.v, old.v);
    return region.contains(s, s, t, t);
  };
}

}  // namespace

std::optional<Error> validate(const EditOptions& options) {
  if (options.energy != EnergyKind::Membrane && options.energy != EnergyKind::ThinPlate)
    return Error{.code = ErrorCode::UnknownChoice,
                 .detail = "an energy other than membrane and thin plate for an edit"};
  if (options.degree != 0 && (options.degree < kLeastDegree || options.degree > kLargestDegree))
    return Error{.code = ErrorCode::DegreeOutOfRange, .value = double(options.degree)};
  if (options.spans < 0 || options.spans > kMostSpans)
    return Error{.code = ErrorCode::SpansOutOfRange, .value = double(options.spans)};
  return energy::validate(options.guidance);
}

SurfaceEdit::SurfaceEdit(BsplineSurface old, EditOptions options, EditRegion region)
    : old_(std::move(old)),
      start_(enriched(old_, options.degree, options.spans)),
      scaled_(overItsProportions(start_)),
      options_(std::move(options)),
      region_(std::move(region)),
      layout_(layoutOf(scaled_)),
      latest_(scaled_) {
  program_.stiffness = assembly::assembleEnergy(layout_, energy::energyTerms(options_.energy));
  program_.fixed = heldPoints(start_, rowsOf(keptOf(options_)), region_);
  program_.values = scaled_.poles;
}

Result<SurfaceEdit> SurfaceEdit::make(const BsplineSurface& old,
                                      const EditOptions& options,
                                      const EditRegion& region) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  SurfaceEdit edit(old, options, region);
  if (edit.moved() == 0)
    return fail({.code = ErrorCode::NothingToMove, .detail = nameOf(keptOf(options))});
  edit.guided_.emplace(edit.program_);
  return edit;
}

int SurfaceEdit::moved() const {
  return static_cast<int>(std::count(program_.fixed.begin(), program_.fixed.end(), 0));
}

Result<void> SurfaceEdit::lookUp(const Guidance& guidance) {
  guide_ = assembly::assembleGuidance(layout_, energy::weighingOne(guidance), {latest_});
  guided_->setGuide(guide_.normals, guide_.points, guide_.load);
  const auto before =
      analysis::measureGuidance(guidance, {scaled_}, onFace(scaled_, old_, region_));
  if (!before) return fail(before.error());
  before_ = *before;
  return {};
}

Result<EditResult> SurfaceEdit::under(const Guidance& given, bool lookUpAgain) {
  if (const auto wrong = energy::validate(given)) return fail(*wrong);
  const Guidance guidance = completed(given, old_);
  if (lookUpAgain || !before_)
    if (const auto found = lookUp(guidance); !found) return fail(found.error());
  const auto solution = guided_->solve(guidance.lambda, guidance.gamma);
  if (!solution) return fail(solution.error());
  latest_.poles = solution->points;
  const auto after = analysis::measureGuidance(guidance, {latest_}, onFace(scaled_, old_, region_));
  if (!after) return fail(after.error());
  EditResult result{{start_.u, start_.v, solution->points}, {}};
  EditReport& report = result.report;
  report.before = *before_;
  report.after = *after;
  report.energyBefore = extendedEnergy(program_, guide_, guidance, scaled_.poles);
  report.energy = extendedEnergy(program_, guide_, guidance, solution->points);
  report.diagonal = (old_.poles.colwise().maxCoeff() - old_.poles.colwise().minCoeff()).norm();
  report.kept = keptOf(options_);
  report.poles = layout_.pointCount;
  report.moved = moved();
  measureMoves(old_, result.surface, region_.contains ? region_.border : wholeBorder(old_), report);
  if (const auto note = analysis::shortReference(*after)) report.notes.push_back(*note);
  return result;
}

Result<EditResult> editSurface(const BsplineSurface& old,
                               const EditOptions& options,
                               const EditRegion& region,
                               Progress* progress) {
  auto edit = SurfaceEdit::make(old, options, region);
  if (!edit) return fail(edit.error());
  return edit->settled(options.guidance, progress);
}

Result<EditResult> SurfaceEdit::settled(const Guidance& guidance, Progress* progress) {
  const bool looksUp = guidance.isDrawn();
  for (int k = 0;; ++k) {
    if (progress && progress->isAbortRequested()) return fail({ErrorCode::Cancelled});
    const spline::Poles before = latest_.poles;
    auto result = under(guidance);
    if (!result || !looksUp || k == energy::kLookUps) return result;
    if (progress) progress->setFraction((k + 1.0) / (energy::kLookUps + 1.0));
    const double moved = (latest_.poles - before).rowwise().norm().maxCoeff();
    if (moved < energy::kStill * result->report.diagonal) return result;
    if (progress && progress->isFinishRequested()) {
      result->report.notes.push_back(
          {.code = analysis::NoteCode::LookUpsStopped, .value = k + 1.0});
      return result;
    }
  }
}

}  // namespace fairing
