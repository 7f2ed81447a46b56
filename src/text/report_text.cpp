// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/report_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/quantities.h"
#include "text/words.h"

namespace fairing::text {
namespace {

using analysis::CornerReport;
using analysis::Deviation;
using analysis::FillReport;
using analysis::SideReport;

bool asksTangency(const SideReport& side) {
  return side.asked != Continuity::G0;
}

/// A miss, measured in units of its limit.
struct Miss {
  enum class Kind { Gap, Angle, Corner, Backwards } kind = Kind::Gap;
  double ratio = 0.0;
  const SideReport* side = nullptr;
};

Miss worstMiss(const FillReport& report) {
  Miss worst;
  const auto consider = [&](Miss::Kind kind, double ratio, const SideReport& side) {
    if (!(ratio <= worst.ratio)) worst = {kind, ratio, &side};
  };
  for (const SideReport& side : report.sides) {
    consider(Miss::Kind::Gap, side.gap.max / report.gapLimit, side);
    if (!asksTangency(side)) continue;
    consider(Miss::Kind::Angle, side.angle.max / report.angleLimit, side);
    consider(Miss::Kind::Corner, side.cornerAngle.max / report.cornerAngleLimit, side);
    if (side.backwards) consider(Miss::Kind::Backwards, 1e9, side);
  }
  return worst;
}

/// Why tangency fails near a corner, where the corner is to blame.
std::string cornerReason(const FillReport& report,
                         const SideReport& side,
                         const Eigen::Vector3d& where) {
  const CornerReport* nearest = nullptr;
  for (const CornerReport& corner : report.corners) {
    if (corner.edgeBefore != side.edge && corner.edgeAfter != side.edge) continue;
    if (!nearest || (corner.point - where).norm() < (nearest->point - where).norm())
      nearest = &corner;
  }
  if (!nearest) return {};
  const auto faces =
      fmt::format("the faces beside edges {} and {}", nearest->edgeBefore, nearest->edgeAfter);
  if (!nearest->normalsAgree)
    return fmt::format(": {} differ by {} there", faces, angle(nearest->normalMismatch));
  if (!nearest->twistsAgree)
    return fmt::format(": {} bend differently there, so no smooth patch can meet both", faces);
  return {};
}

/// Why a side cannot be met better, where the edge itself is to blame.
std::string edgeReason(const SideReport& side) {
  if (side.followedBy > 0.0)
    return fmt::format(
        ": the edge waves about its own face, up to {} off; the patch follows the face there",
        length(side.supportDeviation));
  if (side.floorAngle > 0.5 * std::max(side.angle.max, side.cornerAngle.max))
    return fmt::format(": the edge itself leaves its face's tangent plane by {}",
                       angle(side.floorAngle));
  return {};
}

/// Why tangency fails at a place: the edge's own fault before the corner's.
std::string reason(const FillReport& report, const SideReport& side, const Eigen::Vector3d& where) {
  const std::string own = edgeReason(side);
  return own.empty() ? cornerReason(report, side, where) : own;
}

std::string missSentence(const FillReport& report, const Miss& miss) {
  const SideReport& side = *miss.side;
  switch (miss.kind) {
    case Miss::Kind::Gap:
      return fmt::format("Edge {} is missed by {} at {} (allowed: {}){}",
                         side.edge,
                         length(side.gap.max),
                         point(side.gap.where),
                         length(report.gapLimit),
                         edgeReason(side));
    case Miss::Kind::Backwards:
      return fmt::format("The patch leaves edge {} backwards, in a cusp, near {}",
                         side.edge,
                         point(side.angle.where));
    case Miss::Kind::Angle:
      return fmt::format("Edge {} misses tangency by {} at {}{}",
                         side.edge,
                         angle(side.angle.max),
                         point(side.angle.where),
                         reason(report, side, side.angle.where));
    case Miss::Kind::Corner:
      break;
  }
  return fmt::format("Edge {} misses tangency by {} near its end at {}{}",
                     side.edge,
                     angle(side.cornerAngle.max),
                     point(side.cornerAngle.where),
                     reason(report, side, side.cornerAngle.where));
}

std::string positionOnly(const FillReport& report) {
  std::string list;
  for (const SideReport& side : report.sides) {
    if (!asksTangency(side)) list += (list.empty() ? "" : ", ") + std::to_string(side.edge);
  }
  return list;
}

}  // namespace

std::string verdict(const FillReport& report) {
  const std::size_t all = report.sides.size();
  if (report.withinTolerance) {
    const std::string inPosition = positionOnly(report);
    const auto tangent = fmt::format(
        "tangent within {}, ", angle(std::max(report.largestAngle, report.largestCornerAngle)));
    const bool anyTangent = std::any_of(report.sides.begin(), report.sides.end(), asksTangency);
    return fmt::format("Meets all {} edges{}: {}gap {}.",
                       all,
                       inPosition.empty() ? "" : fmt::format(" (in position only: {})", inPosition),
                       anyTangent ? tangent : "",
                       length(report.largestGap));
  }
  const Miss miss = worstMiss(report);
  if (miss.side == nullptr) return "Nothing was measured.";
  const auto out = std::count_if(report.sides.begin(),
                                 report.sides.end(),
                                 [](const SideReport& side) { return !side.withinTolerance; });
  const std::string others =
      out > 1 ? fmt::format(" {} of {} edges are out of tolerance.", out, all) : std::string();
  return missSentence(report, miss) + "." + others;
}

std::string table(const FillReport& report) {
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
    const bool measured = side.face > 0;
    const auto degrees = [&](const Deviation& d) {
      return measured ? angle(d.max) : std::string("-");
    };
    text += fmt::format("{:>6} {:>6} {:>6} {:>10} {:>10} {:>10} {:>10}  {}\n",
                        side.edge,
                        measured ? std::to_string(side.face) : "-",
                        word(side.asked),
                        length(side.gap.max),
                        degrees(side.angle),
                        degrees(side.cornerAngle),
                        measured ? fmt::format("{:.1f} %", 100.0 * side.curvature.max) : "-",
                        side.backwards         ? "backwards"
                        : side.withinTolerance ? "ok"
                                               : "out of tolerance");
  }
  return text;
}

}  // namespace fairing::text
