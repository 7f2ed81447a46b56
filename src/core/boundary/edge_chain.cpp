// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/edge_chain.h"

#include <algorithm>
#include <memory>

#include "core/boundary/arc_length.h"

namespace fairing::boundary {
namespace {

// One edge of a chain: where it runs on the chain, and how far its ends are moved.
struct Link {
  const BoundarySide& edge;
  Stretch stretch;
  ArcLength arc;
  Eigen::Vector3d moveStart = Eigen::Vector3d::Zero(), moveEnd = Eigen::Vector3d::Zero();
};

std::vector<Link> linksOf(const BoundaryLoop& loop, const std::vector<Stretch>& edges) {
  std::vector<Link> links;
  double length = 0.0;
  for (const Stretch& s : edges) {
    const BoundarySide& edge = loop.sides[s.edge];
    links.push_back({edge, s, ArcLength(edge.ribbon, s.from, s.to)});
    length += links.back().arc.length();
  }
  double behind = 0.0;
  for (Link& link : links) {
    link.stretch.start = behind / length;
    behind += link.arc.length();
    link.stretch.end = &link == &links.back() ? 1.0 : behind / length;
  }
  for (std::size_t k = 0; k + 1 < links.size(); ++k) {
    Link &before = links[k], &after = links[k + 1];
    const Eigen::Vector3d gap = after.edge.ribbon.curve(after.stretch.from).point -
                                before.edge.ribbon.curve(before.stretch.to).point;
    before.moveEnd = 0.5 * gap;
    after.moveStart = -0.5 * gap;
  }
  return links;
}

// What the chain's ribbon is evaluated from; it keeps the edges' functions alive.
struct Curve {
  struct Piece {
    std::function<CurveSample(double t)> curve;
    std::function<SupportSample(double t)> support;
    ArcLength arc;
    double start, end;
    Eigen::Vector3d moveStart, moveEnd;
  };
  std::vector<Piece> pieces;
  double length = 0.0;

  explicit Curve(const std::vector<Link>& links) {
    for (const Link& link : links) {
      pieces.push_back({link.edge.ribbon.curve,
                        link.edge.ribbon.support,
                        link.arc,
                        link.stretch.start,
                        link.stretch.end,
                        link.moveStart,
                        link.moveEnd});
      length += link.arc.length();
    }
  }

