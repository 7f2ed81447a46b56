// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/layout/layout_plan.h"
#include "core/layout/patch_layout.h"
#include "core/solver/quadratic_program.h"
#include "core/solver/solve.h"
#include "core/span/fill_options.h"
#include "core/spline/bspline_surface.h"

namespace fairing {

using Patches = std::vector<spline::BsplineSurface>;

/// The patches of a layout from its points.
[[nodiscard]] Patches makePatches(const layout::PatchLayout& layout, const solver::Points& points);

/// The points of a layout from its patches: undoes makePatches().
[[nodiscard]] solver::Points pointsOf(const layout::PatchLayout& layout, const Patches& patches);

/// Patches written in the points of a finer layout of the same plan: same degrees or higher ones,
/// and knots that contain theirs.
[[nodiscard]] solver::Points pointsOn(const layout::PatchLayout& layout, const Patches& coarse);

/// The layout a plan's patches lie on.
[[nodiscard]] layout::PatchLayout layoutOf(const layout::LayoutPlan& plan, const Patches& patches);

/// Points that are to lie where they are told, row k of `values` for points[k].
struct HeldPoints {
  std::vector<int> points;
  solver::Points values;
  /// Then they must agree with what the sides and ties ask; else they are drawn there, as near as
  /// sides and ties let them.
  bool firmly = true;
};

/// What the patches are drawn to, in points of their layout.
struct Aim {
  std::optional<solver::Points> shape;  ///< the energy is that of the difference to it
  /// Where G2 sides and seams and inner constraints are taken; without it these are G1, constraints
  /// left out.
  std::optional<solver::Points> about;
  HeldPoints held;
  /// Where guidance that isDrawn() is looked up first; without it near the minimiser that nothing
  /// guides.
  std::optional<solver::Points> near = std::nullopt;
};

/// What the patches of a layout minimise, the quadratic energy of `kind`, and subject to what.
[[nodiscard]] Result<solver::QuadraticProgram> makeProgram(
    const layout::LayoutPlan& plan,
    const layout::PatchLayout& layout,
    EnergyKind kind,
    const Aim& aim = {},
    const std::vector<InnerConstraint>& through = {});

/// Whether a program has rows that depend on where they are taken: G2 sides and seams, inner
/// constraints.
[[nodiscard]] bool isIterated(const layout::LayoutPlan& plan, const FillOptions& options);

/// What is wrong with a field on the patches of a layout, if anything: FieldManyPatches.
[[nodiscard]] std::optional<Error> fieldMisplaced(const energy::Guidance& guidance,
                                                  const layout::PatchLayout& layout);

}  // namespace fairing
