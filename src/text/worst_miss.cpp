// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/worst_miss.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/quantities.h"

namespace fairing::text {
namespace {

using analysis::CornerReport;
using analysis::FillReport;
using analysis::InnerReport;
using analysis::SeamReport;
using analysis::SideReport;

/// A patch that leaves an edge backwards is worse than any number.
constexpr double kCusp = 1e9;

/// A miss, measured in units of its limit. One of the three pointers is set.
struct Miss {
  enum class Kind { Gap, Angle, Corner, Curvature, Departure, Backwards } kind = Kind::Gap;
  double ratio = 0.0;
  const SideReport* side = nullptr;
  const SeamReport* seam = nullptr;
  const InnerReport* inner = nullptr;
};

class Ranking {
 public:
  explicit Ranking(const FillReport& report) {
    for (const SideReport& side : report.sides) rank(report, side);
    for (const SeamReport& seam : report.seams) {
      consider({Miss::Kind::Gap, seam.gap.max / report.gapLimit, nullptr, &seam});
      consider({Miss::Kind::Angle, seam.angle.max / report.angleLimit, nullptr, &seam});
      if (seam.asksCurvature())
        consider({Miss::Kind::Curvature, seam.jump.max / report.curvatureLimit, nullptr, &seam});
    }
    for (const InnerReport& inner : report.inner) {
      consider({Miss::Kind::Gap, inner.gap.max / report.gapLimit, nullptr, nullptr, &inner});
    }
  }
  [[nodiscard]] const Miss& worst() const { return worst_; }

 private:
  void rank(const FillReport& report, const SideReport& side) {
    consider({Miss::Kind::Gap, side.gap.max / report.gapLimit, &side});
    if (!asksTangency(side)) return;
    consider({Miss::Kind::Angle, side.angle.max / report.angleLimit, &side});
    consider({Miss::Kind::Corner, side.cornerAngle.max / side.cornerAngleLimit, &side});
    if (side.backwards) consider({Miss::Kind::Backwards, kCusp, &side});
    if (side.departure.count > 0)
      consider({Miss::Kind::Departure, side.departure.max / report.departureLimit, &side});
    if (!asksCurvature(side)) return;
    consider({Miss::Kind::Curvature, side.curvature.max / report.curvatureLimit, &side});
  }
  void consider(const Miss& miss) {
    if (!(miss.ratio <= worst_.ratio)) worst_ = miss;
  }
  Miss worst_;
};

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

std::string sideSentence(const FillReport& report, const Miss& miss) {
  const SideReport& side = *miss.side;
  switch (miss.kind) {
    case Miss::Kind::Gap:
      return fmt::format("{} is missed by {} at {} (allowed: {}){}",
                         side.edge > 0 ? fmt::format("Edge {}", side.edge)
                                       : fmt::format("The end on face {}", side.face),
                         length(side.gap.max),
                         point(side.gap.where),
                         length(report.gapLimit),
                         edgeReason(side));
    case Miss::Kind::Backwards:
      return side.askedLeaving == boundary::Leaving::Backwards
                 ? fmt::format(
                       "The patch leaves edge {} onwards, though it is to be flipped, near {}",
                       side.edge,
                       point(side.angle.where))
                 : fmt::format("The patch leaves edge {} backwards, in a cusp, near {}",
                               side.edge,
                               point(side.angle.where));
    case Miss::Kind::Departure:
      return fmt::format(
          "The patch leaves edge {} {} off the direction asked for at {} (allowed: {})",
          side.edge,
          angle(side.departure.max),
          point(side.departure.where),
          angle(report.departureLimit));
    case Miss::Kind::Angle:
      return fmt::format("Edge {} misses tangency by {} at {}{}",
                         side.edge,
                         angle(side.angle.max),
                         point(side.angle.where),
                         reason(report, side, side.angle.where));
    case Miss::Kind::Curvature:
      return fmt::format("Edge {} misses the curvature beside it by {} at {} (allowed: {}){}",
                         side.edge,
                         percent(side.curvature.max),
                         point(side.curvature.where),
                         percent(report.curvatureLimit),
                         cornerReason(report, side, side.curvature.where));
    case Miss::Kind::Corner:
      break;
  }
  return fmt::format("Edge {} misses tangency by {} near its end at {}{}",
                     side.edge,
                     angle(side.cornerAngle.max),
                     point(side.cornerAngle.where),
                     reason(report, side, side.cornerAngle.where));
}

std::string seamSentence(const FillReport& report, const Miss& miss) {
  const SeamReport& seam = *miss.seam;
  const auto sentence = [&](const char* what,
                            const std::string& amount,
                            const Eigen::Vector3d& where,
                            const std::string& limit) {
    return fmt::format("Patches {} and {} {} by {} at {} (allowed: {})",
                       seam.patch + 1,
                       seam.other + 1,
                       what,
                       amount,
                       point(where),
                       limit);
  };
  if (miss.kind == Miss::Kind::Gap)
    return sentence("are apart", length(seam.gap.max), seam.gap.where, length(report.gapLimit));
  if (miss.kind == Miss::Kind::Curvature)
    return sentence("differ in curvature",
                    percent(seam.jump.max),
                    seam.jump.where,
                    percent(report.curvatureLimit));
  return sentence(
      "miss tangency", angle(seam.angle.max), seam.angle.where, angle(report.angleLimit));
}

}  // namespace

bool asksTangency(const SideReport& side) {
  return side.asked != Continuity::G0;
}

bool asksCurvature(const SideReport& side) {
  return side.asked == Continuity::G2;
}

std::optional<std::string> worstMiss(const FillReport& report) {
  const Ranking ranking(report);
  const Miss& miss = ranking.worst();
  if (miss.side != nullptr) return sideSentence(report, miss);
  if (miss.seam != nullptr) return seamSentence(report, miss);
  if (miss.inner == nullptr) return std::nullopt;
  return fmt::format("Inner constraint {} is missed by {} at {} (allowed: {})",
                     miss.inner->number,
                     length(miss.inner->gap.max),
                     point(miss.inner->gap.where),
                     length(report.gapLimit));
}

}  // namespace fairing::text
