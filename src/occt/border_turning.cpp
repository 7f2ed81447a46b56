// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/border_turning.h"

#include <Eigen/Geometry>
#include <cmath>

namespace fairing::occt {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 16;  // along an edge

/// A place on the loop: where it goes, and the normal beside it.
struct Place {
  Vector3d tangent, normal;
};

std::vector<Place> placesAlong(const ShapeIndex& index, const BorderEdge& edge, Direction way) {
  const EdgeCurve curve(index.edge(edge.edge), way);
  const bool turned = edge.heading && *edge.heading != way;
  const EdgeSupport support(index.face(edge.support->face),
                            edge.support->edge,
                            edge.match,
                            turned ? NormalSense::Turned : NormalSense::AsFace);
  std::vector<Place> places;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = double(i) / kSamples;
    const auto beside = support.at(curve.parameter(t), curve.point(t));
    const Vector3d tangent = curve.at(t).derivative.normalized();
    if (!beside.singular && tangent.allFinite()) places.push_back({tangent, beside.normal});
  }
  return places;
}

double turn(const Place& from, const Place& to) {
  const Vector3d normal = (from.normal + to.normal).normalized();
  return std::atan2(normal.dot(from.tangent.cross(to.tangent)), from.tangent.dot(to.tangent));
}

}  // namespace

double turningAlong(const ShapeIndex& index,
                    const BorderGraph& graph,
                    const std::vector<LoopEdge>& loop) {
  std::vector<Place> places;
  for (const LoopEdge& e : loop) {
    const BorderEdge& edge = graph.edges()[std::size_t(e.border)];
    if (!edge.support) continue;
    const auto more = placesAlong(index, edge, e.direction);
    places.insert(places.end(), more.begin(), more.end());
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sum += turn(places[i], places[(i + 1) % places.size()]);
  }
  return sum;
}

}  // namespace fairing::occt
