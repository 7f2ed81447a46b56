// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/blend/blend_options.h"
#include "core/boundary/side_chain.h"
#include "core/span/fill_result.h"
#include "core/span/span_plan.h"

namespace fairing {

/// A strip as its energy likes it best among those that leave their sides as asked, kept so that
/// its sides can be made to reach farther at the cost of one solve: for previews that follow a
/// slider.
class NaturalStrip {
 public:
  /// What `options` say of the reach is left to reaching(). Fails as checkDepartures(), spanPlan()
  /// and the strip's plan do.
  [[nodiscard]] static Result<NaturalStrip> make(const boundary::ChainPair& pair,
                                                 const BlendOptions& options,
                                                 Progress* progress = nullptr);

  [[nodiscard]] const FillResult& result() const { return result_; }
  /// The strip with both sides' reach scaled, measured; itself where both are 1.
  [[nodiscard]] Result<FillResult> reaching(const Reach& reach) const;

 private:
  /// The natural strip with the sides that it leaves amiss turned.
  [[nodiscard]] std::optional<Error> turn();

  NaturalStrip(Span span, FillOptions options, FillResult result);

  Span span_;
  FillOptions options_;
  FillResult result_;
};

}  // namespace fairing
