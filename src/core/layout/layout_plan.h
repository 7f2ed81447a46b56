// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>

#include "core/boundary/cut_loop.h"
#include "core/layout/layout_kind.h"
#include "core/layout/quad_mesh.h"

namespace fairing::layout {

/// Sides with more control points are not taken over: those of a patch are the product of two, and
/// where several patches share them, they would multiply those of all.
inline constexpr int kMostPolesOfOne = 48, kMostPolesOfSeveral = 12;

/// Points on either side of a blend that belong together.
using MatchedPoints = std::array<Eigen::Vector3d, 2>;

/// How a loop is to be spanned: cut into sides that patch edges cover whole, and divided into
/// quads. Vertex j of the mesh is the start of side j; inner vertices follow.
struct LayoutPlan {
  LayoutKind kind = LayoutKind::Quad;
  boundary::CutLoop cut;
  QuadMesh mesh;
  bool closed = false;  ///< a strip of one patch whose East and West edges are one
  std::vector<MatchedPoints> matches = {};  ///< where a strip is cut, or starts
  Continuity inner = Continuity::G1;        ///< how patches meet each other where no crease runs
};

}  // namespace fairing::layout