  // The piece that holds s, and the parameter of its edge there.
  [[nodiscard]] std::pair<const Piece*, double> at(double s) const {
    const auto reaches = [s](const Piece& p) { return s < p.end; };
    auto piece = std::find_if(pieces.begin(), pieces.end(), reaches);
    if (piece == pieces.end()) --piece;
    return {&*piece, piece->arc.parameterAt((s - piece->start) * length)};
  }
  [[nodiscard]] CurveSample sample(double s) const {
    const auto [piece, t] = at(s);
    CurveSample sample = piece->curve(t);
    sample.derivative *= length / sample.derivative.norm();
    const double width = piece->end - piece->start, share = (s - piece->start) / width;
    sample.point += (1.0 - share) * piece->moveStart + share * piece->moveEnd;
    sample.derivative += (piece->moveEnd - piece->moveStart) / width;
    return sample;
  }
  [[nodiscard]] SupportSample support(double s) const {
    const auto [piece, t] = at(s);
    if (piece->support) return piece->support(t);
    SupportSample none;
    none.singular = true;
    return none;
  }
};

// Whether an edge that closes upon itself does so with its curvature: no knot is needed there.
bool closesSmoothly(const Link& before, const Link& after) {
  constexpr double kStep = 1e-4, kSame = 1e-3;
  if (&before.edge != &after.edge) return false;
  const auto& curve = before.edge.ribbon.curve;
  const auto tangent = [&](double t) -> Eigen::Vector3d {
    return curve(t).derivative.normalized();
  };
  const Eigen::Vector3d end =
      3.0 * tangent(1.0) - 4.0 * tangent(1.0 - kStep) + tangent(1.0 - 2.0 * kStep);
  const Eigen::Vector3d start = -3.0 * tangent(0.0) + 4.0 * tangent(kStep) - tangent(2.0 * kStep);
  const double endSpeed = curve(1.0).derivative.norm(), startSpeed = curve(0.0).derivative.norm();
  const Eigen::Vector3d jump = end / endSpeed - start / startSpeed;
  return jump.norm() * endSpeed <= kSame * 2.0 * kStep &&
         (tangent(1.0) - tangent(0.0)).norm() < kSame;
}

// The edges' breaks, and one at every joint. Next to an end a break is the end, reached but for
// rounding: a chain cut where two edges meet begins with a crumb of the one before.
std::vector<CurveBreak> breaksOf(const std::vector<Link>& links, double length) {
  std::vector<CurveBreak> breaks;
  for (const Link& link : links) {
    for (const CurveBreak& b : link.edge.ribbon.breaks)
      if (link.stretch.from < b.t && b.t < link.stretch.to)
        breaks.push_back({link.stretch.start + link.arc.lengthUpTo(b.t) / length, b.continuity});
    if (&link != &links.back() && !closesSmoothly(link, *(&link + 1)))
      breaks.push_back({link.stretch.end, 1});
  }
  constexpr double kCrumb = 1e-6;
  std::erase_if(breaks, [](const CurveBreak& b) { return b.t < kCrumb || b.t > 1.0 - kCrumb; });
  return breaks;
}

void addParts(const Link& link, double length, std::vector<Stretch>& result) {
  constexpr int kParts = 8;
  const Stretch& s = link.stretch;
  const auto edgeAt = [&](int part) {
    return part == kParts ? s.to : s.from + (s.to - s.from) * part / kParts;
  };
  const auto chainAt = [&](int part) {
    return s.start + link.arc.lengthUpTo(edgeAt(part)) / length;
  };
  for (int m = 0; m < kParts; ++m)
    result.push_back({s.edge,
                      edgeAt(m),
                      edgeAt(m + 1),
                      m == 0 ? s.start : chainAt(m),
                      m + 1 == kParts ? s.end : chainAt(m + 1)});
}

// One edge, or a stretch of it, affine in its own parameter.
BoundarySide stretchOfEdge(const BoundarySide& edge, const Stretch& s) {
  BoundarySide side = edge;
  if (s.from == 0.0 && s.to == 1.0) return side;
  const double from = s.from, width = s.to - s.from;
  side.ribbon.curve = [curve = edge.ribbon.curve, from, width](double t) {
    CurveSample sample = curve(from + t * width);
    sample.derivative *= width;
    return sample;
  };
  if (edge.ribbon.polynomial)
    side.ribbon.polynomial = spline::stretchOf(*edge.ribbon.polynomial, s.from, s.to);
  side.ribbon.breaks.clear();
  for (const CurveBreak& b : edge.ribbon.breaks)
    if (s.from < b.t && b.t < s.to)
      side.ribbon.breaks.push_back({(b.t - from) / width, b.continuity});
  if (edge.ribbon.hasSupport())
    side.ribbon.support = [support = edge.ribbon.support, from, width](double t) {
      return support(from + t * width);
    };
  side.stretches.clear();
  return side;
}

}  // namespace

EdgeChain chainEdges(const BoundaryLoop& loop, const std::vector<Stretch>& edges) {
  const std::vector<Link> links = linksOf(loop, edges);
  const auto curve = std::make_shared<const Curve>(links);
  EdgeChain chain{loop.sides[edges.front().edge], {}};
  chain.side.ribbon = {};
  chain.side.stretches.clear();
  chain.side.ribbon.curve = [curve](double s) { return curve->sample(s); };
  chain.side.ribbon.breaks = breaksOf(links, curve->length);
  for (const Link& link : links) {
    BoundarySide& side = chain.side;
    side.stretches.push_back({link.stretch.end, link.edge.continuityAt(0.5)});
    side.continuity = std::max(side.continuity, link.edge.continuity);
    side.supportDeviation = std::max(side.supportDeviation, link.edge.supportDeviation);
    if (link.edge.ribbon.hasSupport())
      side.ribbon.support = [curve](double s) { return curve->support(s); };
    addParts(link, curve->length, chain.stretches);
  }
  return chain;
}

EdgeChain sideOfStretches(const BoundaryLoop& loop,
                          const std::vector<Stretch>& stretches,
                          int mostPoles) {
  const BoundarySide& first = loop.sides[stretches.front().edge];
  const auto& polynomial = first.ribbon.polynomial;
  const bool keeps = !polynomial || polynomial->knots.poleCount() <= mostPoles;
  if (stretches.size() > 1 || !keeps) return chainEdges(loop, stretches);
  return {stretchOfEdge(first, stretches.front()), stretches};
}

}  // namespace fairing::boundary
