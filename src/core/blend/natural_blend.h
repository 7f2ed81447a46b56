// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <memory>
#include <utility>

#include "core/base/result.h"
#include "core/blend/reach.h"
#include "core/span/fill_result.h"
#include "core/span/span_plan.h"

namespace fairing {

/// A blend as its energy likes it best among those that leave their sides as asked, kept so that
/// its sides can be made to reach farther from where it is.
class NaturalBlend {
 public:
  virtual ~NaturalBlend() = default;
  NaturalBlend(const NaturalBlend&) = default;
  NaturalBlend(NaturalBlend&&) = default;
  NaturalBlend& operator=(const NaturalBlend&) = default;
  NaturalBlend& operator=(NaturalBlend&&) = default;

  [[nodiscard]] const FillResult& result() const { return result_; }
  /// The blend with its sides' reach scaled, measured; itself where all are 1.
  [[nodiscard]] virtual Result<FillResult> reaching(const Reach& reach) const = 0;
  /// The same with another result, which other guidance has made of it.
  [[nodiscard]] virtual std::shared_ptr<const NaturalBlend> guided(energy::Guidance guidance,
                                                                   FillResult result) const = 0;
  [[nodiscard]] const FillOptions& options() const { return options_; }

 protected:
  NaturalBlend(std::shared_ptr<const Span> span, FillOptions options, FillResult result)
      : span_(std::move(span)), options_(std::move(options)), result_(std::move(result)) {
    result_.span = span_;
  }
  template <class Kind>
  static std::shared_ptr<const NaturalBlend> guided(const Kind& natural,
                                                    energy::Guidance guidance,
                                                    FillResult result) {
    auto copy = std::make_shared<Kind>(natural);
    copy->options_.guidance = std::move(guidance);
    copy->result_ = std::move(result);
    return copy;
  }

  std::shared_ptr<const Span> span_;
  FillOptions options_;
  FillResult result_;
};

}  // namespace fairing
