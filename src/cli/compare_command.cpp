// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/targets.h"
#include "occt/fill_shape.h"
#include "occt/shape_file.h"
#include "text/energy_table.h"
#include "text/error_text.h"
#include "text/report_json.h"
#include "text/words.h"

namespace fairing::cli {
namespace {

/// Everything that can be wrong is found before the work starts.
struct Job {
  FillOptions options;
  std::vector<EnergyKind> energies;
  occt::ShapeIndex index;
  std::vector<occt::Picks> holes;
};

Result<std::vector<EnergyKind>> energiesFrom(const std::vector<std::string>& words) {
  if (words.empty()) return text::allEnergies();
  std::vector<EnergyKind> energies;
  for (const std::string& word : words) {
    const auto energy = text::energyFrom(word);
    if (!energy) return fail(unknown("--energies", word));
    energies.push_back(*energy);
  }
  return energies;
}

Result<Job> prepare(const CompareArguments& arguments) {
  const auto picks = arguments.picks.picks();
  if (!picks) return fail(picks.error());
  auto energies = energiesFrom(arguments.energies);
  if (!energies) return fail(energies.error());
  auto options = arguments.options();
  if (!options) return fail(options.error());
  const auto shape = occt::readShape(arguments.shape);
  if (!shape) return fail(shape.error());
  Job job{std::move(*options), std::move(*energies), occt::ShapeIndex(*shape), {}};
  if (job.index.edgeCount() == 0) return fail({.code = ErrorCode::ShapeEmpty});
  auto holes = targets(job.index, *picks);
  if (!holes) return fail(holes.error());
  job.holes = std::move(*holes);
  return job;
}

nlohmann::json reportOf(const text::EnergyLine& line) {
  nlohmann::json item = line.fill != nullptr
                            ? text::toJson(*line.fill)
                            : nlohmann::json{{"error", text::sentence(*line.error)}};
  item["energy"] = text::word(line.energy);
  return item;
}

}  // namespace

Outcome runCompare(const CompareArguments& arguments) {
  auto job = prepare(arguments);
  if (!job) return complain(job.error());
  if (job->holes.size() > 1) {
    complain(fmt::format(
        "Energies are compared on one hole, and the shape has {}: pick an edge with --edges.",
        job->holes.size()));
    return Outcome::NothingWritten;
  }
  std::vector<Result<occt::ShapeFill>> fills;
  std::vector<text::EnergyLine> lines;
  fills.reserve(job->energies.size());  // lines point into it
  bool allWithin = true, noneSolved = true;
  for (const EnergyKind energy : job->energies) {
    job->options.energy = energy;
    const auto& fill = fills.emplace_back(
        occt::fillShape(job->index, job->holes.front(), job->options, occt::ResultMode::Patches));
    lines.push_back({energy, fill ? &fill->fill : nullptr, fill ? nullptr : &fill.error()});
    noneSolved = noneSolved && !fill;
    allWithin = allWithin && fill && fill->fill.report.withinTolerance;
  }
  if (noneSolved) return complain(fills.front().error());
  fmt::print("{}", text::table(lines));
  if (!arguments.report.empty()) {
    nlohmann::json reports = nlohmann::json::array();
    for (const text::EnergyLine& line : lines) reports.push_back(reportOf(line));
    if (const auto written = writeJson({{"energies", std::move(reports)}}, arguments.report);
        !written)
      return complain(written.error());
  }
  return allWithin ? Outcome::WithinTolerance : Outcome::OutOfTolerance;
}

}  // namespace fairing::cli
