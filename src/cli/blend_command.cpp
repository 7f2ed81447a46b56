// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/finish_on_interrupt.h"
#include "cli/output.h"
#include "occt/blend_shape.h"
#include "occt/shape_file.h"
#include "text/report_json.h"
#include "text/report_text.h"

namespace fairing::cli {
namespace {

/// Everything that can be wrong is found before the work starts.
struct Job {
  BlendOptions options;
  occt::ResultMode mode = occt::ResultMode::Patches;
  occt::ShapeIndex index;
  occt::BlendPicks picks;
};

Result<Job> prepare(const BlendArguments& arguments) {
  const auto mode = arguments.solve.mode();
  if (!mode) return fail(mode.error());
  const auto options = arguments.options();
  if (!options) return fail(options.error());
  if (const auto writable = checkOutputs(arguments.solve.out, arguments.solve.report); !writable)
    return fail(writable.error());
  const auto shape = occt::readShape(arguments.solve.shape);
  if (!shape) return fail(shape.error());
  Job job{*options, *mode, occt::ShapeIndex(*shape), {}};
  if (job.index.edgeCount() == 0) return fail({.code = ErrorCode::ShapeEmpty});
  const auto picks = arguments.picks(job.index);
  if (!picks) return fail(picks.error());
  job.picks = *picks;
  return job;
}

}  // namespace

Outcome runBlend(const BlendArguments& arguments) {
  const auto job = prepare(arguments);
  if (!job) return complain(job.error());
  FinishOnInterrupt interrupt;
  const auto blended =
      occt::blendShape(job->index, job->picks, job->options, job->mode, interrupt.progress());
  if (!blended) return complain(blended.error());
  const auto written = occt::writeShape(blended->shape, arguments.solve.out);
  if (!written) return complain(written.error());
  const FillResult& result = blended->fill;
  fmt::print("{}\n{}{}\n",
             text::verdict(result.report),
             text::table(result.report),
             text::composition(result));
  if (!arguments.solve.report.empty()) {
    const nlohmann::json report = {{"within_tolerance", result.report.withinTolerance},
                                   {"blend", text::toJson(result)}};
    if (const auto told = writeJson(report, arguments.solve.report); !told) complain(told.error());
  }
  return result.report.withinTolerance ? Outcome::WithinTolerance : Outcome::OutOfTolerance;
}

}  // namespace fairing::cli
