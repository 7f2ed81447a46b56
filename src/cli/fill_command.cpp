// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <string>
#include <vector>

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

/// What came of the holes.
struct Fills {
  std::vector<occt::JoinPart> parts;
  std::vector<int> replaced;
  nlohmann::json reports = nlohmann::json::array();
  std::vector<std::string> failures;  ///< a sentence a hole
  bool allWithin = true;
};

std::string failureOf(const occt::Picks& hole, const Error& error, bool single) {
  const std::string why = text::sentence(error);
  return single ? why : fmt::format("Hole at edge {}: {}", hole.edges.front(), why);
}

Fills fillAll(const Job& job) {
  Fills fills;
  for (const occt::Picks& hole : job.holes) {
    auto filled = occt::fillShape(job.index, hole, job.options, occt::ResultMode::Patches);
    if (!filled) {
      fills.failures.push_back(failureOf(hole, filled.error(), job.holes.size() == 1));
      fills.allWithin = false;
      continue;
    }
    const analysis::FillReport& report = filled->fill.report;
    fmt::print("{}\n{}", text::verdict(report), text::table(report));
    fills.allWithin = fills.allWithin && report.withinTolerance;
    fills.reports.push_back(text::toJson(filled->fill));
    fills.parts.push_back({filled->shape, std::move(filled->loop), report.largestGap});
    fills.replaced.insert(fills.replaced.end(), hole.faces.begin(), hole.faces.end());
  }
  return fills;
}

/// Nothing could be filled: still one line.
Outcome complainOnce(const std::vector<std::string>& failures) {
  const std::size_t more = failures.size() - 1;
  complain(failures.front() +
           (more > 0 ? fmt::format(" {} more cannot be filled either.", more) : ""));
  return Outcome::NothingWritten;
}

}  // namespace

Outcome runFill(const FillArguments& arguments) {
  const auto job = prepare(arguments);
  if (!job) return complain(job.error());
  const Fills fills = fillAll(*job);
  if (fills.parts.empty()) return complainOnce(fills.failures);

  const auto result = occt::joinResult(job->index, fills.replaced, fills.parts, job->mode);
  if (!result) return complain(result.error());
  const auto written = occt::writeShape(*result, arguments.out);
  if (!written) return complain(written.error());
  for (const std::string& failure : fills.failures) complain(failure);
  if (!arguments.report.empty()) {
    const nlohmann::json all{{"within_tolerance", fills.allWithin}, {"holes", fills.reports}};
    if (const auto told = writeJson(all, arguments.report); !told) complain(told.error());
  }
  return fills.allWithin ? Outcome::WithinTolerance : Outcome::OutOfTolerance;
}

}  // namespace fairing::cli
