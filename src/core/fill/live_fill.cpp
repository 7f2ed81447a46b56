// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/live_fill.h"

#include <utility>

#include "core/fill/fill_hole.h"

namespace fairing {

LiveFill::LiveFill(boundary::BoundaryLoop loop, FillOptions options, FillResult result)
    : loop_(std::move(loop)), options_(std::move(options)), start_(std::move(result)) {
  options_.layout = start_.layout;
}

Result<FillResult> LiveFill::under(const energy::Guidance& guidance, bool lookUp) {
  options_.guidance = guidance;
  if (!start_.span) return fillHole(loop_, options_);
  if (!guided_) {
    auto made = GuidedSpan::make(start_, options_);
    if (!made) return fail(made.error());
    guided_.emplace(std::move(*made));
  }
  return guided_->under(guidance, lookUp);
}

}  // namespace fairing
