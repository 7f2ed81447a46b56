// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/base/progress.h"

namespace fairing::cli {

/// While it lives, an interrupt (Ctrl-C) asks a solve for the best so far; a second one ends the
/// program. One at a time.
class FinishOnInterrupt {
 public:
  FinishOnInterrupt();
  ~FinishOnInterrupt();
  FinishOnInterrupt(const FinishOnInterrupt&) = delete;
  FinishOnInterrupt& operator=(const FinishOnInterrupt&) = delete;

  [[nodiscard]] Progress* progress() { return &progress_; }

 private:
  Progress progress_;
};

}  // namespace fairing::cli
