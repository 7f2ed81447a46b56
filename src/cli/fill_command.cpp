// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/targets.h"
#include "occt/fill_shape.h"
#include "occt/shape_file.h"
#include "text/error_text.h"
#include "text/report_json.h"
#include "text/report_text.h"

namespace fairing::cli {
namespace {

/// Everything that can be wrong is found before the work starts.
struct Job {
  FillOptions options;
  occt::ResultMode mode = occt::ResultMode::Patches;
  occt::ShapeIndex index;
  std::vector<occt::Picks> holes;
};

Result<Job> prepare(const FillArguments& arguments) {
  const auto picks = arguments.picks.picks();
  if (!picks) return fail(picks.error());
  const auto mode = arguments.mode();
  if (!mode) return fail(mode.error());
  auto options = arguments.options();
  if (!options) return fail(options.error());
  if (const auto writable = occt::checkWritable(arguments.out); !writable)
    return fail(writable.error());
  if (!arguments.report.empty()) {
    if (const auto writable = checkJsonWritable(arguments.report); !writable)
      return fail(writable.error());
  }
  const auto shape = occt::readShape(arguments.shape);
  if (!shape) return fail(shape.error());
  Job job{std::move(*options), *mode, occt::ShapeIndex(*shape), {}};
  if (job.index.edgeCount() == 0) return fail({.code = ErrorCode::ShapeEmpty});
  auto holes = targets(job.index, *picks);
  if (!holes) return fail(holes.error());
  job.holes = std::move(*holes);
  return job;
}

}  // namespace

Outcome runFill(const FillArguments& arguments) {
  const auto job = prepare(arguments);
  if (!job) return complain(job.error());

  std::vector<occt::JoinPart> parts;
  std::vector<int> replaced;
  nlohmann::json reports = nlohmann::json::array();
  bool allWithin = true;
  for (const occt::Picks& hole : job->holes) {
    const auto filled = occt::fillShape(job->index, hole, job->options, occt::ResultMode::Patches);
    if (!filled) {
      complain(filled.error());
      allWithin = false;
      continue;
    }
    const analysis::FillReport& report = filled->fill.report;
    fmt::print("{}\n{}", text::verdict(report), text::table(report));
    allWithin = allWithin && report.withinTolerance;
    reports.push_back(text::toJson(filled->fill));
    parts.push_back({filled->shape, filled->loop, report.largestGap});
    replaced.insert(replaced.end(), hole.faces.begin(), hole.faces.end());
  }
  if (parts.empty()) return Outcome::NothingWritten;

  const auto result = occt::joinResult(job->index, replaced, parts, job->mode);
  if (!result) return complain(result.error());
  if (const auto written = occt::writeShape(*result, arguments.out); !written)
    return complain(written.error());
  if (!arguments.report.empty()) {
    const nlohmann::json all{{"within_tolerance", allWithin}, {"holes", std::move(reports)}};
    if (const auto written = writeJson(all, arguments.report); !written) complain(written.error());
  }
  return allWithin ? Outcome::WithinTolerance : Outcome::OutOfTolerance;
}

}  // namespace fairing::cli
