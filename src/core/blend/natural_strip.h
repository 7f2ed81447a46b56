// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <utility>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/blend/blend_options.h"
#include "core/blend/natural_blend.h"
#include "core/boundary/side_chain.h"

namespace fairing {

/// A strip whose sides reach farther at the cost of one solve: for previews that follow a slider.
class NaturalStrip final : public NaturalBlend {
 public:
  /// What `options` say of the reach is left to reaching(). Fails as checkDepartures(), spanPlan()
  /// and the strip's plan do.
  [[nodiscard]] static Result<NaturalStrip> make(const boundary::ChainPair& pair,
                                                 const BlendOptions& options,
                                                 Progress* progress = nullptr);

  [[nodiscard]] Result<FillResult> reaching(const Reach& reach) const override;
  [[nodiscard]] std::shared_ptr<const NaturalBlend> guided(energy::Guidance guidance,
                                                           FillResult result) const override {
    return NaturalBlend::guided(*this, std::move(guidance), std::move(result));
  }

 private:
  NaturalStrip(std::shared_ptr<const Span> span, FillOptions options, FillResult result)
      : NaturalBlend(std::move(span), std::move(options), std::move(result)) {}

  /// The natural strip with the sides that it leaves amiss turned.
  [[nodiscard]] std::optional<Error> turn();
};

}  // namespace fairing
