// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/boundary/boundary_loop.h"
#include "core/span/fill_options.h"
#include "core/span/fill_result.h"
#include "core/span/guided_span.h"

namespace fairing {

/// A fill, or a blend, whose guidance changes while a slider moves or a handle is dragged. By one
/// thread at a time.
class LiveFill {
 public:
  /// `options` as the result was made with.
  LiveFill(boundary::BoundaryLoop loop, FillOptions options, FillResult result);

  /// The patches under other guidance on the knots of the result: GuidedSpan::under(). A trimmed
  /// face is filled anew. Fails as these do.
  [[nodiscard]] Result<FillResult> under(const energy::Guidance& guidance, bool lookUp = true);
  /// Whether under() costs one solve; a trimmed face costs all of them.
  [[nodiscard]] bool isQuick() const { return start_.span != nullptr; }
  /// What guided last.
  [[nodiscard]] const energy::Guidance& guidance() const { return options_.guidance; }

 private:
  boundary::BoundaryLoop loop_;
  FillOptions options_;
  FillResult start_;
  std::optional<GuidedSpan> guided_;
};

}  // namespace fairing
