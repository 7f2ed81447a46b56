// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/star.h"

#include "core/layout/loop_picture.h"

namespace fairing::layout {
namespace {

using boundary::LoopPlace;

// Places of the roles asked for, as positions of the sides that start there.
std::vector<std::size_t> startsOf(const std::vector<CornerRole>& roles, CornerRole role) {
  std::vector<std::size_t> starts;
  for (std::size_t k = 0; k < roles.size(); ++k)
    if (roles[(k + roles.size() - 1) % roles.size()] == role) starts.push_back(k);
  return starts;
}

// Where the spoke between two corners (starts of sides) ends.
std::optional<LoopPlace> spokeBetween(const LoopLength& lengths,
                                      const std::vector<CornerRole>& roles,
                                      std::size_t from,
                                      std::size_t to) {
  const std::size_t n = roles.size();
  std::vector<std::size_t> splits;
  for (std::size_t k = (from + 1) % n; k != to; k = (k + 1) % n)
    if (roles[(k + n - 1) % n] == CornerRole::Split) splits.push_back(k);
  const double length = lengths.upTo(to) - lengths.upTo(from) + (to > from ? 0.0 : lengths.whole());
  return spokeEnd(lengths, splits, lengths.upTo(from) + 0.5 * length);
}

QuadMesh starMesh(const std::vector<Eigen::Vector2d>& picture) {
  QuadMesh mesh;
  const int n = static_cast<int>(picture.size()) / 2, centre = 2 * n;
  mesh.vertices = picture;
  mesh.vertices.emplace_back(Eigen::Vector2d::Zero());
  mesh.inside.assign(mesh.vertices.size(), 0);
  mesh.inside.back() = 1;
  for (int k = 0; k < n; ++k)
    mesh.quads.push_back(
        {{2 * k, 2 * k + 1, (2 * k + 2) % centre, centre}, {2 * k, 2 * k + 1, -1, -1}});
  return mesh;
}

}  // namespace

Result<LayoutPlan> starPlan(const boundary::BoundaryLoop& loop,
                            const std::vector<CornerRole>& roles) {
  const auto corners = startsOf(roles, CornerRole::Corner);
  const std::size_t n = corners.size();
  if (n < 3) return fail({.code = ErrorCode::WrongSideCount, .value = static_cast<double>(n)});
  const LoopLength lengths(loop);
  std::vector<LoopPlace> cuts;
  for (std::size_t k = 0; k < n; ++k) {
    const auto end = spokeBetween(lengths, roles, corners[(k + n - 1) % n], corners[k]);
    if (!end) return fail({.code = ErrorCode::LayoutUnfit, .detail = "star"});
    cuts.push_back(*end);
    cuts.push_back({corners[k], 0.0});
  }
  auto cut = boundary::cutLoop(loop, cuts, kMostPolesOfSeveral);
  if (!cut) return fail(cut.error());
  QuadMesh mesh = starMesh(pictureOf(cut->loop));
  return LayoutPlan{LayoutKind::Star, std::move(*cut), std::move(mesh)};
}

}  // namespace fairing::layout
