// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "cli/arguments.h"

namespace fairing::cli {

/// What a command leaves behind, as the process' exit status.
enum class Outcome {
  WithinTolerance = 0,
  OutOfTolerance = 1,  ///< a result was written all the same
  NothingWritten = 2,  ///< one line on stderr says why
};

[[nodiscard]] Outcome runFill(const FillArguments& arguments);
[[nodiscard]] Outcome runBlend(const BlendArguments& arguments);
[[nodiscard]] Outcome runEdit(const EditArguments& arguments);
[[nodiscard]] Outcome runCompare(const CompareArguments& arguments);
[[nodiscard]] Outcome runCompareBlend(const CompareBlendArguments& arguments);
[[nodiscard]] Outcome runReport(const ReportArguments& arguments);

}  // namespace fairing::cli
