// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/finish_on_interrupt.h"
#include "cli/jobs.h"
#include "cli/output.h"
#include "occt/blend_shape.h"
#include "occt/fill_shape.h"
#include "text/energy_table.h"
#include "text/error_text.h"
#include "text/report_json.h"
#include "text/words.h"

namespace fairing::cli {
namespace {

/// Makes the surface with one energy.
using Make = std::function<Result<FillResult>(EnergyKind energy, Progress* progress)>;

struct Compared {
  EnergyKind energy;
  Result<FillResult> made;
};

std::vector<text::EnergyLine> linesOf(const std::vector<Compared>& all) {
  std::vector<text::EnergyLine> lines;
  for (const Compared& one : all)
    lines.push_back(
        {one.energy, one.made ? &*one.made : nullptr, one.made ? nullptr : &one.made.error()});
  return lines;
}

nlohmann::json reportOf(const Compared& one) {
  nlohmann::json item = one.made ? text::toJson(*one.made)
                                 : nlohmann::json{{"error", text::sentence(one.made.error())}};
  item["energy"] = text::word(one.energy);
  return item;
}

bool isStopped(const Compared& one) {
  const auto says = [](const analysis::Note& note) {
    return note.code == analysis::NoteCode::ShapeStopped;
  };
  return one.made &&
         std::any_of(one.made->report.notes.begin(), one.made->report.notes.end(), says);
}

/// In one line, how far an interrupted comparison has come; nothing where it is complete.
void complainOfStop(const std::vector<EnergyKind>& asked, const std::vector<Compared>& all) {
  std::vector<std::string> parts;
  if (isStopped(all.back()))
    parts.push_back(fmt::format("{} is the best so far", text::word(all.back().energy)));
  std::vector<std::string_view> left;
  for (std::size_t k = all.size(); k < asked.size(); ++k) left.push_back(text::word(asked[k]));
  if (!left.empty()) parts.push_back(fmt::format("not compared: {}", fmt::join(left, ", ")));
  if (!parts.empty()) complain(fmt::format("Stopped: {}.", fmt::join(parts, "; ")));
}

/// One energy after the other until an interrupt; the table and the report tell of those made.
Outcome compare(const std::vector<EnergyKind>& energies,
                const std::string& report,
                const Make& make) {
  FinishOnInterrupt interrupt;
  std::vector<Compared> all;
  const auto isInterrupted = [&] { return interrupt.progress()->isFinishRequested(); };
  for (const EnergyKind energy : energies) {
    all.push_back({energy, make(energy, interrupt.progress())});
    if (isInterrupted()) break;
  }
  const auto isMade = [](const Compared& one) { return one.made.has_value(); };
  if (std::none_of(all.begin(), all.end(), isMade)) return complain(all.front().made.error());
  fmt::print("{}", text::table(linesOf(all)));
  if (isInterrupted()) complainOfStop(energies, all);
  if (!report.empty()) {
    nlohmann::json reports = nlohmann::json::array();
    for (const Compared& one : all) reports.push_back(reportOf(one));
    if (const auto told = writeJson({{"energies", std::move(reports)}}, report); !told)
      return complain(told.error());
  }
  const bool allWithin = std::all_of(all.begin(), all.end(), [](const Compared& one) {
    return one.made && one.made->report.withinTolerance;
  });
  const bool isWhole = all.size() == energies.size();
  return allWithin && isWhole ? Outcome::WithinTolerance : Outcome::OutOfTolerance;
}

template <class Made>
Result<FillResult> fillOf(Result<Made> made) {
  if (!made) return fail(made.error());
  return std::move(made->fill);
}

}  // namespace

Outcome runCompare(const CompareArguments& arguments) {
  const auto energies = arguments.energies.read();
  if (!energies) return complain(energies.error());
  auto job = prepare(arguments.fill);
  if (!job) return complain(job.error());
  if (job->holes.size() > 1) {
    complain(fmt::format(
        "Energies are compared on one hole, and the shape has {}: pick an edge with --edges.",
        job->holes.size()));
    return Outcome::NothingWritten;
  }
  return compare(
      *energies, arguments.fill.solve.report, [&](EnergyKind energy, Progress* progress) {
        job->options.energy = energy;
        return fillOf(occt::fillShape(
            job->index, job->holes.front(), job->options, occt::ResultMode::Patches, progress));
      });
}

Outcome runCompareBlend(const CompareBlendArguments& arguments) {
  const auto energies = arguments.energies.read();
  if (!energies) return complain(energies.error());
  auto job = prepare(arguments.blend);
  if (!job) return complain(job.error());
  return compare(
      *energies, arguments.blend.solve.report, [&](EnergyKind energy, Progress* progress) {
        job->options.fill.energy = energy;
        return fillOf(occt::blendShape(
            job->index, job->picks, job->options, occt::ResultMode::Patches, progress));
      });
}

}  // namespace fairing::cli
