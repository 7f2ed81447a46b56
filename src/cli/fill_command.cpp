// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/finish_on_interrupt.h"
#include "cli/jobs.h"
#include "cli/output.h"
#include "occt/fill_all.h"
#include "occt/shape_file.h"
#include "text/error_text.h"
#include "text/report_json.h"
#include "text/report_text.h"

namespace fairing::cli {
namespace {

/// One hole is told edge by edge, several in a line each.
void tell(const std::vector<occt::HoleFill>& holes) {
  std::vector<text::HoleLine> lines;
  for (const occt::HoleFill& hole : holes) {
    lines.push_back({hole.edges,
                     hole.fill ? &hole.fill->fill : nullptr,
                     hole.fill ? nullptr : &hole.fill.error()});
  }
  if (lines.size() > 1) {
    fmt::print("{}", text::table(lines));
  } else if (const FillResult* only = lines.front().fill) {
    fmt::print("{}\n{}{}\n",
               text::verdict(only->report),
               text::table(only->report),
               text::composition(*only));
  }
}

nlohmann::json reportOf(const occt::AllFilled& all) {
  nlohmann::json holes = nlohmann::json::array(), failed = nlohmann::json::array();
  for (const occt::HoleFill& hole : all.holes) {
    if (hole.fill) {
      holes.push_back(text::toJson(hole.fill->fill));
    } else {
      failed.push_back({{"edges", hole.edges}, {"error", text::sentence(hole.fill.error())}});
    }
  }
  return {{"within_tolerance", all.withinTolerance()}, {"holes", holes}, {"failed", failed}};
}

/// Nothing could be filled: still one line.
Outcome complainOnce(const std::vector<occt::HoleFill>& holes) {
  const std::size_t more = holes.size() - 1;
  complain(text::sentence(holes.front().fill.error()) +
           (more > 0 ? fmt::format(" {} more cannot be filled either.", more) : ""));
  return Outcome::NothingWritten;
}

void complainOfFailures(const std::vector<occt::HoleFill>& holes) {
  for (const occt::HoleFill& hole : holes) {
    if (hole.fill) continue;
    complain(
        fmt::format("Hole at edge {}: {}", hole.edges.front(), text::sentence(hole.fill.error())));
  }
}

}  // namespace

Outcome runFill(const FillArguments& arguments) {
  const auto mode = arguments.solve.mode();
  if (!mode) return complain(mode.error());
  const auto job = prepare(arguments);
  if (!job) return complain(job.error());
  if (job->holes.size() > 1 && !job->options.through.empty()) {
    complain(
        fmt::format("What to pass through belongs to one hole, and the shape has {}: pick an "
                    "edge of the hole with --edges.",
                    job->holes.size()));
    return Outcome::NothingWritten;
  }
  FinishOnInterrupt interrupt;
  auto filled = occt::fillHoles(job->index, job->holes, job->options, interrupt.progress());
  const auto isFilled = [](const occt::HoleFill& hole) { return hole.fill.has_value(); };
  if (std::none_of(filled.begin(), filled.end(), isFilled)) return complainOnce(filled);
  const auto all = occt::joinHoles(job->index, std::move(filled), *mode);
  if (!all) return complain(all.error());
  const auto written = occt::writeShape(all->shape, arguments.solve.out);
  if (!written) return complain(written.error());
  tell(all->holes);
  complainOfFailures(all->holes);
  if (!arguments.solve.report.empty()) {
    if (const auto told = writeJson(reportOf(*all), arguments.solve.report); !told)
      complain(told.error());
  }
  return all->withinTolerance() ? Outcome::WithinTolerance : Outcome::OutOfTolerance;
}

}  // namespace fairing::cli
