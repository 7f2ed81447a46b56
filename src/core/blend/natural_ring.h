// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <utility>

#include "core/base/progress.h"
#include "core/blend/blend_options.h"
#include "core/blend/natural_blend.h"
#include "core/boundary/chain_ring.h"

namespace fairing {

/// A junction, or a blend round a vertex. Reach scales the rows of control points next to a chain,
/// as in a strip (inner_rows.h); they are drawn there, not held: near seams these have a say, too.
class NaturalRing final : public NaturalBlend {
 public:
  /// What `options` say of the reach is left to reaching(). Fails as spanPlan() and the plans
  /// (layout/junction.h, layout/vertex_blend.h) do.
  [[nodiscard]] static Result<NaturalRing> make(const boundary::ChainRing& ring,
                                                const BlendOptions& options,
                                                Progress* progress = nullptr);

  /// The first chain reaches as reach.start[0] says, the others as reach.start[1]. Refined until it
  /// is within tolerance or the limits of the options are reached. Fails with ReachVariesRound.
  [[nodiscard]] Result<FillResult> reaching(const Reach& reach) const override;
  [[nodiscard]] std::shared_ptr<const NaturalBlend> guided(energy::Guidance guidance,
                                                           FillResult result) const override {
    return NaturalBlend::guided(*this, std::move(guidance), std::move(result));
  }

 private:
  NaturalRing(std::shared_ptr<const Span> span, FillOptions options, FillResult result)
      : NaturalBlend(std::move(span), std::move(options), std::move(result)) {}

  [[nodiscard]] HeldPoints drawnRows(const layout::PatchLayout& layout,
                                     const Patches& patches,
                                     const Reach& reach) const;
};

}  // namespace fairing
