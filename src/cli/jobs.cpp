// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/jobs.h"

#include <utility>

#include "cli/output.h"
#include "cli/targets.h"
#include "occt/shape_file.h"

namespace fairing::cli {
namespace {

Result<occt::ShapeIndex> readIndex(const SolveArguments& arguments) {
  if (const auto writable = checkOutputs(arguments.out, arguments.report); !writable)
    return fail(writable.error());
  const auto shape = occt::readShape(arguments.shape);
  if (!shape) return fail(shape.error());
  occt::ShapeIndex index(*shape);
  if (index.edgeCount() == 0) return fail({.code = ErrorCode::ShapeEmpty});
  return index;
}

}  // namespace

Result<FillJob> prepare(const FillArguments& arguments) {
  const auto picks = arguments.picks.picks();
  if (!picks) return fail(picks.error());
  auto options = arguments.options();
  if (!options) return fail(options.error());
  auto index = readIndex(arguments.solve);
  if (!index) return fail(index.error());
  auto through = arguments.innerConstraints(*index);
  if (!through) return fail(through.error());
  options->through = std::move(*through);
  auto holes = targets(*index, *picks, arguments.outer);
  if (!holes) return fail(holes.error());
  return FillJob{std::move(*options), std::move(*index), std::move(*holes)};
}

Result<BlendJob> prepare(const BlendArguments& arguments) {
  auto options = arguments.options();
  if (!options) return fail(options.error());
  auto index = readIndex(arguments.solve);
  if (!index) return fail(index.error());
  auto picks = arguments.picks(*index);
  if (!picks) return fail(picks.error());
  return BlendJob{std::move(*options), std::move(*index), std::move(*picks)};
}

}  // namespace fairing::cli
