// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/o_grid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/layout/loop_picture.h"
#include "core/spline/quadrature.h"

namespace fairing::layout {
namespace {

using boundary::BoundaryLoop;

// The inner patch is this large beside the loop.
constexpr double kInnerShare = 0.5;

// Length at which a smooth loop's long axis begins: the phase of the second harmonic of the squared
// distance to the centre, over the length. 0 for a circle.
double longAxis(const BoundaryLoop& loop, const LoopLength& lengths) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  constexpr int kSamples = 64;
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < kSamples; ++k) {
    const auto place = lengths.placeAt(lengths.whole() * k / kSamples);
    points.push_back(loop.sides[place.side].ribbon.curve(place.t).point);
    centre += points.back() / kSamples;
  }
  std::complex<double> harmonic = 0.0;
  double mean = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const double square = (points[static_cast<std::size_t>(k)] - centre).squaredNorm();
    mean += square / kSamples;
    harmonic += square / kSamples * std::polar(1.0, -4.0 * std::numbers::pi * k / kSamples);
  }
  constexpr double kRound = 1e-6;
  if (std::abs(harmonic) < kRound * mean) return 0.0;
  return std::arg(std::conj(harmonic)) / (4.0 * std::numbers::pi) * lengths.whole();
}

// Length at which a smooth loop bends much more sharply than on the whole; nothing where it does
// so nowhere. A seam ends there, lest one patch has to hold the bend in its middle.
std::optional<double> sharpestBend(const BoundaryLoop& loop, const LoopLength& lengths) {
  constexpr int kSamples = 128;
  constexpr double kSharp = 5.0;  // times the mean
  std::vector<Eigen::Vector3d> tangents;
  for (int k = 0; k < kSamples; ++k) {
    const auto place = lengths.placeAt(lengths.whole() * k / kSamples);
    tangents.push_back(loop.sides[place.side].ribbon.curve(place.t).derivative.normalized());
  }
  std::vector<double> turns;
  for (std::size_t k = 0; k < kSamples; ++k)
    turns.push_back((tangents[(k + 1) % kSamples] - tangents[k]).norm());
  const double mean = std::accumulate(turns.begin(), turns.end(), 0.0) / kSamples;
  const auto sharpest = std::max_element(turns.begin(), turns.end());
  if (*sharpest < kSharp * mean) return std::nullopt;
  const auto centre = static_cast<int>(sharpest - turns.begin());
  double weight = 0.0, sum = 0.0;  // the bend's centre of gravity, between the samples
  for (int d = -3; d <= 3; ++d) {
    const double turn = turns[static_cast<std::size_t>((centre + d + kSamples) % kSamples)];
    weight += turn;
    sum += turn * (centre + d + 0.5);
  }
  return sum / weight / kSamples * lengths.whole();
}

// Lengths at which the spokes end: the given places, and more in the widest gaps until there are
// four.
std::vector<double> spokeEnds(std::vector<double> given, double whole) {
  struct Gap {
    double from, length;
    int parts;
  };
  std::vector<Gap> gaps;
  std::sort(given.begin(), given.end());
  for (std::size_t k = 0; k < given.size(); ++k) {
    const double next = k + 1 < given.size() ? given[k + 1] : given[0] + whole;
    gaps.push_back({given[k], next - given[k], 1});
  }
  for (std::size_t have = given.size(); have < 4; ++have) {
    const auto widest = std::max_element(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
      return a.length / a.parts < b.length / b.parts;
    });
    ++widest->parts;
  }
  std::vector<double> ends;
  for (const Gap& gap : gaps)
    for (int k = 0; k < gap.parts; ++k) ends.push_back(gap.from + gap.length * k / gap.parts);
  return ends;
}

QuadMesh oGridMesh(const std::vector<Eigen::Vector2d>& picture) {
  QuadMesh mesh;
  mesh.vertices = picture;
  for (const Eigen::Vector2d& v : picture) mesh.vertices.emplace_back(kInnerShare * v);
  mesh.inside = {0, 0, 0, 0, 1, 1, 1, 1};
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    mesh.quads.push_back({{k, next, 4 + next, 4 + k}, {k, -1, -1, -1}});
  }
  mesh.quads.push_back({{4, 5, 6, 7}, {-1, -1, -1, -1}});
  return mesh;
}

}  // namespace

bool bendsSharply(const BoundaryLoop& loop) {
  return sharpestBend(loop, LoopLength(loop)).has_value();
}

Result<LayoutPlan> oGridPlan(const BoundaryLoop& loop, const std::vector<CornerRole>& roles) {
  const LoopLength lengths(loop);
  std::vector<double> places;
  for (std::size_t k = 0; k < roles.size(); ++k)
    if (roles[k] != CornerRole::Smooth)
      places.push_back(k + 1 == roles.size() ? 0.0 : lengths.upTo(k + 1));
  if (places.size() > 4) return fail({.code = ErrorCode::LayoutUnfit, .detail = "o-grid"});
  if (places.empty()) {
    const auto bend = sharpestBend(loop, lengths);
    const double start = bend ? *bend : longAxis(loop, lengths) + lengths.whole() / 8.0;
    places.push_back(start - lengths.whole() * std::floor(start / lengths.whole()));
  }
  std::vector<boundary::LoopPlace> cuts;
  for (const double length : spokeEnds(places, lengths.whole()))
    cuts.push_back(lengths.placeAt(length));
  auto cut = boundary::cutLoop(loop, cuts, kMostPolesOfSeveral);
  if (!cut) return fail(cut.error());
  QuadMesh mesh = oGridMesh(pictureOf(cut->loop));
  return LayoutPlan{LayoutKind::OGrid, std::move(*cut), std::move(mesh)};
}

}  // namespace fairing::layout
