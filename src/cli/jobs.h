// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "cli/arguments.h"
#include "core/base/result.h"
#include "occt/shape_index.h"

namespace fairing::cli {

/// What a command is to do, every file read: what can be wrong is found before the work starts.
struct FillJob {
  FillOptions options;
  occt::ShapeIndex index;
  std::vector<occt::Picks> holes;
};

struct BlendJob {
  BlendOptions options;
  occt::ShapeIndex index;
  occt::BlendPicks picks;
};

/// Fail with the codes of what the arguments read, of checkOutputs() and readShape(), and with
/// ShapeEmpty.
[[nodiscard]] Result<FillJob> prepare(const FillArguments& arguments);
[[nodiscard]] Result<BlendJob> prepare(const BlendArguments& arguments);

}  // namespace fairing::cli
