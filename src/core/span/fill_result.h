// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <memory>
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/height_field/trim.h"
#include "core/layout/layout_kind.h"
#include "core/layout/layout_plan.h"
#include "core/solver/solve_summary.h"
#include "core/spline/bspline_surface.h"

namespace fairing {

struct Span;

/// A filled hole: patches, what was measured on them, and how they came about.
struct FillResult {
  std::vector<spline::BsplineSurface> patches;
  std::vector<bool> reversed;  ///< patch i's normal u x v points against the support normals
  std::vector<Trim> trims;     ///< the border of patch i; empty: no patch is trimmed
  LayoutKind layout = LayoutKind::Quad;
  /// Of a blend: points of the first and the second side that belong together, where it is cut or
  /// starts.
  std::vector<layout::MatchedPoints> matches;
  /// What the patches would be without guidance, on the same knots, and what they span: what a
  /// GuidedSpan starts from. None of a trimmed face.
  std::vector<spline::BsplineSurface> unguided;
  std::shared_ptr<const Span> span;
  analysis::FillReport report;
  solver::SolveSummary summary;
};

}  // namespace fairing
