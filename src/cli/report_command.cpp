// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/targets.h"
#include "occt/measure_shape.h"
#include "occt/read_boundary.h"
#include "occt/shape_file.h"
#include "text/report_json.h"
#include "text/report_text.h"

namespace fairing::cli {

Outcome runReport(const ReportArguments& arguments) {
  const auto picks = arguments.picks.picks();
  if (!picks) return complain(picks.error());
  FillOptions limits;
  const auto tolerance = arguments.picks.tolerance();
  if (!tolerance) return complain(tolerance.error());
  limits.tolerance = *tolerance;
  if (const auto error = validate(limits)) return complain(*error);
  const auto shape = occt::readShape(arguments.shape);
  if (!shape) return complain(shape.error());
  const auto patches = occt::readShape(arguments.patches);
  if (!patches) return complain(patches.error());
  const occt::ShapeIndex index(*shape);
  const auto holes = targets(index, *picks);
  if (!holes) return complain(holes.error());

  nlohmann::json reports = nlohmann::json::array();
  bool allWithin = true;
  for (const occt::Picks& hole : *holes) {
    const auto loop = occt::readBoundary(index, hole);
    if (!loop) return complain(loop.error());
    const auto report = occt::measureShape(*loop, *patches, limits.tolerance);
    if (!report) return complain(report.error());
    fmt::print("{}\n{}", text::verdict(*report), text::table(*report));
    allWithin = allWithin && report->withinTolerance;
    reports.push_back(text::toJson(*report));
  }
  if (!arguments.report.empty()) {
    const nlohmann::json all{{"within_tolerance", allWithin}, {"holes", std::move(reports)}};
    if (const auto written = writeJson(all, arguments.report); !written)
      return complain(written.error());
  }
  return allWithin ? Outcome::WithinTolerance : Outcome::OutOfTolerance;
}

}  // namespace fairing::cli
