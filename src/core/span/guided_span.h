// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <memory>
#include <optional>

#include "core/solver/guided_program.h"
#include "core/span/fill_options.h"
#include "core/span/fill_result.h"
#include "core/span/span.h"
#include "core/span/span_hole.h"

namespace fairing {

/// Patches on fixed knots whose guidance changes: a slider moves, a handle is dragged. Sides, seams
/// and what the patches would be without guidance stay, so another weight costs one numeric
/// factorisation. Minimises the quadratic energy of the difference to the unguided patches, which
/// is what spanPlan() does, too. Sides met in curvature and inner constraints are those at the
/// unguided patches. By one thread at a time.
class GuidedSpan {
 public:
  /// From a result of spanPlan() or under(). Fails as spanPlan() does.
  [[nodiscard]] static Result<GuidedSpan> make(const FillResult& result,
                                               const FillOptions& options);

  /// The patches under other guidance, measured; handles, curves and references are looked up near
  /// the latest ones where they changed or `lookUp` asks for it. Fails with FieldManyPatches,
  /// HandleOff, ReferenceOff and the codes of energy::validate() and solve().
  [[nodiscard]] Result<FillResult> under(const energy::Guidance& guidance, bool lookUp = true);

 private:
  GuidedSpan(std::shared_ptr<const Span> span,
             layout::PatchLayout layout,
             const solver::QuadraticProgram& program,
             solver::Points unguided,
             solver::Points latest,
             FillOptions options);

  std::shared_ptr<const Span> span_;
  layout::PatchLayout layout_;
  solver::Sparse stiffness_;
  solver::GuidedProgram program_;
  solver::Points unguided_, latest_;
  FillOptions options_;
  bool isLookedUp_ = false;
};

}  // namespace fairing
