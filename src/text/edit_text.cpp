// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/edit_text.h"

#include <fmt/format.h>

#include "text/note_text.h"
#include "text/quantities.h"
#include "text/report_json.h"
#include "text/words.h"

namespace fairing::text {
namespace {

std::string row(const char* name, const std::string& before, const std::string& after) {
  return fmt::format("{:<34} {:>12} {:>12}\n", name, before, after);
}

std::string guideRows(const analysis::GuidanceReport& before,
                      const analysis::GuidanceReport& after) {
  std::string rows;
  if (after.normals > 0) {
    rows += row("angle to the normals, rms", angle(before.rmsAngle), angle(after.rmsAngle));
    rows += row("largest", angle(before.largestAngle), angle(after.largestAngle));
  }
  if (after.points > 0)
    rows += row(
        "distance to the reference, rms", length(before.rmsDistance), length(after.rmsDistance));
  return rows;
}

}  // namespace

std::string verdict(const EditReport& report) {
  return fmt::format(
      "{} of {} control points moved, the surface by {} at most; the border by {}, turned by {}.",
      report.moved,
      report.poles,
      length(report.largestMove),
      length(report.borderMove),
      angle(report.borderTurn));
}

std::string table(const EditReport& report) {
  std::string text = verdict(report) + "\n" + row("", "before", "after") +
                     guideRows(report.before, report.after) +
                     row("energy, mm^2", number(report.energyBefore), number(report.energy));
  for (const analysis::Note& note : report.notes) text += "Note: " + sentence(note) + "\n";
  return text;
}

nlohmann::json toJson(const EditResult& edit) {
  const EditReport& report = edit.report;
  return {{"verdict", verdict(report)},
          {"before", toJson(report.before)},
          {"after", toJson(report.after)},
          {"energy_before", report.energyBefore},
          {"energy", report.energy},
          {"border_move", report.borderMove},
          {"border_turn", report.borderTurn},
          {"largest_move", report.largestMove},
          {"diagonal", report.diagonal},
          {"kept", word(report.kept)},
          {"poles", report.poles},
          {"moved", report.moved},
          {"degree", {edit.surface.u.degree(), edit.surface.v.degree()}},
          {"notes", notesToJson(report.notes)}};
}

}  // namespace fairing::text
