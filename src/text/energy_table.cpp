// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/energy_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/error_text.h"
#include "text/quantities.h"
#include "text/words.h"
#include "text/worst_miss.h"

namespace fairing::text {
namespace {

constexpr const char* kRow = "{:<31} {:>9} {:>8} {}{:>11} {:>11} {:>14} {:>14} {:>8}\n";

bool asksForCurvature(const EnergyLine& line) {
  if (line.fill == nullptr) return false;
  const auto& sides = line.fill->report.sides;
  return std::any_of(sides.begin(), sides.end(), asksCurvature);
}

// The column that is there for G2 only.
std::string ifWanted(bool withCurvature, const std::string& text) {
  return withCurvature ? fmt::format("{:>9} ", text) : "";
}

std::string row(const EnergyLine& line, bool withCurvature) {
  if (line.fill == nullptr)
    return fmt::format(
        "{:<31} {}\n", word(line.energy), line.error != nullptr ? sentence(*line.error) : "");
  const analysis::FillReport& report = line.fill->report;
  const analysis::FairnessReport& fair = report.fairness;
  return fmt::format(fmt::runtime(kRow),
                     word(line.energy),
                     length(report.largestGap),
                     angle(std::max(report.largestAngle, report.largestCornerAngle)),
                     ifWanted(withCurvature, percent(report.largestCurvature)),
                     number(fair.thinPlate),
                     number(fair.totalCurvature),
                     number(fair.meanCurvatureGradient),
                     number(fair.minimumVariation),
                     fmt::format("{:.2f}", line.fill->summary.totalTime));
}

}  // namespace

std::string table(const std::vector<EnergyLine>& energies) {
  const bool withCurvature = std::any_of(energies.begin(), energies.end(), asksForCurvature);
  std::string text = fmt::format(fmt::runtime(kRow),
                                 "energy",
                                 "gap",
                                 "angle",
                                 ifWanted(withCurvature, "curvature"),
                                 "thin plate",
                                 "k1^2+k2^2",
                                 "|grad H|^2",
                                 "MVS",
                                 "seconds");
  text += fmt::format(fmt::runtime(kRow),
                      "",
                      "",
                      "",
                      ifWanted(withCurvature, ""),
                      "mm^2",
                      "",
                      "1/mm^2",
                      "1/mm^2",
                      "");
  for (const EnergyLine& line : energies) text += row(line, withCurvature);
  return text;
}

}  // namespace fairing::text
