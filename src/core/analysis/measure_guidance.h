// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/base/result.h"
#include "core/energy/guidance.h"
#include "core/spline/bspline_surface.h"

namespace fairing::analysis {

/// Whether a patch's parameters lie on the face that it carries; empty = all do.
using OnFace = std::function<bool(std::size_t patch, double u, double v)>;

/// How well patches follow what guides them, at the points the energy is summed over, by the
/// guide's own weights: lambda and gamma only scale them, so reports made with different ones can
/// be compared. References are looked up near the patches as they are. Fails with HandleOff where a
/// handle reaches no sample, ReferenceOff where a reference covers none.
[[nodiscard]] Result<GuidanceReport> measureGuidance(
    const energy::Guidance& guidance,
    const std::vector<spline::BsplineSurface>& patches,
    const OnFace& onFace = {});

/// Measures what guides a fill, if anything, into its report, and notes what a reference leaves
/// uncovered. Fails with the codes of measureGuidance().
[[nodiscard]] Result<void> addGuidance(FillReport& report,
                                       const energy::Guidance& guidance,
                                       const std::vector<spline::BsplineSurface>& patches,
                                       const OnFace& onFace = {});

/// What a reference leaves uncovered, if anything.
[[nodiscard]] std::optional<Note> shortReference(const GuidanceReport& report);

}  // namespace fairing::analysis
