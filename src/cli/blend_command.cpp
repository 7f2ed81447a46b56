// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/finish_on_interrupt.h"
#include "cli/jobs.h"
#include "cli/output.h"
#include "occt/blend_shape.h"
#include "occt/shape_file.h"
#include "text/report_json.h"
#include "text/report_text.h"

namespace fairing::cli {
Outcome runBlend(const BlendArguments& arguments) {
  const auto mode = arguments.solve.mode();
  if (!mode) return complain(mode.error());
  const auto job = prepare(arguments);
  if (!job) return complain(job.error());
  FinishOnInterrupt interrupt;
  const auto blended =
      occt::blendShape(job->index, job->picks, job->options, *mode, interrupt.progress());
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
