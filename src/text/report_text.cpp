// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "text/error_text.h"
#include "text/note_text.h"
#include "text/quantities.h"
#include "text/words.h"
#include "text/worst_miss.h"

namespace fairing::text {
namespace {

using analysis::Deviation;
using analysis::FillReport;
using analysis::SideReport;

std::string positionOnly(const FillReport& report) {
  std::string list;
  for (const SideReport& side : report.sides) {
    if (asksTangency(side)) continue;
    list += list.empty() ? "" : ", ";
    list += side.edge > 0 ? std::to_string(side.edge) : fmt::format("on face {}", side.face);
  }
  return list;
}

std::string praise(const FillReport& report) {
  const auto any = [&](const auto& asks) {
    return std::any_of(report.sides.begin(), report.sides.end(), asks);
  };
  const std::string inPosition = positionOnly(report);
  std::string text = report.sides.size() == 1
                         ? "Meets its edge"
                         : fmt::format("Meets all {} edges", report.sides.size());
  if (!inPosition.empty()) text += fmt::format(" (in position only: {})", inPosition);
  text += ": ";
  if (any(asksTangency)) {
    const double worst = std::max(report.largestAngle, report.largestCornerAngle);
    text += fmt::format("tangent within {}, ", angle(worst));
  }
  if (any(asksCurvature))
    text += fmt::format("curvature within {}, ", percent(report.largestCurvature));
  text += fmt::format("gap {}", length(report.largestGap));
  if (!report.seams.empty())
    text += fmt::format("; seams within {}", angle(report.largestSeamAngle));
  if (std::any_of(report.seams.begin(),
                  report.seams.end(),
                  std::mem_fn(&analysis::SeamReport::asksCurvature)))
    text += fmt::format(", curvature jumps within {}", percent(report.largestSeamJump));
  if (!report.inner.empty())
    text += fmt::format("; inner constraints within {}", length(report.largestInnerGap));
  return text + ".";
}

std::string sideTable(const FillReport& report) {
  std::string text = fmt::format("{:>6} {:>6} {:>6} {:>10} {:>10} {:>10} {:>10}  {}\n",
                                 "edge",
                                 "face",
                                 "asked",
                                 "gap",
                                 "angle",
                                 "at ends",
                                 "curvature",
                                 "");
  for (const SideReport& side : report.sides) {
    const bool measured = side.angle.count > 0;
    const auto degrees = [&](const Deviation& d) {
      return measured ? angle(d.max) : std::string("-");
    };
    text += fmt::format("{:>6} {:>6} {:>6} {:>10} {:>10} {:>10} {:>10}  {}\n",
                        side.edge > 0 ? std::to_string(side.edge) : "-",
                        side.face > 0 ? std::to_string(side.face) : "-",
                        word(side.asked),
                        length(side.gap.max),
                        degrees(side.angle),
                        degrees(side.cornerAngle),
                        measured ? percent(side.curvature.max) : "-",
                        side.backwards         ? "backwards"
                        : side.withinTolerance ? "ok"
                                               : "out of tolerance");
  }
  return text;
}

std::string seamTable(const FillReport& report) {
  if (report.seams.empty()) return {};
  std::string text =
      fmt::format("{:>13} {:>17} {:>10} {:>21}\n", "patches", "gap", "angle", "curvature");
  for (const analysis::SeamReport& seam : report.seams) {
    text += fmt::format("{:>13} {:>17} {:>10} {:>21}\n",
                        fmt::format("{} - {}", seam.patch + 1, seam.other + 1),
                        length(seam.gap.max),
                        angle(seam.angle.max),
                        seam.crease ? "crease" : percent(seam.curvature.max));
  }
  return text;
}

std::string innerTable(const FillReport& report) {
  if (report.inner.empty()) return {};
  std::string text = fmt::format("{:>13} {:>17}\n", "inner", "gap");
  for (const analysis::InnerReport& inner : report.inner) {
    text += fmt::format("{:>13} {:>17}\n", inner.number, length(inner.gap.max));
  }
  return text;
}

std::string guidanceLine(const FillReport& report) {
  if (!report.guidance) return {};
  const analysis::GuidanceReport& g = *report.guidance;
  std::string text = "Guidance:";
  if (g.normals > 0)
    text += fmt::format(" {} from the normals (rms), {} at most{}",
                        angle(g.rmsAngle),
                        angle(g.largestAngle),
                        g.points > 0 ? ";" : "");
  if (g.points > 0) text += fmt::format(" {} from the reference (rms)", length(g.rmsDistance));
  return text + ".\n";
}

std::string notes(const FillReport& report) {
  std::string text;
  for (const analysis::Note& note : report.notes) text += "Note: " + sentence(note) + "\n";
  return text;
}

}  // namespace

std::string verdict(const FillReport& report) {
  if (report.withinTolerance) return praise(report);
  const auto miss = worstMiss(report);
  if (!miss) return "Nothing was measured.";
  const auto out = std::count_if(report.sides.begin(),
                                 report.sides.end(),
                                 [](const SideReport& side) { return !side.withinTolerance; });
  const std::string others =
      out > 1 ? fmt::format(" {} of {} edges are out of tolerance.", out, report.sides.size())
              : std::string();
  return *miss + "." + others;
}

std::string table(const FillReport& report) {
  return sideTable(report) + seamTable(report) + innerTable(report) + guidanceLine(report) +
         notes(report);
}

std::string composition(const FillResult& fill) {
  const std::size_t count = fill.patches.size();
  std::string text = fmt::format("Layout {}: {} patch{}, {} control points.",
                                 word(fill.layout),
                                 count,
                                 count == 1 ? "" : "es",
                                 fill.summary.poles);
  const solver::ShapeHistory& shape = fill.summary.shape;
  if (shape.end != solver::ShapeEnd::Quick && !shape.steps.empty())
    text += fmt::format(" Energy of the shape {:.3g}, from {:.3g} in {} step{}.",
                        shape.steps.back().energy,
                        shape.start,
                        shape.steps.size(),
                        shape.steps.size() == 1 ? "" : "s");
  return text;
}

std::string table(const std::vector<HoleLine>& holes) {
  std::string text = fmt::format("{:>5} {:>7} {:>6} {:>8} {:>10} {:>10}  {}\n",
                                 "hole",
                                 "edge",
                                 "sides",
                                 "layout",
                                 "gap",
                                 "angle",
                                 "verdict");
  int number = 0;
  for (const HoleLine& hole : holes) {
    const std::string start = fmt::format("{:>5} {:>7} {:>6}",
                                          ++number,
                                          hole.edges.empty() ? 0 : hole.edges.front(),
                                          hole.edges.size());
    if (hole.fill == nullptr) {
      text += fmt::format("{} {:>8} {:>10} {:>10}  {}\n",
                          start,
                          "-",
                          "-",
                          "-",
                          hole.error != nullptr ? sentence(*hole.error) : "");
      continue;
    }
    const FillReport& report = hole.fill->report;
    text += fmt::format("{} {:>8} {:>10} {:>10}  {}\n",
                        start,
                        word(hole.fill->layout),
                        length(report.largestGap),
                        angle(std::max(report.largestAngle, report.largestCornerAngle)),
                        verdict(report));
  }
  return text;
}

}  // namespace fairing::text
